"""Decks of the contact matrix: scenes in which bodies touch, with the answers that are known in closed form.

Every scene is a function of a mesh, a treatment of its contacts and a friction angle in degrees, and returns a `Case`.
What a deck does not need to say it leaves to the program's defaults.
"""
import math
from dataclasses import dataclass, field

MESHES = ("triangles", "quads", "voronoi")
TREATMENTS = ("consistent", "penalty", "lagrange", "augmented_lagrangian")
ANGLES = (0, 1, 5, 10, 30, 60)
CONCRETE = {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}
STEEL = {"type": "linear_elastic", "young_modulus": 205000, "poisson_ratio": 0.3}


@dataclass
class Case:
    """A deck and what is known about its run.

    `expected` holds {quantity: (value, tolerance)}; a quantity is `end` (load factor of the last row) or `peak`
    (the largest of all rows). `rejected` is the largest number of steps that may be rejected. A path that rounding leads
    one way or another may stop (exit 3) for a reason that holds `may_stop`; its end is not asked for then.
    """
    name: str
    deck: dict
    expected: dict = field(default_factory=dict)
    rejected: int | None = None
    may_stop: str = ""


def rectangle(x0, y0, x1, y1):
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def region(name, material, corners):
    return {"name": name, "material": material, "vertices": corners}


def subdivision(mesh, size):
    return {"type": "given"} if mesh == "given" else {"type": mesh, "size": size}


def contact(treatment, angle):
    return {"law": {"type": "friction", "friction_angle": angle}, "treatment": treatment}


def deck(title, scene, parts):
    """The sections that all scenes share; `parts` holds the others."""
    return {"title": title, "units": {"length": "mm", "force": "N"}, "scene": scene, "thickness": 10, "plane": "stress",
            **parts}


def pushed(angle, treatment, scene, unit):
    """Two blocks, the upper pressed by 600 N, then pushed by `unit` times the load factor."""
    return deck(f"Block pushed over a block, tan phi of {angle} degrees", scene, {
        "materials": {"below": CONCRETE, "above": CONCRETE},
        "interfaces": {"contact": {"between": ["below", "above"], **contact(treatment, angle)}},
        "supports": {"foot": {"boundary": "foot", "fix": "xy"}},
        "stages": [
            {"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "head", "traction": [0, -1]}]},
            {"name": "pushed", "loads": [{"type": "edge_traction", "boundary": "flank", "traction": [unit / 200, 0]}]}],
        "gauges": {"slip": {"type": "displacement", "at": [80, 70], "direction": [1, 0]}},
        "path": {"stop": {"gauges": {"slip": 0.1}}}})


def block_pushed(mesh, treatment, angle, unit=1.0):
    """A block of 60 x 20 mm on one of 100 x 50 mm, pressed by 600 N: slides at λ · unit = N tan φ."""
    scene = {"type": "polygons",
             "regions": [region("lower", "below", rectangle(0, 0, 100, 50)), region("upper", "above", rectangle(20, 50, 80, 70))],
             "boundaries": {"foot": [[0, 0], [100, 0]], "head": [[20, 70], [80, 70]], "flank": [[20, 50], [20, 70]]},
             "subdivision": subdivision(mesh, 10)}
    limit = 600 * math.tan(math.radians(angle)) / unit
    scaled = "" if unit == 1 else f"-unit_{unit:g}"
    return Case(f"block_pushed{scaled}-{mesh}-{treatment}-{angle}", pushed(angle, treatment, scene, unit),
                {"end": (limit, 600e-9 / unit * math.tan(math.radians(angle or 45)))}, 0)


def pressed(title, scene, law, force):
    """A body pressed on a block by a load that grows from zero, until it has settled by 0.02 mm."""
    return deck(title, scene, {
        "materials": {"concrete": CONCRETE, "steel": STEEL},
        "interfaces": {"contact": {"between": ["concrete", "steel"], **law}},
        "supports": {"foot": {"boundary": "foot", "fix": "xy"}},
        "stages": [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "head", "traction": force}]}],
        "gauges": {"settlement": {"type": "displacement", "at": [50, scene["boundaries"]["head"][0][1]], "direction": [0, -1]}},
        "path": {"stop": {"gauges": {"settlement": 0.02}}}})


def body_on_block(name, mesh, treatment, angle, body):
    """`body` is x0, x1, height of what stands on the block of 100 x 40 mm, and the size of its mesh."""
    x0, x1, height, size, force = body
    scene = {"type": "polygons",
             "regions": [region("block", "concrete", rectangle(0, 0, 100, 40)),
                         region("body", "steel", rectangle(x0, 40, x1, 40 + height))],
             "boundaries": {"foot": [[0, 0], [100, 0]], "head": [[x0, 40 + height], [x1, 40 + height]]},
             "subdivision": subdivision(mesh, size)}
    return Case(f"{name}-{mesh}-{treatment}-{angle}",
                pressed(f"{name}: load from zero, {angle} degrees", scene, contact(treatment, angle), force))


def block_pressed(mesh, treatment, angle):
    """A block of 60 x 40 mm on another: pressed from zero."""
    return body_on_block("block_pressed", mesh, treatment, angle, (20, 80, 40, 10, [0, -1]))


def plate_pressed(mesh, treatment, angle):
    """A plate of 20 x 5 mm on a block of 100 x 40 mm: pressed from zero."""
    return body_on_block("plate_pressed", mesh, treatment, angle, (40, 60, 5, 5, [0, -1]))


def plate_inclined(mesh, treatment, angle):
    """The same, the load leaning by a tenth: friction carries it from the first newton on, from 5.8 degrees up."""
    return body_on_block("plate_inclined", mesh, treatment, angle, (40, 60, 5, 5, [0.1, -1]))
