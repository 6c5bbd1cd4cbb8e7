"""Scenes that both integrators run: m, N, s; blocks of stone, 1 m thick. Each gives rows of what was found."""

import math

import numpy as np

GRAVITY = 9.81
DENSITY, MODULUS, POISSON = 2500, 1e10, 0.2
STONE = {"type": "linear_elastic", "young_modulus": MODULUS, "poisson_ratio": POISSON, "density": DENSITY}
FLOOR = [[-10, -1], [30, -1], [30, 0], [-10, 0]]
FREE_FLIGHT = "free_flight"
OFFSET = 1e-3  # s, the default of `motion.contact.offset`, in sizes of the smallest block


def classic(**parameters):
    return {"type": "classic", **parameters}


def name_of(integrator):
    """As a table has it: the name, and what is not its default."""
    if isinstance(integrator, str):
        return integrator
    told = ", ".join(f"{key} {value:g}" if isinstance(value, (int, float)) else f"{key} {value}"
                     for key, value in integrator.items() if key != "type")
    return f"classic, {told}" if told else "classic"


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def scene(bodies, gravity=(0, -GRAVITY), friction=0.5, gauges=None, **motion):
    """bodies: name → vertices, each a block; `ground` stands still."""
    regions = [{"name": name, "material": "ground" if name == "ground" else "stone", "vertices": vertices}
               for name, vertices in bodies.items()]
    law = {"type": "friction", "friction_angle": math.degrees(math.atan(friction))}
    deck = {"units": {"length": "m", "force": "N"}, "scene": {"type": "polygons", "regions": regions}, "thickness": 1,
            "materials": {"stone": dict(STONE), "ground": dict(STONE)},
            "interfaces": {"joints": {"between": ["stone", "stone"], "law": law},
                           "bed": {"between": ["stone", "ground"], "law": law}},
            "motion": {"gravity": list(gravity), "held": ["ground"] if "ground" in bodies else [], "stop_at_rest": False,
                       "contact": {"friction": friction}} | motion}
    if gauges:
        deck["gauges"] = {name: {"type": "displacement", "at": list(at), "direction": list(direction)}
                          for name, (at, direction) in gauges.items()}
    return deck


def steps_of(seconds, size=1.0, gravity=GRAVITY):
    """`motion.step` of a time step, by the size of the smallest block."""
    return seconds / math.sqrt(size / gravity)


def books(done):
    """What the energy book of a run misses, and what its steps have created, over the most it has held at once or released."""
    curve, motion = done.motion.curve, done.summary["motion"]
    held = max(curve["kinetic_energy"].max(), (curve["external_work"].cummax()).max(), 1e-300)
    damped = np.concatenate([[0], curve["impact"] + curve["numerical_damping"]])
    created = (np.maximum.accumulate(damped) - damped).max()
    return {"missed": float(np.abs(curve["energy_error"]).max() / held), "created": float(created / held),
            "steps": motion["steps"], "rejected": motion["rejected_steps"], "solves": motion["iterations"],
            "seconds": done.summary["timings"]["motion"]}


def row(done, scene_, integrator, quantity, exact, found, scale=None):
    """The error is over the scale, by default what is exact."""
    error = abs(found - exact) / (scale or abs(exact) or 1)
    return {"scene": scene_, "integrator": name_of(integrator), "quantity": quantity, "exact": float(exact), "found": float(found),
            "error": float(error), "ended": done.summary["status"] == "goal_reached", **books(done)}


def incline(run, integrators, steps):
    """A block of 1 m slides for 1 s on a plane of 30°, φ = 20°."""
    friction = math.tan(math.radians(20))
    exact = GRAVITY / 2 * (math.sin(math.pi / 6) - friction * math.cos(math.pi / 6))
    pull = (GRAVITY * math.sin(math.pi / 6), -GRAVITY * math.cos(math.pi / 6))
    out = []
    for step in steps:
        for integrator in integrators:
            deck = scene({"ground": FLOOR, "block": box(0, 0, 1, 1)}, pull, friction, {"x": ((0.5, 0.5), (1, 0))}, time=1,
                         step=steps_of(step), integrator=integrator)
            done = run(f"incline-{len(out)}", deck)
            out.append(row(done, f"slides on 30°, φ = 20°, dt {1000 * step:g} ms", integrator, "way in 1 s [m]", exact,
                           done.motion.curve.x.iloc[-1]))
    return out


def area(points):
    x, y = points[:, 0], points[:, 1]
    return abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def outline(done, block=-1):
    """The corners of a block at the end."""
    vertices = done.motion.fields().vertices
    groups = [part for _, part in vertices.groupby("block")]
    part = groups[block]
    return np.column_stack([part["x"] + part["displacement_x"], part["y"] + part["displacement_y"]])


def spin(run, integrators, per_turn):
    """Ten turns of a block of 1 m with nothing around it, whose area should stay."""
    out = []
    pull = 1e-3
    for steps in per_turn:
        for integrator in integrators:
            deck = scene({"block": box(0, 0, 1, 1)}, (0, -pull), time=20 * math.pi, integrator=integrator,
                         step=steps_of(2 * math.pi / steps, gravity=pull),
                         velocities=[{"regions": ["block"], "velocity": [0, 0], "spin": 1}])
            done = run(f"spin-{len(out)}", deck)
            out.append(row(done, f"ten turns, {steps} steps a turn", integrator, "area after / before", 1, area(outline(done))))
    return out


def bounce(run, integrators, steps):
    """A block falls by 1 m on the ground; nothing is said of a rebound."""
    out = []
    for step in steps:
        for integrator in integrators:
            deck = scene({"ground": FLOOR, "block": box(0, 1, 1, 2)}, gauges={"y": ((0.5, 1), (0, 1))}, time=1.2,
                         step=steps_of(step), integrator=integrator)
            done = run(f"bounce-{len(out)}", deck)
            curve = done.motion.curve
            behind = curve.time > math.sqrt(2 / GRAVITY) + 2 * step
            height = max(0.0, float(curve.y[behind].max()) + 1)
            out.append(row(done, f"falls 1 m, dt {1000 * step:g} ms", integrator, "speed after / before the impact", 0,
                           math.sqrt(height)) | {"step": step})
    return out


def pressure(square):
    """Vertical pressure in a block that was a square of 1 m, in plane stress, from its strains."""
    breadth, height = square[1:3, 0].mean() - square[[0, 3], 0].mean(), square[2:, 1].mean() - square[:2, 1].mean()
    return -MODULUS / (1 - POISSON**2) * (height - 1 + POISSON * (breadth - 1))


def stack(run, integrators, count=10):
    """Blocks of 1 m on each other for 2 s: the mean stress of each, by its strain, against the weights above its middle. Forces of
    `free_flight` act on cores, whose height is less by 2 s."""
    bodies = {"ground": FLOOR} | {f"block {i}": box(0, i, 1, i + 1) for i in range(count)}
    weight = DENSITY * GRAVITY
    out = []
    for integrator in integrators:
        done = run(f"stack-{len(out)}", scene(bodies, time=2, step=steps_of(0.02), integrator=integrator))
        arm = 1 - 2 * OFFSET if integrator == FREE_FLIGHT else 1
        worst = max(abs(pressure(outline(done, 1 + i)) / (arm * weight * (count - i - 0.5)) - 1) for i in range(count))
        out.append(row(done, f"stack of {count}, 2 s", integrator, "worst mean stress / weights above", 1, 1 + worst))
    return out


def column(integrator, time=2.0, blocks=50, **motion):
    """A column of Voronoi blocks, twice as high as it is broad, on a floor; every joint is friction alone."""
    height, breadth = 8.0, 4.0
    size = math.sqrt(height * breadth / blocks)
    joint = {"type": "friction", "friction_angle": 11.3}
    return {"title": "a column of Voronoi blocks that collapses", "units": {"length": "m", "force": "N"},
            "scene": {"regions": [{"name": "floor", "material": "floor", "vertices": box(-2 * breadth, -size, 3 * breadth, 0)},
                                  {"name": "column", "material": "stone", "vertices": box(0, 0, breadth, height)}],
                      "subdivision": {"type": "voronoi", "size": size, "seed": 1}},
            "thickness": 1, "materials": {"floor": dict(STONE), "stone": dict(STONE)},
            "interfaces": {"joints": {"between": ["stone", "stone"], "law": joint},
                           "foot": {"between": ["stone", "floor"], "law": joint}},
            "motion": {"time": time, "gravity": [0, -GRAVITY], "held": ["floor"], "stop_at_rest": False,
                       "contact": {"friction": 0.2}, "integrator": integrator, **motion}}
