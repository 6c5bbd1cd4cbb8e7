"""Columns of a stepped slope as a deck, and the least angle of friction at which they come to rest."""

import math

from goodman_bray import Slope

GRAVITY = 9.81
ROCK = {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.25, "density": 2550}


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def regions(slope):
    """The columns upright on their steps, the toe at the left; gravity is turned instead."""
    out = []
    for i, height in enumerate(slope.heights()):
        left, low = i * slope.width, i * slope.step
        out.append({"name": f"column {i + 1}", "material": "rock", "vertices": box(left, low, left + slope.width, low + height)})
        out.append({"name": f"step {i + 1}", "material": "base",
                    "vertices": box(left, -2 * slope.width, left + slope.width, low)})
    return out


def deck(friction, slope=None, **motion):
    """friction: its angle [degrees], the same between columns and at their bases."""
    slope = slope or Slope()
    law = {"type": "friction", "friction_angle": friction}
    dip, crest = math.radians(slope.dip), slope.crest - 1
    top = [crest * slope.width, crest * slope.step + slope.heights()[crest]]
    return {"title": "Toppling of stepped columns", "units": {"length": "m", "force": "N"},
            "scene": {"regions": regions(slope)}, "thickness": 1, "plane": "strain",
            "materials": {"rock": ROCK, "base": ROCK},
            "interfaces": {"columns": {"between": ["rock", "rock"], "law": law}, "bases": {"between": ["rock", "base"], "law": law}},
            "gauges": {"crest": {"type": "displacement", "at": top, "direction": [-1, 0]}},
            "motion": {"time": 60, "gravity": [-GRAVITY * math.sin(dip), -GRAVITY * math.cos(dip)],
                       "held": [f"step {i + 1}" for i in range(slope.columns)],
                       "contact": {"friction": math.tan(math.radians(friction))}} | motion}


def stands(run, friction):
    """Whether the crest's top has moved by less than a tenth of a column's width when all is at rest, or after 60 s."""
    return run(f"columns-{friction:.3f}", deck(friction)).motion.curve.crest.iloc[-1] < 1.0


def limiting_angle(run, low=35.0, high=41.0, precise=0.05):
    if stands(run, low) or not stands(run, high):
        raise SystemExit(f"the limit is not between {low}° and {high}°")
    while high - low > precise:
        middle = (low + high) / 2
        low, high = (low, middle) if stands(run, middle) else (middle, high)
    return (low + high) / 2
