"""One block against closed forms. Each case gives rows: case, quantity, unit, exact, found, bound."""

import math

import numpy as np
from scenes import GRAVITY, box, inclined, scene, turned

FLOOR = box(-10, -1, 30, 0)


def row(case, quantity, unit, exact, found, bound, scale=None):
    """bound: of |found − exact| over the scale, by default |exact|, or 1 where that is zero."""
    error = abs(found - exact) / (scale or abs(exact) or 1)
    return {"case": case, "quantity": quantity, "unit": unit, "exact": float(exact), "found": float(found),
            "error": error, "bound": bound}


def thrown(run):
    deck = scene({"block": box(0, 5, 1, 6)}, gauges={"x": ((0.5, 5.5), (1, 0)), "y": ((0.5, 5.5), (0, 1))}, held=[],
                 velocities=[{"regions": ["block"], "velocity": [2, 3], "spin": 5}], time=1, step=0.1)
    last = run("thrown", deck).motion.curve.iloc[-1]
    return [row("throw, 1 s, longest steps", "x", "m", 2, last.x, 1e-9),
            row("throw, 1 s, longest steps", "y", "m", 3 - GRAVITY / 2, last.y, 1e-9)]


def slides(run):
    rows = []
    for angle, step in ((20, 0.01), (20, 0.1), (29.9, 0.01)):
        friction = math.tan(math.radians(angle))
        deck = scene({"ground": FLOOR, "block": box(0, 0, 1, 1)}, inclined(30), friction,
                     {"x": ((0.5, 0.5), (1, 0))}, time=1, step=step)
        exact = GRAVITY / 2 * (math.sin(math.pi / 6) - friction * math.cos(math.pi / 6))
        rows.append(row(f"slides on 30°, φ = {angle}°, step {step}", "way in 1 s", "m", exact,
                        run(f"slides-{angle}-{step}", deck).motion.curve.x.iloc[-1], 1e-3, GRAVITY / 4))
    return rows


def sticks(run):
    deck = scene({"ground": FLOOR, "block": box(0, 0, 1, 1)}, inclined(30), math.tan(math.radians(35)),
                 {"x": ((0.5, 0.5), (1, 0))}, time=20, stop_at_rest=False)
    curve = run("sticks", deck).motion.curve
    early = curve.x[curve.time >= 1].iloc[0]
    return [row("sticks on 30°, φ = 35°", "way from 1 to 20 s", "m", 0, curve.x.iloc[-1] - early, 1e-8)]


def stops(run):
    deck = scene({"ground": FLOOR, "block": box(0, 0, 1, 1)}, gauges={"x": ((0.5, 0.5), (1, 0))},
                 velocities=[{"regions": ["block"], "velocity": [3, 0]}], time=20)
    done = run("stops", deck).motion
    return [row("slides to a stop, 3 m/s, μ = 0.5", "way", "m", 9 / GRAVITY, done.curve.x.iloc[-1], 2e-4),
            row("slides to a stop, 3 m/s, μ = 0.5", "friction / kinetic energy", "", 1,
                done.curve.friction.iloc[-1] / (2500 * 9 / 2), 1e-2)]


def bounces(run):
    rows = []
    for e in (0.0, 0.5, 0.9):
        deck = scene({"ground": FLOOR, "block": box(0, 1, 1, 2)}, gauges={"y": ((0.5, 1), (0, 1))},
                     time=1.1, stop_at_rest=False)
        deck["motion"]["contact"]["restitution"] = e
        curve = run(f"bounces-{e}", deck).motion.curve
        y, t = np.asarray(curve.y) + 1, np.asarray(curve.time)
        behind = t > math.sqrt(2 / GRAVITY) + 0.02
        rows.append(row(f"falls 1 m, restitution {e}", "√(height of the rebound)", "√m", e,
                        math.sqrt(max(0, y[behind].max())), 1e-3))
    return rows


def dragged(run):
    """A ground that sets out with an acceleration beyond friction leaves the block behind."""
    acceleration, friction, time = 8, 0.5, 1
    record = run.file("record.csv", f"time,acceleration\n0,{acceleration}\n{2 * time},{acceleration}\n")
    deck = scene({"ground": FLOOR, "block": box(0, 0, 1, 1)}, friction=friction, gauges={"x": ((0.5, 0.5), (1, 0))},
                 time=time, driven=[{"regions": ["ground"], "direction": [1, 0],
                                     "displacement": {"type": "record", "file": str(record)}}])
    return [row("on a ground that accelerates by 8 m/s², μ = 0.5", "way in 1 s", "m",
                friction * GRAVITY * time**2 / 2, run("dragged", deck).motion.curve.x.iloc[-1], 1e-3)]


def swings(run):
    """A block between springs: T = 2π √(m/k), and nothing is lost by the trapezoidal rule."""
    stiffness = 1e6
    deck = scene({"block": box(0, 0, 1, 1)}, gravity=(0, 0), held=[], gauges={"x": ((0.5, 0.5), (1, 0))}, time=1,
                 integrator="trapezoidal", stop_at_rest=False, step=1e-4,
                 velocities=[{"regions": ["block"], "velocity": [0.1, 0]}])
    deck["supports"] = {"spring": {"at": [0.5, 0.5], "fix": "x", "stiffness": stiffness}}
    curve = run("swings", deck).motion.curve
    x, t = np.asarray(curve.x), np.asarray(curve.time)
    down = [i for i in range(1, len(x)) if x[i - 1] > 0 >= x[i]]
    at = [t[i] - x[i] * (t[i] - t[i - 1]) / (x[i] - x[i - 1]) for i in down]
    kinetic = np.asarray(curve.kinetic_energy + curve.stored_energy)
    return [row("swings on a spring, trapezoidal", "period", "s", 2 * math.pi * math.sqrt(2500 / stiffness),
                (at[-1] - at[0]) / (len(at) - 1), 1e-3),
            row("swings on a spring, trapezoidal", "energy kept", "", 1, kinetic[-1] / (2500 * 0.01 / 2), 1e-6)]


def rocks(run):
    """Housner's block: from a tilt back to its base, and what the impact leaves of its spin."""
    breadth, height, tilt = 0.2, 1.0, 0.1
    slenderness, radius = math.atan(breadth / height), math.hypot(breadth, height) / 2
    vertices = turned(box(0, 0, breadth, height), (breadth, 0), -tilt)
    deck = scene({"ground": FLOOR, "block": vertices}, friction=2,
                 gauges={"top": (vertices[3], (1, 0)), "foot": (vertices[0], (0, 1)), "base": (vertices[1], (1, 0))},
                 time=1.2, stop_at_rest=False, step=0.003)
    curve = run("rocks", deck).motion.curve
    t, foot = np.asarray(curve.time), np.asarray(curve.foot) + vertices[0][1]
    down = int(np.argmax(foot < 2e-3 * breadth))
    time = time_to_impact(slenderness, radius, tilt)
    # The energy of the spin is as much about either corner; what the weight has taken since is added back.
    kinetic, work = np.asarray(curve.kinetic_energy), np.asarray(curve.external_work)
    late = down + 30
    ratio = math.sqrt((kinetic[late] - (work[late] - work[down])) / kinetic[:down].max())
    return [row("rocks about a corner (Housner), B/H = 0.2", "time to the impact", "s", time, t[down], 1e-2),
            row("rocks about a corner (Housner), B/H = 0.2", "spin after the impact over that before", "",
                1 - 1.5 * math.sin(slenderness)**2, ratio, 2e-2)]


def time_to_impact(slenderness, radius, tilt):
    """From a tilt to the base: θ̈ = −(3 g/4 R) sin(α − θ), integrated finely."""
    angle, spin, time, step = tilt, 0.0, 0.0, 1e-5
    while angle > 0:
        spin -= step * 3 * GRAVITY / (4 * radius) * math.sin(slenderness - angle)
        angle += step * spin
        time += step
    return time


CASES = (thrown, slides, sticks, stops, bounces, dragged, swings, rocks)
QUICK = (thrown, sticks, dragged, swings)
