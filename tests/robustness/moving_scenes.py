"""Random scenes of bodies in motion: convex and not, slivers, any friction, restitution and step, thrown into a box.

    scene_of(seed)    the deck, and what is special about it as text
"""

import math
import random

GRAVITY = 9.81
STONE = {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2, "density": 2500}


def convex(rng, size):
    """3 to 8 corners on an ellipse, sometimes a narrow one."""
    corners, narrow = rng.randint(3, 8), rng.choice((1, 1, 1, 0.5, 0.1))
    angles = [2 * math.pi * (k + 0.35 * rng.uniform(-1, 1)) / corners for k in range(corners)]
    return [[size * math.cos(a), narrow * size * math.sin(a)] for a in angles]


def angle_iron(rng, size):
    t = rng.uniform(0.2, 0.5) * size
    return [[-size, -size], [size, -size], [size, -size + t], [-size + t, -size + t], [-size + t, size], [-size, size]]


def channel(rng, size):
    t = rng.uniform(0.3, 0.6) * size
    return [[-size, -size], [size, -size], [size, size], [size - t, size], [size - t, -size + t], [-size + t, -size + t],
            [-size + t, size], [-size, size]]


def star(rng, size):
    corners = rng.randint(4, 6)
    out = []
    for k in range(2 * corners):
        radius = size * (1 if k % 2 == 0 else rng.uniform(0.45, 0.7))
        out.append([radius * math.cos(math.pi * k / corners), radius * math.sin(math.pi * k / corners)])
    return out


SHAPES = (convex, convex, convex, angle_iron, channel, star)


def placed(vertices, at, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [[at[0] + c * x - s * y, at[1] + s * x + c * y] for x, y in vertices]


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def scene_of(seed):
    """Bodies in a grid of cells above a tub, each within its cell, so that none overlaps another at the start."""
    rng = random.Random(seed)
    columns, rows, cell = rng.randint(1, 4), rng.randint(1, 6), 1.0
    half = columns * cell / 2 + 0.2
    regions = [{"name": name, "material": "ground", "vertices": vertices}
               for name, vertices in (("floor", box(-half - 1, -1, half + 1, 0)), ("left", box(-half - 1, 0.01, -half, 9)),
                                      ("right", box(half, 0.01, half + 1, 9)))]
    thrown = []
    for i in range(columns):
        for j in range(rows):
            at = (-columns * cell / 2 + (i + 0.5) * cell, 0.6 + j * cell)
            shape = rng.choice(SHAPES)(rng, rng.uniform(0.12, 0.34))
            name = f"stone {len(thrown) + 1}"
            regions.append({"name": name, "material": "stone", "vertices": placed(shape, at, rng.uniform(0, 2 * math.pi))})
            thrown.append({"regions": [name], "velocity": [rng.uniform(-5, 5), rng.uniform(-5, 2)],
                           "spin": rng.uniform(-8, 8)})
    friction = rng.choice((0.0, rng.uniform(0, 1.5), rng.uniform(0, 1.5)))
    restitution = rng.choice((0.0, 0.0, rng.uniform(0, 1)))
    step = 10 ** rng.uniform(-3, -1)
    deck = {"title": f"random motion {seed}", "units": {"length": "m", "force": "N"},
            "scene": {"type": "polygons", "regions": regions}, "thickness": 1,
            "materials": {"stone": dict(STONE), "ground": dict(STONE)},
            "motion": {"time": 6 if step > 3e-3 else 1.5, "gravity": [0, -GRAVITY], "held": ["floor", "left", "right"],
                       "velocities": thrown, "step": step, "frame_every": 0.1,
                       "contact": {"friction": friction, "restitution": restitution}}}
    return deck, (f"{len(thrown)} bodies, friction {friction:.2f}, restitution {restitution:.2f}, step {step:.1e}")
