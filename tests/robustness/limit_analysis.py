"""Limit analysis of rigid blocks that only touch: the load factor at which an assembly collapses, by linear programming.

Bodies press on each other at given points, with a compression n >= 0 and a shear force |t| <= μ n [F]. Of all such forces
in equilibrium with the loads, those are sought that bear the largest multiple of the live ones:

    maximise λ   subject to   for every block   Σ forces + dead + λ live = 0,   Σ moments likewise,   n >= 0,   |t| <= μ n

No load beyond λ has forces in equilibrium with it, so none is borne. That λ itself is reached is the static theorem of limit
analysis, whose joints open as they slide. Coulomb's do not: where they slide at collapse λ is an upper bound in general. It
is what blocks reach where they rock about hinges, so that even a friction without bounds leaves λ as it is
(`decided_by_hinges`), and where they slide over joints whose pressure follows from equilibrium alone.
Lengths and forces are in any units; as forces act on the shape at rest, displacements are small.
"""
import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_array, csr_array, hstack, vstack

PLACES = {"gauss": (0.5 - 0.5 / np.sqrt(3), 0.5 + 0.5 / np.sqrt(3)), "vertices": (0.0, 1.0)}


def area_and_centroid(polygon):
    """Of a polygon whose corners are given anticlockwise."""
    here, there = np.asarray(polygon, float), np.roll(np.asarray(polygon, float), -1, axis=0)
    cross = here[:, 0] * there[:, 1] - there[:, 0] * here[:, 1]
    area = cross.sum() / 2
    return area, (here + there).T @ cross / (6 * area)


def wrench(force, place):
    """A force at a place: its two components, and its moment about the origin."""
    return np.array([force[0], force[1], place[0] * force[1] - place[1] * force[0]])


def weight(polygon, force_per_volume, thickness):
    """A body force's resultant."""
    area, centroid = area_and_centroid(polygon)
    return wrench(area * thickness * np.asarray(force_per_volume, float), centroid)


def common_part(side, other, tolerance):
    """Both ends of what two sides share when they lie on each other, or None."""
    start, end = side
    length = np.linalg.norm(end - start)
    along = (end - start) / length
    across = np.array([-along[1], along[0]])
    if np.abs((other - start) @ across).max() > tolerance:
        return None
    low, high = np.sort((other - start) @ along)
    low, high = max(low, 0.0), min(high, length)
    return (start + low * along, start + high * along) if high - low > tolerance else None


def joints(polygons):
    """(block, neighbour, start, end) of every side, or part of one, along which two polygons touch."""
    shapes = [np.asarray(polygon, float) for polygon in polygons]
    tolerance = 1e-9 * max(np.ptp(shape, axis=0).max() for shape in shapes)
    sides = [[np.array(side) for side in zip(shape, np.roll(shape, -1, axis=0))] for shape in shapes]
    found = []
    for i, mine in enumerate(sides):
        for j in range(i + 1, len(sides)):
            parts = (common_part(side, other, tolerance) for side in mine for other in sides[j])
            found += [(i, j, *part) for part in parts if part]
    return found


def contact_points(polygons, places):
    """(block, neighbour, point, unit normal out of the block) for every contact; `places` is gauss or vertices."""
    found = []
    for i, j, start, end in joints(polygons):
        along = (end - start) / np.linalg.norm(end - start)
        found += [(i, j, start + share * (end - start), np.array([along[1], -along[0]])) for share in PLACES[places]]
    return found


def equilibrium_matrix(contacts, count):
    """Columns n, t of every contact: what it exerts on its two blocks, three rows a block."""
    rows, columns, values = [], [], []
    for k, (i, j, point, normal) in enumerate(contacts):
        for column, force in ((2 * k, -normal), (2 * k + 1, np.array([-normal[1], normal[0]]))):
            for block, sign in ((i, 1), (j, -1)):
                rows += range(3 * block, 3 * block + 3)
                columns += 3 * [column]
                values += list(sign * wrench(force, point))
    return csr_array(coo_array((values, (rows, columns)), shape=(3 * count, 2 * len(contacts))))


def collapse_factor(polygons, held, loads, friction, places):
    """The largest λ of the blocks, of which those in `held` do not move.

    `loads` is (dead, live), each a wrench about the origin per block; `friction` is μ; `places` is gauss or vertices.
    Infinite where the load wedges the blocks; ValueError where they do not bear the dead ones.
    """
    contacts = contact_points(polygons, places)
    free = [row for block in range(len(polygons)) if block not in held for row in range(3 * block, 3 * block + 3)]
    dead, live = (np.concatenate(load)[free] for load in loads)
    size = np.abs(dead).max()
    balance = hstack([equilibrium_matrix(contacts, len(polygons))[free], live[:, None] / size])
    cone = np.array([[-friction, 1.0], [-friction, -1.0]])
    points = np.arange(len(contacts))
    friction_rows = vstack([coo_array((np.tile(row, len(contacts)), (np.repeat(points, 2), np.arange(2 * len(contacts)))),
                                      shape=(len(contacts), 2 * len(contacts) + 1)) for row in cone])
    goal = np.zeros(2 * len(contacts) + 1)
    goal[-1] = -1
    bounds = [(0, None), (None, None)] * len(contacts) + [(0, None)]
    found = linprog(goal, A_ub=friction_rows, b_ub=np.zeros(2 * len(contacts)), A_eq=balance, b_eq=-dead / size,
                    bounds=bounds, method="highs-ds",
                    options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
    unbounded = 3
    if found.status == unbounded:
        return np.inf
    if found.status != 0:
        raise ValueError(f"no collapse load: {found.message}")
    return found.x[-1]


def decided_by_hinges(polygons, held, loads, friction, places):
    """Whether no friction, however large, would raise the collapse load."""
    factor = collapse_factor(polygons, held, loads, friction, places)
    return abs(collapse_factor(polygons, held, loads, 1e3 * friction, places) - factor) <= 1e-9 * factor
