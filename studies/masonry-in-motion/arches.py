"""Arches against limit equilibrium. Each case has a deck of its limit parameter and the row of what is found."""

import math

import numpy as np
from limit_equilibrium import degrees, least, least_friction
from shapes import GRAVITY, between_abutments, between_buttresses, deck, flat_arch, semicircular_arch
from spreading import SpreadArch

IMPOSTS, ABUTMENTS = ("right impost", "left impost"), ("right abutment", "left abutment")
FLAT = {"span": 1, "depth": 0.08, "centre": math.sqrt(3) / 2}  # the joints point to the tip of an equilateral triangle
SPREADING = {"stones": 16, "thickness": 0.15}
FALLEN = 0.02  # of a crown that has come down by this much beyond where it should be [m]


def row(case, quantity, expected, found, bound):
    return {"case": case, "quantity": quantity, "expected": float(expected), "found": float(found),
            "error": abs(found / expected - 1), "bound": bound}


def ground_below(names):
    return lambda name: "ground" if name in names else "stone"


def semicircular(friction, thickness=0.15, stones=20):
    blocks = semicircular_arch(stones, thickness)
    return deck("Semicircular arch with little friction", blocks, IMPOSTS, friction, time=4,
                gauges={"crown": ((0, 1 - thickness / 2), (0, -1))})


def flat(friction):
    blocks = between_abutments(flat_arch(9, **FLAT), **FLAT)
    return deck("Flat arch with little friction", blocks, ABUTMENTS, friction, time=3, gauges={"crown": ((0, 0), (0, -1))})


def buttressed(friction):
    """Only the beds of the buttresses have little friction."""
    blocks = between_buttresses(flat_arch(9, **FLAT), **FLAT)
    angle = degrees(friction)
    return deck("Flat arch between buttresses", blocks, ["ground"], 1.0, time=3, gauges={"crown": ((0, 0), (0, -1))},
                beds={"beds": {"between": ["stone", "ground"], "law": {"type": "friction", "friction_angle": angle}}})


def spreading(spread, fast=4, slow=20, **motion):
    """The supports go apart, the last fifth slowly."""
    blocks = semicircular_arch(**SPREADING)
    moves = [{"regions": [name], "direction": [sign, 0],
              "displacement": {"type": "table", "times": [0, fast, fast + slow, 1000],
                               "values": [0, 0.4 * spread, 0.5 * spread, 0.5 * spread]}}
             for name, sign in zip(IMPOSTS, (1, -1))]
    return deck("Semicircular arch whose supports spread", blocks, [], 1.0, time=fast + slow + 4, driven=moves,
                materials=ground_below(IMPOSTS),
                gauges={"crown": ((0, 1 - SPREADING["thickness"] / 2), (0, -1))}) | motion


def stands(run, name, of, limit=FALLEN):
    return run(name, of).motion.curve.crown.iloc[-1] < limit


def friction_of_semicircular(run, thickness=0.15, precise=1e-3):
    exact = least_friction(semicircular_arch(20, thickness), IMPOSTS, (0, -GRAVITY))
    found = least(lambda value: stands(run, f"arch-{value:.5f}", semicircular(value, thickness)), 0.9 * exact, 1.1 * exact,
                  precise)
    return row(f"semicircular arch of 20 stones, t/R = {thickness}", "least friction μ", exact, found, 0.03)


def friction_of_flat(run, precise=1e-3):
    exact = least_friction(between_abutments(flat_arch(9, **FLAT), **FLAT), ABUTMENTS, (0, -GRAVITY))
    found = least(lambda value: stands(run, f"flat-{value:.5f}", flat(value)), 0.9 * exact, 1.1 * exact, precise)
    return row("flat arch of 9 stones between abutments", "least friction μ of the joints", exact, found, 0.03)


def friction_of_buttresses(run, precise=1e-3):
    blocks = between_buttresses(flat_arch(9, **FLAT), **FLAT)
    exact = least_friction(blocks, ["ground"], (0, -GRAVITY),
                           lambda bed: lambda one, other: bed if "ground" in (one, other) else 1.0)
    found = least(lambda value: stands(run, f"buttress-{value:.5f}", buttressed(value)), 0.9 * exact, 1.1 * exact, precise)
    return row("flat arch of 9 stones between buttresses", "least friction μ of their beds", exact, found, 0.03)


def spread_at_collapse(run, precise=5e-4):
    arch = SpreadArch(**SPREADING)
    exact, hinge = arch.largest_spread()
    found = least(lambda spread: not stands(run, f"spread-{spread:.5f}", spreading(spread), exact), 0.9 * exact, 1.1 * exact,
                  precise)
    return row(f"semicircular arch of 16 stones, t/R = 0.15, hinges at joint {hinge}", "spread at collapse / R", exact, found,
               0.03)


def hinges_of_spreading(run):
    """Which joints have opened at nine tenths of the spread, by the angle between the stones beside them."""
    arch = SpreadArch(**SPREADING)
    exact, hinge = arch.largest_spread()
    motion = run("spread-hinges", spreading(0.9 * exact)).motion
    angles = np.array([rotation(motion, stone) for stone in range(1, SPREADING["stones"] + 1)])
    opened = np.argsort(-np.abs(np.diff(angles)))[:3] + 1
    return sorted(int(joint) for joint in opened), sorted((hinge, SPREADING["stones"] // 2, SPREADING["stones"] - hinge))


def rotation(motion, stone):
    """Of a stone at the end; two imposts come before the stones."""
    return motion.fields().blocks.rotation.iloc[stone + 1]
