"""What statics says of a wall of rigid stones that is pushed sideways by λ times its weight: bounds of the λ at which it fails."""

import numpy as np
from limit_equilibrium import area_and_centroid, balance, contacts, weights
from scipy.optimize import linprog


def largest_push(blocks, held, friction):
    """The largest λ with forces N >= 0, |T| <= μ N at the ends of the joints in balance with weight and push: no larger one is borne.

    blocks: name → corners, counter-clockwise; held: names of those that do not move. Coulomb's joints do not open as they slide,
    so that less may be borne.
    """
    free = [name for name in blocks if name not in held]
    joints = [joint for joint in contacts(blocks) if not {joint[0], joint[1]} <= set(held)]
    dead, push = weights(blocks, free, (0, -1)), weights(blocks, free, (1, 0))
    size, count = np.abs(dead).max(), 2 * len(joints)
    cone = np.zeros((count, count + 1))
    for k in range(len(joints)):
        cone[2 * k:2 * k + 2, 2 * k:2 * k + 2] = [[-friction, 1], [-friction, -1]]
    found = linprog([0] * count + [-1], A_ub=cone, b_ub=np.zeros(count), A_eq=np.column_stack([balance(joints, free), push / size]),
                    b_eq=-dead / size, bounds=[(0, None), (None, None)] * len(joints) + [(0, None)], method="highs")
    if found.status != 0:
        raise SystemExit(f"statics of the wall: {found.message}")
    return float(found.x[-1])


def turns_over(blocks, moving):
    """The λ at which the stones of a part turn together about its lowest rightmost corner, all joints open elsewhere:
    weight and push have no moment about it."""
    corners = [corner for name in moving for corner in blocks[name]]
    x0, y0 = max(corners, key=lambda corner: (round(corner[0], 6), -corner[1]))
    parts = [area_and_centroid(blocks[name]) for name in moving]
    return sum(area * (x0 - x) for area, (x, _) in parts) / sum(area * (y - y0) for area, (_, y) in parts)
