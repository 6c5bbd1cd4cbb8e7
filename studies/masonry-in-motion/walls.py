"""Walls in running bond on a ground that moves: rocking out of the plane, sliding in it."""

import math

import numpy as np
from arches import row
from limit_equilibrium import degrees
from shapes import GRAVITY, box, deck

LEAF = {"courses": 12, "breadth": 0.3, "height": 3.0}  # the section of a single-leaf wall
BRICK = (0.5, 0.25)
COURSE = 0.3  # coefficient of friction of the damp-proof course below the wall
ROCKED = 0.02  # of a heel that has lifted [m]


def stack(courses, breadth, height):
    rise = height / courses
    return {"ground": box(-1, -0.3, 5, 0)} | {f"course {i + 1}": box(0, i * rise, breadth, (i + 1) * rise)
                                              for i in range(courses)}


def running_bond(bricks, courses):
    """Half bricks end every second course."""
    length, rise = BRICK
    blocks = {"ground": box(-2, -0.5, bricks * length + 2, 0)}
    for j in range(courses):
        ends = [i * length for i in range(bricks + 1)]
        ends = ends if j % 2 == 0 else [0, *(x - length / 2 for x in ends[1:]), bricks * length]
        for i, (left, right) in enumerate(zip(ends, ends[1:])):
            blocks[f"brick {j + 1}.{i + 1}"] = box(left, j * rise, right, (j + 1) * rise)
    return blocks


def shaken(displacement):
    return [{"regions": ["ground"], "direction": [1, 0], "displacement": displacement}]


def text_of_record(acceleration, times):
    return "\n".join(["time,acceleration", *(f"{t:.6g},{acceleration(t):.6g}" for t in times)]) + "\n"


def record(run, name, acceleration, times, factor=1):
    return {"type": "record", "file": str(run.file(f"{name}.csv", text_of_record(acceleration, times))), "factor": factor}


def leaf(displacement, time, **more):
    """The heel's lift and the ground's way."""
    more = {"stop_at_rest": False} | more
    return deck("Single-leaf wall of 12 courses, out of its plane", stack(**LEAF), ["ground"], 0.7, time=time, driven=shaken(displacement),
                gauges={"heel": ((LEAF["breadth"], 0.01), (0, 1)), "top": ((0, LEAF["height"]), (1, 0))}, **more)


def starts_to_rock(run, ramp=4.0):
    """The ground's acceleration grows evenly to twice g b/h. The lift grows with the cube of the time since its start."""
    exact = GRAVITY * LEAF["breadth"] / LEAF["height"]
    moves = record(run, "ramp", lambda t: 2 * exact * t / ramp, np.linspace(0, ramp, 3))
    curve = run("leaf-ramp", leaf(moves, ramp)).motion.curve
    lift, time = np.asarray(curve.heel), np.asarray(curve.time)
    early, late = (int(np.argmax(lift > share * LEAF["breadth"])) for share in (1e-3, 8e-3))
    growth = (lift[early] / lift[late]) ** (1 / 3)
    start = (time[early] - growth * time[late]) / (1 - growth)
    return row("single-leaf wall of 12 courses, out of its plane", "acceleration at which it rocks [m/s²]", exact,
               2 * exact * start / ramp, 0.03)


def wall(displacement, time, course=COURSE, bricks=6, courses=8, **more):
    """In its plane, on a damp-proof course."""
    law = {"type": "friction", "friction_angle": degrees(course)}
    more = {"stop_at_rest": False} | more
    return deck("Wall in running bond, in its plane", running_bond(bricks, courses), ["ground"], 0.7, time=time, driven=shaken(displacement), beds={"beds": {"between": ["stone", "ground"], "law": law}},
                gauges={"wall": ((BRICK[0] / 2, BRICK[1] / 2), (1, 0)), "top": ((BRICK[0] / 2, courses * BRICK[1]), (1, 0))}, **more)


def ways(acceleration, time, friction, speed=0.0, step=1e-4):
    """Of Newmark's block on a ground that accelerates and has a speed at first, and of the ground."""
    ground, block, there, way = speed, 0.0, 0.0, 0.0
    for k in range(round(time / step)):
        ground += step * acceleration((k + 0.5) * step)
        block += max(-friction * GRAVITY * step, min(friction * GRAVITY * step, ground - block))
        way, there = way + step * block, there + step * ground
    return way, there


def starts_to_slide(run, ramp=4.0):
    """The way behind the ground grows with the cube of the time since its start."""
    exact = COURSE * GRAVITY
    moves = record(run, "slide", lambda t: 2 * exact * t / ramp, np.linspace(0, ramp, 3))
    curve = run("wall-ramp", wall(moves, 0.75 * ramp)).motion.curve
    time = np.asarray(curve.time)
    behind = exact / (3 * ramp) * time**3 - np.asarray(curve.wall)
    early, late = (int(np.argmax(behind > share)) for share in (1e-3, 8e-3))
    growth = (behind[early] / behind[late]) ** (1 / 3)
    start = (time[early] - growth * time[late]) / (1 - growth)
    return row("wall in running bond, in its plane, course of μ = 0.3", "acceleration at which it slides [m/s²]", exact,
               2 * exact * start / ramp, 0.03)


def earthquake(t):
    """Acceleration over g: a sine under an envelope of 3 s."""
    return 0.6 * math.sin(math.pi * t / 3) ** 2 * math.sin(2 * math.pi * 1.5 * t + 1.0) if t < 3 else 0.0


def slides_under_a_record(run, time=3.0, what="", stiffer=1, bound=0.03, **more):
    moves = record(run, "earthquake", earthquake, RECORD["times"], RECORD["factor"])
    built = wall(moves, time, **more)
    for material in built["materials"].values():
        material["young_modulus"] *= stiffer
    found = run("wall-record" + what.replace(" ", "-"), built).motion.curve.wall.iloc[-1]
    way, ground = ways(lambda t: GRAVITY * np.interp(t, RECORD["times"], RECORD["values"]), time, COURSE)
    return row(f"the same under a record of 0.6 g{what}", "way on the ground in 3 s [m]", way - ground, found - ground, bound)


def slides_stiffly_under_a_record(run):
    """As Newmark's block, which is rigid."""
    return slides_under_a_record(run, what=" of E = 1 TPa in steps of 0.003", stiffer=100, step=0.003)


def slides_elastically_under_a_record(run):
    """What Newmark's block leaves out: the wall leans and swings back on its course."""
    return slides_under_a_record(run, what=" in steps of 0.003", step=0.003, bound=math.inf)


def slides_in_harmonic_motion(run, amplitude=0.05, frequency=2.0, time=1.5):
    """A sin(ω t): the ground sets out at its full speed."""
    omega = 2 * math.pi * frequency
    moves = {"type": "harmonic", "amplitude": amplitude, "frequency": frequency}
    found = run("wall-harmonic", wall(moves, time)).motion.curve.wall.iloc[-1]
    way, _ = ways(lambda t: -amplitude * omega**2 * math.sin(omega * t), time, COURSE, amplitude * omega)
    return row("the same in harmonic motion of 0.05 m, 2 Hz", "way in 1.5 s [m]", way, found, 0.03)


TIMES = np.linspace(0, 3.5, 351)
RECORD = {"times": TIMES, "values": [earthquake(t) for t in TIMES], "factor": GRAVITY}
