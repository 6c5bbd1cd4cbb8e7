"""Toppling of stepped columns after Goodman and Bray (1976): the angle of friction at the limit, by their recursion.

Column n stands on a base inclined by `dip` [degrees], Δx wide and y high; column 1 is the toe. From the top down column n hands
on to column n − 1 the larger of what keeps it from toppling and from sliding:

    toppling  P[n-1] = (P[n] (M[n] − Δx tan φ) + W[n]/2 (y[n] sin ψ − Δx cos ψ)) / L[n]
    sliding   P[n-1] = P[n] − W[n] (cos ψ tan φ − sin ψ) / (1 − tan² φ)

where P[n] acts at height M[n] and P[n-1] at L[n]. At the limit the toe hands on nothing.
"""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Slope:
    """Hoek and Bray's example: 92.5 m high, 16 columns, the crest at column 10, steps of 1 m."""

    width: float = 10.0
    dip: float = 30.0
    below: float = 5.0     # by which the next column's top is higher below the crest
    above: float = 5.2     # and lower above it
    step: float = 1.0
    crest: int = 10
    columns: int = 16

    def heights(self):
        rising = [(self.below - self.step) * n for n in range(1, self.crest + 1)]
        return rising + [rising[-1] - (self.above + self.step) * n for n in range(1, self.columns - self.crest + 1)]

    def arms(self, number):
        """M and L of a column."""
        height = self.heights()[number - 1]
        upper = height if number < self.crest else height - self.above
        lower = height - self.below if number <= self.crest else height
        return upper, lower if number > 1 else height

    def passed_on(self, friction):
        """(force on the next column, how: stands, topples or slides) of each column, the toe first; friction in degrees.

        Weights are areas: their unit cancels.
        """
        held, dip = math.tan(math.radians(friction)), math.radians(self.dip)
        force, found = 0.0, []
        for number in range(self.columns, 0, -1):
            height, (upper, lower) = self.heights()[number - 1], self.arms(number)
            weight = self.width * height
            topples = (force * (upper - self.width * held)
                       + weight / 2 * (height * math.sin(dip) - self.width * math.cos(dip))) / lower
            slides = force - weight * (math.cos(dip) * held - math.sin(dip)) / (1 - held**2)
            force = max(topples, slides, 0.0)
            found.append((force, "stands" if force == 0 else "topples" if topples >= slides else "slides"))
        return found[::-1]

    def limiting_angle(self):
        low, high = self.dip, 44.0
        while high - low > 1e-9:
            middle = (low + high) / 2
            low, high = (low, middle) if self.passed_on(middle)[0][0] <= 0 else (middle, high)
        return low
