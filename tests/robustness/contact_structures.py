"""Decks of the contact matrix that are structures: plates on a beam, slender beams, the dry wall, end-notched flexure."""
import math

from contact_scenes import CONCRETE, STEEL, Case, contact, deck, rectangle, region, subdivision

SLENDER = ((100, 3), (200, 4), (200, 6), (400, 8))


def plates_on_beam(mesh, treatment, angle):
    """Two steel plates on a concrete beam of 400 x 100 mm that cracks, loads on the plates."""
    regions = [region("beam", "concrete", rectangle(0, 0, 400, 100)), region("left", "steel", rectangle(140, 100, 160, 108)),
               region("right", "steel", rectangle(240, 100, 260, 108))]
    law = {"type": "linear_softening", "tensile_strength": 2.9, "cohesion": 4.7, "friction_angle": 37, "fracture_energy": 0.1}
    return Case(f"plates_on_beam-{mesh}-{treatment}-{angle}", deck(
        f"Two plates on a beam, {angle} degrees", {"type": "polygons", "regions": regions, "subdivision": subdivision(mesh, 8)}, {
            "materials": {"concrete": CONCRETE, "steel": STEEL},
            "interfaces": {"concrete": {"between": ["concrete", "concrete"], "law": law},
                           "plates": {"between": ["steel", "concrete"], **contact(treatment, angle)}},
            "supports": {"left": {"at": [50, 0], "fix": "xy"}, "right": {"at": [350, 0], "fix": "y"}},
            "stages": [{"name": "bending", "loads": [{"type": "point_load", "at": [150, 108], "force": [0, -0.5]},
                                                     {"type": "point_load", "at": [250, 108], "force": [0, -0.5]}]}],
            "gauges": {"deflection": {"type": "displacement", "at": [200, 0], "direction": [0, -1]}},
            "path": {"stop": {"gauges": {"deflection": 0.1}}}}))


def slender_scene(mesh, columns, rows):
    """A beam of unit cells with a crack at mid-depth over 30 % of its length, at one end of it."""
    level = rows // 2
    cut = round(0.3 * columns)
    start = (columns - cut) // 2
    cells = {"type": "grid", "columns": columns, "rows": 1} if mesh == "quads" else subdivision(mesh, 1)
    if mesh == "quads":
        regions = [region("beam", "concrete", rectangle(0, j, columns, j + 1)) for j in range(rows)]
    else:
        regions = [region("beam", "concrete", rectangle(0, 0, columns, rows))]
    return {"type": "polygons", "regions": regions, "curves": {"crack": [[start, level], [start + cut, level]]},
            "subdivision": cells}


def slender(mesh, treatment, angle, cells=SLENDER[0]):
    """A slender beam in bending; its layers press on each other along the crack and slide."""
    columns, rows = cells
    return Case(f"slender_{columns}x{rows}-{mesh}-{treatment}-{angle}", deck(
        f"Slender beam of {columns} x {rows} with a closed crack, {angle} degrees", slender_scene(mesh, columns, rows), {
            "materials": {"concrete": CONCRETE}, "interfaces": {"crack": contact(treatment, angle)},
            "supports": {"left": {"at": [0, 0], "fix": "xy"}, "right": {"at": [columns, 0], "fix": "y"}},
            "stages": [{"name": "bending", "loads": [{"type": "point_load", "at": [columns / 2, rows], "force": [0, -1]}]}],
            "gauges": {"deflection": {"type": "displacement", "at": [columns / 2, 0], "direction": [0, -1]}},
            "path": {"stop": {"gauges": {"deflection": columns / 1000}}}}))


def brick_rows(rows=8, height=60):
    """(x0, x1, y0, y1, kind) of floor, rows of bricks in a running bond (44 in 8), and the beam that spreads the loads on top.

    Neighbours of any side are of different kinds, so that a pair of kinds is a joint and one kind is a brick's inside.
    """
    whole, staggered = [200 * i for i in range(6)], [0] + [100 + 200 * i for i in range(5)] + [1000]
    top = rows * height
    out = [(0, 1000, -height, 0, "floor"), (0, 1000, top, top + height, "top")]
    for row in range(rows):
        edges = staggered if row % 2 == 0 else whole
        kinds = ("a", "b") if row % 2 == 0 else ("c", "d")
        out += [(a, b, height * row, height * (row + 1), kinds[i % 2]) for i, (a, b) in enumerate(zip(edges, edges[1:]))]
    return out


def wall_joints(joint, last=("c", "d")):
    """The same joint everywhere; `last` are the kinds of the uppermost row."""
    pairs = [("a", "b"), ("c", "d"), ("a", "c"), ("a", "d"), ("b", "c"), ("b", "d"), ("floor", "a"), ("floor", "b")]
    pairs += [("top", kind) for kind in last]
    return {f"{one}_{other}": {"between": [one, other], **joint} for one, other in pairs}


WEDGING = 55  # degrees of friction beyond which bricks hold each other until they snap
AT_ENDS = ("lagrange", "augmented_lagrangian")  # treatments whose points are the ends of a side


def wall_limit(mesh, treatment, angle):
    """μN, or rocking about the last contact point of the foot: a Gauss point, or the corner for multipliers.

    Blocks cut from bricks have sides, and so last points, of their own: their rocking load is known to 5 %.
    """
    sliding = 30 * math.tan(math.radians(angle))
    arm = 500 if treatment in AT_ENDS or mesh != "given" else 500 - 50 * (1 - 1 / math.sqrt(3))
    rocking = 30 * arm / 480
    return (sliding, 30e-7) if sliding < rocking else (rocking, (1e-7 if mesh == "given" else 0.05) * rocking)


def dry_wall(mesh, treatment, angle, name=None):
    """44 bricks under 30 kN, pushed at the foot of its top beam until that has moved 4 mm; units kN and mm."""
    rows = brick_rows()
    scene = {"type": "polygons", "regions": [region("", kind, rectangle(a, c, b, d)) for a, b, c, d, kind in rows],
             "boundaries": {"foot": [[0, -60], [1000, -60]], "head": [[0, 540], [1000, 540]]},
             "subdivision": subdivision(mesh, 60)}
    corner = {"at": [0, 480], "inside": [0.1, 480.1]}
    brick = {"type": "linear_elastic", "young_modulus": 10, "poisson_ratio": 0.2}
    built = deck(f"Dry wall of 44 bricks, {angle:.6g} degrees", scene, {
        "materials": {kind: brick for kind in ("floor", "a", "b", "c", "d", "top")},
        "interfaces": wall_joints(contact(treatment, angle)), "supports": {"foot": {"boundary": "foot", "fix": "xy"}},
        "stages": [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "head", "traction": [0, -30 / (1000 * 100)]}]},
                   {"name": "pushed", "loads": [{"type": "point_load", **corner, "force": [1, 0]}]}],
        "gauges": {"drift": {"type": "displacement", **corner, "direction": [1, 0]}},
        "path": {"stop": {"gauges": {"drift": 4}}}})
    built.update(thickness=100, units={"length": "mm", "force": "kN"})
    snaps = angle > WEDGING
    return Case(f"dry_wall-{mesh}-{treatment}-{name or angle}", built, {"end": wall_limit(mesh, treatment, angle)}, None if snaps else 0)


def dry_wall_of_bricks(treatment, friction):
    """Bricks that are one block each, for a coefficient of friction."""
    return dry_wall("given", treatment, math.degrees(math.atan(friction)), f"tan_{friction}")


MORTAR = {"type": "linear_softening", "tensile_strength": 0.2, "cohesion": 0.3, "fracture_energy": 0.01,
          "shear_fracture_energy": 0.05}
# Its strength fades for ever: no joint is ever broken.
FADING_MORTAR = {"type": "exponential_softening", "tensile_strength": 0.414, "cohesion": 0.57, "fracture_energy": 0.0604,
                 "shear_fracture_energy": 0.1501}
# Cracks so suddenly that what has slid may slide back, and a path that followed it would come to no load at all. Which of
# many equal bricks slips first is decided by rounding: with some kernels of BLAS the wall slides to the goal, with others it
# comes to an equilibrium from which no rates lead on. Their peaks differ by 3e-5.
BRITTLE_MORTAR = {"type": "linear_softening", "tensile_strength": 0.364, "cohesion": 0.696, "fracture_energy": 0.0115,
                  "shear_fracture_energy": 0.0252}


def wall_of_mortar(rows, treatment, pressure, friction, mortar=None, name="mortar_wall"):
    """A wall of 1 m with joints of mortar, pressed, pushed at the foot of its top beam until that has moved 10 mm.

    What has lost its cohesion slides at N tan φ, or turns about the last contact point of its foot at N · arm / height.
    """
    top = 80 * rows
    scene = {"type": "polygons",
             "regions": [region("", kind, rectangle(a, c, b, d)) for a, b, c, d, kind in brick_rows(rows, 80)],
             "boundaries": {"foot": [[0, -80], [1000, -80]], "head": [[0, top + 80], [1000, top + 80]]},
             "subdivision": {"type": "given"}}
    law = {**(mortar or MORTAR), "friction_angle": math.degrees(math.atan(friction))}
    corner = {"at": [0, top], "inside": [0.1, top + 0.1]}
    brick = {"type": "linear_elastic", "young_modulus": 15000, "poisson_ratio": 0.2}
    built = deck(f"Wall of mortar joints, {rows} rows", scene, {
        "materials": {kind: CONCRETE if kind in ("floor", "top") else brick for kind in ("floor", "a", "b", "c", "d", "top")},
        "interfaces": wall_joints({"treatment": treatment, "law": law}, ("c", "d") if rows % 2 == 0 else ("a", "b")),
        "supports": {"foot": {"boundary": "foot", "fix": "xy"}},
        "stages": [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "head", "traction": [0, -pressure]}]},
                   {"name": "pushed", "loads": [{"type": "point_load", **corner, "force": [1000, 0]}]}],
        "gauges": {"drift": {"type": "displacement", **corner, "direction": [1, 0]}},
        "path": {"stop": {"load_below": 0, "gauges": {"drift": 10}}}, "record": {"fields_every": 0}})
    built.update(thickness=100)
    arm = 500 - 50 * (1 - 1 / math.sqrt(3))
    limit = 100 * pressure * min(friction, arm / top)
    return Case(f"{name}-{rows}_rows-{treatment}-{pressure}_MPa-tan_{friction}", built, {"end": (limit, 1e-5 * limit)})


def brittle_wall():
    wall = wall_of_mortar(12, "consistent", 0.808, 0.37, BRITTLE_MORTAR, "mortar_wall_brittle")
    wall.expected["peak"] = (40.541, 0.01)
    wall.may_stop = "no rates were found that keep the equilibrium"
    return wall


def flexure_peak(angle):
    """Beam theory of end-notched flexure: P² = 16 G E b² h³ / (9 a²) / (1 + 0.2 (E/G12)(h/a)² − (4/3) μ h/a) [N].

    The friction term (Carlsson, Gillespie, Pipes 1986) is of first order, so it is not asked for above 10 degrees.
    """
    half, crack, width, energy = 10, 25, 10, 0.5
    factor = 1 + 0.2 * 2.4 * (half / crack) ** 2 - 4 / 3 * math.tan(math.radians(angle)) * half / crack
    return math.sqrt(16 * energy * 30000 * width**2 * half**3 / (9 * crack**2) / factor)


def end_notched_flexure(mesh, treatment, angle):
    """A beam of 2 x 50 mm span whose mid-depth crack of 25 mm is closed and slides, then grows in shear."""
    scene = {"type": "polygons",
             "regions": [region("lower", "concrete", rectangle(-55, 0, 55, 10)), region("upper", "concrete", rectangle(-55, 10, 55, 20))],
             "curves": {"crack": [[-55, 10], [-25, 10]], "ligament": [[-25, 10], [55, 10]]}, "subdivision": subdivision(mesh, 2.5)}
    law = {"type": "linear_softening", "tensile_strength": 20, "cohesion": 40, "fracture_energy": 0.125,
           "shear_fracture_energy": 0.5, "friction_angle": angle}
    expected = {"peak": (flexure_peak(angle), 0.15 * flexure_peak(angle))} if angle <= 10 else {}
    return Case(f"end_notched_flexure-{mesh}-{treatment}-{angle}", deck(
        f"End-notched flexure, {angle} degrees on the crack", scene, {
            "materials": {"concrete": CONCRETE},
            "interfaces": {"crack": contact(treatment, angle), "ligament": {"law": law}},
            "supports": {"left": {"at": [-50, 0], "fix": "xy"}, "right": {"at": [50, 0], "fix": "y"}},
            "stages": [{"name": "bending", "loads": [{"type": "point_load", "at": [0, 20], "force": [0, -1]}]}],
            "gauges": {"deflection": {"type": "displacement", "at": [0, 0], "direction": [0, -1]}},
            "path": {"stop": {"gauges": {"deflection": 0.4}}}}), expected)
