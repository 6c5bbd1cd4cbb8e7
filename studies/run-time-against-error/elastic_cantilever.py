"""E2: the intact cantilever with the exact field of Timoshenko and Goodier, plane stress, y from the axis.

    u = −P y/(6 E I) [(6 L − 3 x) x + (2 + ν)(y² − H²/4)]
    v =  P/(6 E I) [3 ν y² (L − x) + (4 + 5 ν) H² x/4 + (3 L − x) x²]
    σx = −P (L − x) y/I,   σy = 0,   τxy = P/(2 I) (H²/4 − y²),   I = t H³/12

Both ends carry the exact tractions as point loads at two Gauss points per side, which integrate them exactly; springs
at the same points of the clamp are driven to the exact displacement. Source: Theory of Elasticity, §21.
"""

import numpy as np

import blocks

NAME = "elastic-cantilever"
TITLE = "E2, elastic cantilever: displacement in L2"
LENGTH, HEIGHT, THICKNESS, YOUNG, POISSON, SHEAR = 400.0, 100.0, 100.0, 27500.0, 0.2, 1000.0
INERTIA = THICKNESS * HEIGHT**3 / 12
OUTLINE = blocks.rectangle(0, -HEIGHT / 2, LENGTH, HEIGHT / 2)

# Rows of blocks through the height; Voronoi cells have the area of as many squares.
SIZES = {"triangles": (2, 4, 8, 16, 24, 32), "quads": (4, 8, 16, 24, 32, 40), "voronoi": (4, 8, 16, 24, 32, 40)}


SECOND_ORDER_SIZES = {"triangles": (1, 2, 4, 8, 16), "quads": (1, 2, 4, 8, 16), "voronoi": (2, 4, 8, 16)}  # of blocks of second order


def displacement(x, y):
    h2 = HEIGHT**2
    scale = SHEAR / (6 * YOUNG * INERTIA)
    u = -y * ((6 * LENGTH - 3 * x) * x + (2 + POISSON) * (y * y - h2 / 4))
    v = (3 * POISSON * y * y * (LENGTH - x) + (4 + 5 * POISSON) * h2 * x / 4 + (3 * LENGTH - x) * x * x)
    return scale * u, scale * v


def traction(x, y):
    """σ n on the ends: outward normal −x at x = 0, +x at x = L."""
    sign = -1 if x == 0 else 1
    normal = -SHEAR * (LENGTH - x) * y / INERTIA
    shear = SHEAR / (2 * INERTIA) * (HEIGHT**2 / 4 - y * y)
    return [sign * normal, sign * shear]


def grid(rows, shape):
    heights = np.linspace(-HEIGHT / 2, HEIGHT / 2, rows + 1)
    scene = {"regions": blocks.regions([OUTLINE]),
             "subdivision": {"type": "grid", "columns": 4 * rows, "rows": rows, "shape": shape}}
    return scene | {"ends": {0.0: heights, LENGTH: heights}}


def voronoi(rows):
    cells = blocks.voronoi(OUTLINE, HEIGHT / rows)
    ends = {x: np.unique([q for cell in cells for p, q in cell if p == x]) for x in (0.0, LENGTH)}
    return {"regions": blocks.regions(cells), "subdivision": {"type": "given"}, "ends": ends}


SCENES = {"triangles": lambda rows: grid(rows, "triangles"), "quads": lambda rows: grid(rows, "quads"),
          "voronoi": voronoi}


def gauss_points(heights):
    """(y, weight) of two points per side."""
    for low, high in zip(heights[:-1], heights[1:]):
        for sign in (-1, 1):
            yield (low + high) / 2 + sign * (high - low) / (2 * np.sqrt(3)), (high - low) / 2


def loads(ends):
    out = []
    for x, heights in ends.items():
        for y, weight in gauss_points(heights):
            force = [weight * THICKNESS * part for part in traction(x, y)]
            out.append({"type": "point_load", "at": [x, y], "force": force})
    for y, _ in gauss_points(ends[0.0]):
        for direction, moved in zip(([1, 0], [0, 1]), displacement(0.0, y)):
            out.append({"type": "prescribed_displacement", "at": [0.0, y], "direction": direction,
                        "displacement": moved})
    return out


def deck(scene, treatment):
    """The support lies where the exact displacement is zero."""
    return {
        "title": TITLE,
        "scene": {name: value for name, value in scene.items() if name != "ends"},
        "thickness": THICKNESS,
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": YOUNG, "poisson_ratio": POISSON}},
        "interfaces": {"bulk": {"between": ["concrete", "concrete"], "treatment": treatment}},
        "supports": {"axis": {"at": [0, 0], "fix": "xy"}},
        "stages": [{"loads": loads(scene["ends"])}],
        "path": {"control": "load", "stop": {"after_steps": 1}},
    }


def radon():
    """Barycentric coordinates and weights of a rule of degree five on a triangle: seven points."""
    root = np.sqrt(15)
    points, weights = [[1 / 3] * 3], [9 / 40]
    for b, w in (((6 - root) / 21, (155 - root) / 1200), ((6 + root) / 21, (155 + root) / 1200)):
        points += [[1 - 2 * b if i == corner else b for i in range(3)] for corner in range(3)]
        weights += [w] * 3
    return np.array(points), np.array(weights)


def monomials(x, y, degree):
    """1, x, y and of degree two x², x y, y²; the last axis is theirs."""
    linear = [np.ones_like(x), x, y]
    return np.stack(linear + [x * x, x * y, y * y] if degree == 2 else linear, axis=-1)


def polynomial(vertices, moved, degree):
    """u(x) of one block as a function of places, from the vertices of its outline (and the middles of its sides)."""
    centre = vertices.mean(axis=0)
    of_vertices = monomials(*(vertices - centre).T, degree)
    factors = np.linalg.lstsq(of_vertices, moved, rcond=None)[0]
    return lambda at: monomials(*np.moveaxis(at - centre, -1, 0), degree) @ factors


def error(run):
    """‖u_h − u‖/‖u‖ over the blocks, L2, for a load factor of 1."""
    fields = run.fields()
    if fields.load_factor == 0:
        raise ValueError("no solution")
    moved = fields.vertices[["displacement_x", "displacement_y"]].to_numpy() / fields.load_factor
    points, weights = radon()
    degree = 2 if "strain_gradient_xx_x" in fields.blocks else 1
    wrong = total = 0
    for a, moves in zip(fields.mesh.polygons, fields.mesh.by_block(moved)):
        b, c = np.roll(a, -1, axis=0), a.mean(axis=0)
        areas = 0.5 * ((a[:, 0] - c[0]) * (b[:, 1] - c[1]) - (a[:, 1] - c[1]) * (b[:, 0] - c[0]))
        at = points[:, :1] * c + points[:, 1:2] * a[:, None] + points[:, 2:] * b[:, None]
        share = areas[:, None] * weights
        exact = np.stack(displacement(at[..., 0], at[..., 1]), axis=-1)
        found = polynomial(a, moves, degree)(at)
        wrong += np.sum(share * np.sum((found - exact) ** 2, axis=-1))
        total += np.sum(share * np.sum(exact**2, axis=-1))
    return float(np.sqrt(wrong / total))
