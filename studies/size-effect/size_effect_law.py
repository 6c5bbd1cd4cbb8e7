"""Bažant's size-effect law fitted to nominal strengths, with confidence intervals; numpy alone.

    σ_N/ft = B / √(1 + D/D₀)      that is      (ft/σ_N)² = C + A x,   x = D/l_ch,   B = C^(-1/2),   D₀/l_ch = C/A

A and C come from a linear regression in which each point has the weight (σ_N/ft)⁴: then it is the relative error of the
strength that is made small, in large beams as in small ones.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

CONFIDENCE = 0.95
# Linear elastic fracture mechanics of the notched beam, a₀/D = 0.5: (ft/σ_N)² → g D/l_ch + g' c_f/l_ch.
LEFM_SLOPE, LEFM_DERIVATIVE = 3.106, 19.66
# Rigid-plastic limit: ft over all of the ligament, compressed at its top, σ_N/ft = 3 (1 − a₀/D)².
PLASTIC = {"notched": 0.75, "three-point": 3.0, "four-point": 3.0}
# Stress at the bottom against beam theory, under point loads: the limit of large uncracked beams.
ELASTIC = {"three-point": 1.05, "four-point": 0.95}


@dataclass(frozen=True)
class Fit:
    """Parameters of the law, each with the half width of its confidence interval."""

    b: float  # B, in units of ft
    b_half: float
    d0: float  # D₀/l_ch
    d0_half: float
    slope: float  # A, which large beams of the law share with linear elastic fracture mechanics
    slope_half: float
    largest: float  # relative deviation of a strength from the law

    def strength(self, x):
        return self.b / np.sqrt(1 + np.asarray(x) / self.d0)


def fit(lengths, strengths):
    """The law through σ_N/ft at D/l_ch; at least three points."""
    x, y = np.asarray(lengths, dtype=float), np.asarray(strengths, dtype=float) ** -2.0
    rows = np.column_stack([1 / y, x / y])  # C/y + A x/y = 1
    (c, a), *_ = np.linalg.lstsq(rows, np.ones(len(x)), rcond=None)
    freedom = len(x) - 2
    misfit = rows @ (c, a) - 1
    covariance = misfit @ misfit / freedom * np.linalg.inv(rows.T @ rows)
    wide = student(freedom)
    b, d0 = c**-0.5, c / a
    spread = [math.sqrt(gradient @ covariance @ gradient)
              for gradient in (np.array([-b / (2 * c), 0]), np.array([1 / a, -d0 / a]), np.array([0, 1.0]))]
    law = b / np.sqrt(1 + x / d0)
    return Fit(b, wide * spread[0], d0, wide * spread[1], a, wide * spread[2],
               float(np.abs(law * np.sqrt(y) - 1).max()))


@lru_cache
def student(freedom, confidence=CONFIDENCE):
    """t such that a Student variable lies within ±t with this probability; by bisection of the integrated density."""
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(freedom * math.pi)
    low, high = 0.0, 1000.0
    for _ in range(60):
        middle = (low + high) / 2
        # With u = s/√n the density is smooth in the angle atan u: ∫ cos^(n−1) dφ.
        angle = np.linspace(0, math.atan(middle / math.sqrt(freedom)), 2001)
        values = np.cos(angle) ** (freedom - 1)
        inside = 2 * scale * math.sqrt(freedom) * float(((values[1:] + values[:-1]) / 2 * np.diff(angle)).sum())
        low, high = (middle, high) if inside < confidence else (low, middle)
    return low
