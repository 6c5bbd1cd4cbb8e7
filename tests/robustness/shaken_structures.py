"""Random dry columns, portals and walls of blocks on a ground that swings, as decks; see README.md."""

import math
import random

GRAVITY = 9.81


def _box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def _columns(rng):
    for column in range(rng.randint(1, 3)):
        left, breadth, low = 3.0 * column, rng.uniform(0.3, 0.9), 0.0
        for drum in range(rng.randint(1, 6)):
            high = low + rng.uniform(0.4, 1.4)
            yield f"column {column + 1}, drum {drum + 1}", _box(left, low, left + breadth, high)
            low = high


def _portal(rng):
    breadth, height, drums, span = rng.uniform(0.4, 0.8), rng.uniform(0.5, 1.2), rng.randint(1, 4), rng.uniform(1.5, 3)
    for side, left in (("left", 0.0), ("right", span)):
        for i in range(drums):
            yield f"{side} {i + 1}", _box(left, i * height, left + breadth, (i + 1) * height)
    yield "lintel", _box(0, drums * height, span + breadth, drums * height + rng.uniform(0.3, 0.6))


def _wall(rng):
    length, courses, bricks = rng.uniform(0.4, 0.6), rng.randint(3, 7), rng.randint(3, 5)
    height = length * rng.uniform(0.4, 0.6)
    for course in range(courses):
        joints = [length * (i + 0.5 * (course % 2)) for i in range(bricks)]
        ends = sorted({0.0, *joints, length * bricks})
        for brick, (left, right) in enumerate(zip(ends, ends[1:])):
            yield f"course {course + 1}, brick {brick + 1}", _box(left, course * height, right, (course + 1) * height)


STRUCTURES = {"columns": _columns, "portal": _portal, "wall": _wall}


def scene_of(seed):
    """A structure that stands, and 5 s of a ground that swings with 0.1 to 0.7 g at 0.8 to 4 Hz; what is special about it."""
    rng = random.Random(seed)
    kind = rng.choice(list(STRUCTURES))
    blocks = list(STRUCTURES[kind](rng))
    frequency, acceleration = rng.uniform(0.8, 4), rng.uniform(1, 7)
    friction, young = rng.uniform(0.3, 0.9), 10 ** rng.uniform(9, 11.5)
    stone = {"type": "linear_elastic", "young_modulus": young, "poisson_ratio": 0.2, "density": 2700}
    law = {"type": "friction", "friction_angle": math.degrees(math.atan(friction))}
    swing = {"type": "harmonic", "amplitude": acceleration / (2 * math.pi * frequency) ** 2, "frequency": frequency}
    deck = {"title": f"shaken {kind} {seed}", "units": {"length": "m", "force": "N"},
            "scene": {"type": "polygons", "regions": [
                {"name": "ground", "material": "rock", "vertices": _box(-4, -0.5, 12, 0)},
                *({"name": name, "material": "stone", "vertices": vertices} for name, vertices in blocks)]},
            "thickness": 1, "materials": {"rock": stone, "stone": stone},
            "interfaces": {"joints": {"between": ["stone", "stone"], "law": law}, "foot": {"between": ["stone", "rock"], "law": law}},
            "motion": {"time": 5, "gravity": [0, -GRAVITY], "held": ["ground"], "contact": {"friction": friction},
                       "driven": [{"regions": ["ground"], "direction": [1, 0], "displacement": swing}]}}
    return deck, f"{kind} of {len(blocks)} blocks, {acceleration / GRAVITY:.2f} g at {frequency:.1f} Hz, friction {friction:.2f}, E {young:.1e}"
