"""Limit equilibrium of rigid blocks by linear programming, with numpy and scipy alone.

    stands(blocks, held, gravity, friction)            is there any equilibrium?
    least_friction(blocks, held, gravity, friction)    of a joint's coefficient, found by bisection

Blocks press on each other at the ends of the sides they share, with N >= 0 and |T| <= μ N. Where no such forces balance the
weights the structure cannot stand (static theorem). Coulomb joints do not open as they slide, so that forces in balance are
no proof that it does; where blocks turn about hinges, or slide under a pressure that statics alone gives, they are.
"""

import math

import numpy as np
from scipy.optimize import linprog


def area_and_centroid(polygon):
    """Of a polygon whose corners are given anticlockwise."""
    here = np.asarray(polygon, float)
    there = np.roll(here, -1, axis=0)
    cross = here[:, 0] * there[:, 1] - there[:, 0] * here[:, 1]
    area = cross.sum() / 2
    return area, cross @ (here + there) / (6 * area)


def sides(polygon):
    corners = [np.asarray(corner, float) for corner in polygon]
    return list(zip(corners, corners[1:] + corners[:1]))


def shared(side, other):
    """Both ends of what two sides share that lie on each other, and the normal out of the first; else None."""
    (start, end), length = side, np.linalg.norm(side[1] - side[0])
    along = (end - start) / length
    normal = np.array([along[1], -along[0]])
    if max(abs((corner - start) @ normal) for corner in other) > 1e-7 * length:
        return None
    low, high = sorted((corner - start) @ along for corner in other)
    low, high = max(low, 0), min(high, length)
    return (start + low * along, start + high * along, normal) if high - low > 1e-7 * length else None


def contacts(blocks):
    """(block, other, place, normal from the first to the other) at both ends of each joint; blocks: name → corners."""
    names, found = list(blocks), []
    for i, first in enumerate(names):
        for second in names[i + 1:]:
            for side in sides(blocks[first]):
                for other in sides(blocks[second]):
                    joint = shared(side, other)
                    found += [(first, second, place, joint[2]) for place in joint[:2]] if joint else []
    return found


def balance(joints, free):
    """The forces and moments that N and T of each contact exert on the blocks that are free."""
    rows = {name: 3 * k for k, name in enumerate(free)}
    matrix = np.zeros((3 * len(free), 2 * len(joints)))
    for k, (first, second, place, normal) in enumerate(joints):
        for column, force in ((2 * k, -normal), (2 * k + 1, np.array([-normal[1], normal[0]]))):
            moment = place[0] * force[1] - place[1] * force[0]
            for name, sign in ((first, 1), (second, -1)):
                if name in rows:
                    matrix[rows[name]:rows[name] + 3, column] += sign * np.array([*force, moment])
    return matrix


def weights(blocks, free, gravity):
    loads = []
    for name in free:
        area, (x, y) = area_and_centroid(blocks[name])
        loads += [area * gravity[0], area * gravity[1], area * (x * gravity[1] - y * gravity[0])]
    return np.array(loads)


def stands(blocks, held, gravity, friction):
    """friction: a number, or the coefficient of a joint by the names of its two blocks."""
    free = [name for name in blocks if name not in held]
    joints = [joint for joint in contacts(blocks) if not {joint[0], joint[1]} <= set(held)]
    loads = weights(blocks, free, gravity)
    size = np.abs(loads).max()
    cone = np.zeros((2 * len(joints), 2 * len(joints)))
    for k, (first, second, _, _) in enumerate(joints):
        limit = friction(first, second) if callable(friction) else friction
        cone[2 * k:2 * k + 2, 2 * k:2 * k + 2] = [[-limit, 1], [-limit, -1]]
    found = linprog(np.zeros(2 * len(joints)), A_ub=cone, b_ub=np.zeros(len(cone)), A_eq=balance(joints, free),
                    b_eq=-loads / size, bounds=[(0, None), (None, None)] * len(joints), method="highs")
    return found.status == 0


def least(holds, low, high, precise):
    """The number from which on something holds, by bisection; it must not hold at the lower end and hold at the upper."""
    if holds(low) or not holds(high):
        raise ValueError(f"{low} and {high} do not enclose it")
    while high - low > precise:
        middle = (low + high) / 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return (low + high) / 2


def least_friction(blocks, held, gravity, friction=lambda value: value):
    """Least coefficient; friction(value) is what `stands` is given."""
    return least(lambda value: stands(blocks, held, gravity, friction(value)), 1e-6, 20, 1e-7)


def degrees(coefficient):
    return math.degrees(math.atan(coefficient))
