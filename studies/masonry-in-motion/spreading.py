"""By how far the supports of a semicircular arch can spread: three hinges, statics on the displaced shape.

Half the arch, symmetric: its stones below joint k go with the support, those above turn about the intrados of joint k, so that
the extrados of the crown stays in the middle. The thrust H of the crown follows from the moments about the hinge. The shape is
in equilibrium where the thrust line stays within every joint; the arch falls where no k is left for which it does.
"""

import math

import numpy as np
from limit_equilibrium import area_and_centroid
from shapes import semicircular_arch


class SpreadArch:
    def __init__(self, stones, thickness):
        self.half = stones // 2
        blocks = semicircular_arch(stones, thickness)
        found = [area_and_centroid(blocks[f"stone {i + 1}"]) for i in range(self.half)]
        self.areas = np.array([area for area, _ in found])
        self.centroids = np.array([centroid for _, centroid in found])
        angles = math.pi * np.arange(self.half + 1) / stones
        self.inner = (1 - thickness / 2) * np.column_stack([np.cos(angles), np.sin(angles)])
        self.outer = (1 + thickness / 2) * np.column_stack([np.cos(angles), np.sin(angles)])

    def thrust_line(self, hinge, spread):
        """Where it crosses each joint, from 0 at the intrados to 1 at the extrados; None where the hinges are too far apart."""
        pivot, crown = self.inner[hinge], self.outer[-1]
        arm, reach = crown - pivot, -(pivot[0] + spread / 2)
        if abs(reach) >= np.hypot(*arm):
            return None
        turn = math.atan2(math.sqrt(arm @ arm - reach**2), reach) - math.atan2(arm[1], arm[0])
        c, s = math.cos(turn), math.sin(turn)

        def moved(points, is_above):
            turned = (points - pivot) @ np.array([[c, s], [-s, c]]) + pivot
            return np.where(np.asarray(is_above)[:, None], turned, points) + [spread / 2, 0]

        centroids = moved(self.centroids, np.arange(self.half) >= hinge)
        inner, outer = (moved(points, np.arange(self.half + 1) >= hinge) for points in (self.inner, self.outer))
        above = slice(hinge, None)
        thrust = self.areas[above] @ (inner[hinge, 0] - centroids[above, 0]) / (outer[-1, 1] - inner[hinge, 1])
        return np.array([self.crossing(inner[j], outer[j], outer[-1], thrust, centroids, j) for j in range(self.half + 1)])

    def crossing(self, inner, outer, crown, thrust, centroids, joint):
        """Share of the joint at which the thrust and the weights above it have no moment."""
        weight, at = self.areas[joint:], centroids[joint:, 0]

        def moment(place):
            return -thrust * (crown[1] - place[1]) - weight @ (at - place[0])

        low, high = moment(inner), moment(outer)
        return low / (low - high)

    def fits(self, hinge, spread, slack=1e-9):
        line = self.thrust_line(hinge, spread)
        return line is not None and line.min() >= -slack and line.max() <= 1 + slack

    def largest_spread(self, step=1e-5):
        """And the joint at which the haunch has its hinge from the first spread to the last."""
        hinge = next(k for k in range(1, self.half) if self.fits(k, 0.0))
        spread = 0.0
        while self.fits(hinge, spread):
            spread += step
        return spread - step / 2, hinge
