"""Decks of bodies that move without a path: m, N, s; blocks of stone, 1 m thick."""

import math

GRAVITY = 9.81
STONE = {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2, "density": 2500}


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def turned(vertices, about, angle):
    """The polygon turned counter-clockwise."""
    c, s = math.cos(angle), math.sin(angle)
    return [[about[0] + c * (x - about[0]) - s * (y - about[1]), about[1] + s * (x - about[0]) + c * (y - about[1])]
            for x, y in vertices]


def gauge(at, direction):
    return {"type": "displacement", "at": list(at), "direction": list(direction)}


def scene(bodies, gravity=(0, -GRAVITY), friction=0.5, gauges=None, **motion):
    """bodies: name → vertices, each a block; `ground` stands still, what touches meets with the friction given."""
    regions = [{"name": name, "material": name if name == "ground" else "stone", "vertices": vertices}
               for name, vertices in bodies.items()]
    law = {"type": "friction", "friction_angle": math.degrees(math.atan(friction))}
    deck = {"units": {"length": "m", "force": "N"},
            "scene": {"type": "polygons", "regions": regions},
            "thickness": 1,
            "materials": {"stone": dict(STONE), "ground": dict(STONE)},
            "interfaces": {"joints": {"between": ["stone", "stone"], "law": law},
                           "bed": {"between": ["stone", "ground"], "law": law}},
            "motion": {"gravity": list(gravity), "held": ["ground"], "contact": {"friction": friction}} | motion}
    if gauges:
        deck["gauges"] = {name: gauge(*of) for name, of in gauges.items()}
    return deck


def inclined(degrees):
    """Gravity where the ground is the x axis of a plane that falls to the right."""
    angle = math.radians(degrees)
    return GRAVITY * math.sin(angle), -GRAVITY * math.cos(angle)
