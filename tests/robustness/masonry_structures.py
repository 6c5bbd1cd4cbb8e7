"""Decks of the contact matrix that are masonry: voussoir arches and triliths whose joints bear no tension.

All are of blocks that only touch, held on blocks that do not move. Their weight comes first, then a load grows until hinges
have made a mechanism of them; from there on it stays, because displacements are small. What it is then is the solution of
a linear program for rigid blocks (`limit_analysis.py`), which touch at the points of the treatment's joints.
"""
import math

from contact_scenes import CONCRETE, Case, deck, rectangle, region
from limit_analysis import collapse_factor, decided_by_hinges, weight, wrench

ARCHES = ((9, 75), (15, 60), (21, 60), (12, 80))  # voussoirs, thickness of the arch [mm]
TRILITHS = (400, 800)  # height of the posts [mm]
RADIUS = 500  # of the arch's middle line [mm]
HALF_OPENING = math.radians(60)
FRICTION = 0.75
DENSITY = 2.4e-5  # weight per volume [N/mm³]
DEPTH = 10  # across the plane [mm], as in `deck`
TOLERANCE = 1e-6  # of the collapse load


def places(treatment):
    """Where a treatment's joints have their points unless a deck says otherwise."""
    return "vertices" if treatment in ("lagrange", "augmented_lagrangian") else "gauss"


def masonry(name, title, treatment, parts):
    """The case of `blocks`, pairs of a material and corners; `feet` are the boundaries at which it is held."""
    blocks, feet, live, gauge = parts["blocks"], parts["feet"], parts["live"], parts["gauge"]
    kinds = sorted({kind for kind, _ in blocks})
    law = {"type": "friction", "friction_angle": math.degrees(math.atan(FRICTION))}
    scene = {"type": "polygons", "regions": [region("", kind, corners) for kind, corners in blocks],
             "boundaries": feet, "subdivision": {"type": "given"}}
    pairs = [(one, other) for i, one in enumerate(kinds) for other in kinds[i + 1:]]
    own = {"type": "body_force", "force": [0, -DENSITY], "materials": [kind for kind in kinds if kind != "foot"]}
    built = deck(title, scene, {
        "materials": {kind: CONCRETE for kind in kinds},
        "interfaces": {"_".join(pair): {"between": list(pair), "law": law, "treatment": treatment} for pair in pairs},
        "supports": {foot: {"boundary": foot, "fix": "xy"} for foot in feet},
        "stages": [{"name": "weight", "loads": [own]}, {"name": "collapse", "loads": [live]}],
        "gauges": {"drift": gauge}, "path": {"stop": {"gauges": {"drift": 1}}}})
    factor = limit(blocks, live, treatment)
    return Case(name, built, {"peak": (factor, TOLERANCE * factor), "end": (factor, TOLERANCE * factor)})


def limit(blocks, live, treatment):
    """The load factor of collapse of a deck's blocks under a deck's load; hinges must decide it."""
    shapes = [corners for _, corners in blocks]
    held = {i for i, (kind, _) in enumerate(blocks) if kind == "foot"}
    dead = [weight(corners, (0, -DENSITY), DEPTH) for corners in shapes]
    if live["type"] == "body_force":
        grows = [weight(corners, live["force"], DEPTH) for corners in shapes]
    else:
        struck = next(i for i, corners in enumerate(shapes) if inside(corners, live["inside"]))
        grows = [wrench(live["force"] if i == struck else (0, 0), live["at"]) for i in range(len(shapes))]
    problem = (shapes, held, (dead, grows), FRICTION, places(treatment))
    if not decided_by_hinges(*problem):
        raise ValueError("these blocks slide before hinges make a mechanism of them: the linear program is no oracle")
    return collapse_factor(*problem)


def inside(corners, point):
    """Whether a point is inside a convex polygon given anticlockwise."""
    return all((bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax) > 0
               for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]))


def arch_blocks(voussoirs, thickness):
    """Voussoirs of alternate kinds from right to left, between two skewbacks; the material and corners of each."""
    step = 2 * HALF_OPENING / voussoirs
    angles = [math.pi / 2 - HALF_OPENING + k * step for k in range(-1, voussoirs + 2)]
    rays = [(math.cos(angle), math.sin(angle)) for angle in angles]
    inner, outer = RADIUS - thickness / 2, RADIUS + thickness / 2
    shapes = [[[inner * x0, inner * y0], [outer * x0, outer * y0], [outer * x1, outer * y1], [inner * x1, inner * y1]]
              for (x0, y0), (x1, y1) in zip(rays, rays[1:])]
    kinds = ["foot", *("ab"[k % 2] for k in range(voussoirs)), "foot"]
    return list(zip(kinds, shapes))


def middle(points):
    return [sum(coordinate) / len(points) for coordinate in zip(*points)]


def arch(name, voussoirs, thickness, treatment, live):
    """An arch on its two skewbacks under `live`, a function of its blocks; the gauge follows a voussoir off the crown."""
    blocks = arch_blocks(voussoirs, thickness)
    seats = {"right": blocks[0][1][:2], "left": blocks[-1][1][2:]}
    place = middle(off_crown(blocks))
    load, direction = live(place)
    title = f"Arch of {voussoirs} voussoirs of {thickness} mm"
    return masonry(f"{name}-{voussoirs}x{thickness}-{treatment}", title, treatment, {
        "blocks": blocks, "feet": seats, "live": load,
        "gauge": {"type": "displacement", "at": place, "direction": direction}})


def off_crown(blocks):
    """The voussoir a quarter of the arch from its right end."""
    return blocks[1 + (len(blocks) - 2) // 4][1]


def arch_loaded(voussoirs, thickness, treatment):
    """A load of λ newtons on a voussoir at the quarter of the arch: four hinges."""
    return arch("arch_loaded", voussoirs, thickness, treatment, lambda place: (
        {"type": "point_load", "at": place, "inside": place, "force": [0, -1]}, [0, -1]))


def arch_leaning(voussoirs, thickness, treatment):
    """A horizontal body force of λ times the weight, as when the ground is tilted by atan λ."""
    return arch("arch_leaning", voussoirs, thickness, treatment, lambda _: (
        {"type": "body_force", "force": [DENSITY, 0], "materials": ["a", "b"]}, [1, 0]))


def rocking_trilith(height, treatment):
    """λ at which both posts turn about the toe [1/N]: F λ h = 2a (P + L).

    P and L are the weights of a post and of the lintel, F the unit load, h the height of a post, and 2a the distance of the
    outermost contact points of its foot: the lintel, which stays level, rises as the post's far corner does, by 2a θ.
    """
    arm = 100 if places(treatment) == "vertices" else 100 / math.sqrt(3)
    return arm * DENSITY * DEPTH * (100 * height + 600 * 100) / height


def trilith(height, treatment):
    """Two posts of 100 mm and a lintel of 600 x 100 mm on them, pushed sideways with λ newtons at its lower corner."""
    blocks = [("foot", rectangle(-50, -50, 650, 0)), ("a", rectangle(0, 0, 100, height)),
              ("a", rectangle(500, 0, 600, height)), ("b", rectangle(0, height, 600, height + 100))]
    corner = {"at": [0, height], "inside": [1, height + 1]}
    case = masonry(f"trilith-{height}-{treatment}", f"Trilith with posts of {height} mm", treatment, {
        "blocks": blocks, "feet": {"foot": [[-50, -50], [650, -50]]},
        "live": {"type": "point_load", **corner, "force": [1, 0]},
        "gauge": {"type": "displacement", **corner, "direction": [1, 0]}})
    factor = rocking_trilith(height, treatment)
    return Case(case.name, case.deck, {name: (factor, TOLERANCE * factor) for name in case.expected})


def wall_with_door():
    """Two piers of dry bricks in English bond under a lintel, pressed, pushed by 10 mm to one side and to the other.

    Limit analysis of its 162 blocks bears 45 074.8 N at most; friction has a small part in it, so that less may be borne.
    """
    width, height, pressure, weight_of_bricks = 2.4, 1.92, 2e5, 1800 * 9.81
    head = [[0, height], [0, height + 0.24]]
    joint = {"law": {"type": "friction", "friction_angle": 33}, "points": "vertices"}
    scene = {"regions": [{**region("footing", "concrete", rectangle(-0.2, -0.2, width + 0.2, 0)), "undivided": True},
                         region("left", "brick", rectangle(0, 0, 0.72, height)),
                         region("right", "brick", rectangle(1.68, 0, width, height)),
                         {**region("lintel", "concrete", rectangle(0, height, width, height + 0.24)), "undivided": True}],
             "boundaries": {"ground": [[-0.2, -0.2], [width + 0.2, -0.2]], "top": [[width, height + 0.24], [0, height + 0.24]]},
             "subdivision": {"type": "bricks", "length": 0.24, "height": 0.12, "bond": "english"}}
    built = deck("Wall with a door", scene, {
        "materials": {"brick": {"type": "linear_elastic", "young_modulus": 4e9, "poisson_ratio": 0.15},
                      "concrete": {"type": "linear_elastic", "young_modulus": 3e10, "poisson_ratio": 0.2}},
        "interfaces": {"joints": {"between": ["brick", "brick"], **joint}, "beds": {"between": ["brick", "concrete"], **joint}},
        "supports": {"ground": {"boundary": "ground", "fix": "xy"}},
        "stages": [{"name": "weight", "loads": [
            {"type": "body_force", "regions": ["left", "right"], "force": [0, -weight_of_bricks]},
            {"type": "edge_traction", "boundary": "top", "traction": [0, -pressure]}]},
            {"name": "forth", "loads": [{"type": "point_load", "over": head, "force": [1, 0]}], "until": {"drift": 0.01}},
            {"name": "back", "until": {"drift": -0.01}, "unload": True}],
        "gauges": {"drift": {"type": "displacement", "over": head, "direction": [1, 0]}}, "path": {}})
    built.update(units={"length": "m", "force": "N"}, thickness=0.24)
    borne, share = 45074.8, 0.002
    return Case("wall_with_door", built, {"peak": (borne, share * borne), "end": (-borne, share * borne)})
