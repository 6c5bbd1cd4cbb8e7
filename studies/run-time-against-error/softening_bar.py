"""F1: a bar with one cohesive interface across it, the halves cut into blocks; the whole path in closed form.

    u(σ) = σ L/E + w_c (1 − σ/ft) after the peak ft A,     w_c = 2 Gf/ft

L = 100 mm, A = 100 × 100 mm², ν = 0: the stress is uniform, so that blocks of any shape can carry it exactly.
"""

import blocks

NAME = "softening-bar"
TITLE = "F1, softening bar: whole path"
LENGTH, HEIGHT, THICKNESS, YOUNG, STRENGTH, ENERGY = 100, 100, 100, 30000, 3, 0.1
CRITICAL = 2 * ENERGY / STRENGTH  # w_c

# Rows of blocks through the height; Voronoi cells have the area of as many squares.
SIZES = {"triangles": (2, 4, 8), "quads": (2, 4, 8), "voronoi": (4, 8, 16)}


def scene_of(polygons, subdivision):
    return {"regions": blocks.regions(polygons), "subdivision": subdivision,
            "curves": {"crack": [[0, 0], [0, HEIGHT]]},
            "boundaries": {"left": [[-LENGTH / 2, 0], [-LENGTH / 2, HEIGHT]],
                           "right": [[LENGTH / 2, 0], [LENGTH / 2, HEIGHT]]}}


def grid(rows, shape):
    half = [blocks.rectangle(0, 0, LENGTH / 2, HEIGHT)]
    columns = max(1, rows // 2)
    return scene_of(blocks.mirrored(half, 0), {"type": "grid", "columns": columns, "rows": rows, "shape": shape})


def voronoi(rows):
    cells = blocks.voronoi(blocks.rectangle(0, 0, LENGTH / 2, HEIGHT), HEIGHT / rows)
    return scene_of(blocks.mirrored(cells, 0), {"type": "given"})


SCENES = {"triangles": lambda rows: grid(rows, "triangles"), "quads": lambda rows: grid(rows, "quads"),
          "voronoi": voronoi}


def deck(scene, treatment):
    """Guided at places that are no corner of a block."""
    law = {"type": "linear_softening", "tensile_strength": STRENGTH, "fracture_energy": ENERGY}
    left, right, middle = [-26.1, 51.3], [26.1, 51.3], 50.7
    return {
        "title": TITLE,
        "scene": scene,
        "thickness": THICKNESS,
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": YOUNG, "poisson_ratio": 0}},
        "interfaces": {"crack": {"law": law, "treatment": treatment, "points": "midpoint"},
                       "bulk": {"between": ["concrete", "concrete"], "treatment": treatment}},
        "supports": {"wall": {"boundary": "left", "fix": "x"},
                     "guide_left": {"at": left, "fix": "y"}, "guide_right": {"at": right, "fix": "y"},
                     "no_turn_left": {"at": left, "fix": "rotation"},
                     "no_turn_right": {"at": right, "fix": "rotation"}},
        "stages": [{"loads": [{"type": "edge_traction", "boundary": "right", "traction": [1, 0]}]}],
        "gauges": {"elongation": {"type": "relative_displacement", "from": [-LENGTH / 2, middle],
                                  "to": [LENGTH / 2, middle], "direction": [1, 0]}},
        "path": {"stop": {"load_below": 0.02}},
    }


def error(run):
    """The largest u − u(σ) along the path, in units of w_c, signed."""
    summary, rows = run.summary, run.curve.to_dict("records")
    if not rows[-1]["load"] < 0.03 * summary["peak"]["load"]:
        raise ValueError("the path was not followed to its end")
    deviations = []
    for row in rows:
        share = row["load"] / (STRENGTH * HEIGHT * THICKNESS)
        crack = CRITICAL * (1 - share) if row["step"] > summary["peak"]["step"] else 0
        deviations.append((row["elongation"] - share * STRENGTH * LENGTH / YOUNG - crack) / CRITICAL)
    return max(deviations, key=abs)
