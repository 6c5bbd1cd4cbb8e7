"""Boundaries between the labels of a picture: lines from junction to junction, each simplified once.

Points are corners of pixels, (column, height - row), so that y points up and coordinates are whole numbers. A chain is the
boundary between two labels from one junction (where more than two labels meet, or a corner of the picture) to the next, or a closed
one around an island. Both labels take the same simplified line, so that neither gaps nor overlaps come of it.
"""

from dataclasses import dataclass

import numpy as np

from .crossings import crossings
from .net import Net, area

OUTSIDE = -1
FINEST = 0.25  # pixels; below it a line is taken as it is


@dataclass(frozen=True)
class Chain:
    """points: (n, 2) corners of pixels in order; left, right: the labels beside its way; is_island: it has no junction."""

    points: np.ndarray
    left: int
    right: int
    is_island: bool

    @property
    def is_closed(self):
        return bool((self.points[0] == self.points[-1]).all())


def steps(labels):
    """{corner: {next corner: (label on the left, on the right)}} along all sides of pixels between two labels."""
    height = labels.shape[0]
    padded = np.pad(labels, 1, constant_values=OUTSIDE)
    ways = {}

    def add(start, end, left, right):
        ways.setdefault(start, {})[end] = (left, right)
        ways.setdefault(end, {})[start] = (right, left)

    above, below = padded[:-1, 1:-1], padded[1:, 1:-1]
    for row, column in np.argwhere(above != below).tolist():
        y = height - row
        add((column, y), (column + 1, y), int(above[row, column]), int(below[row, column]))
    before, behind = padded[1:-1, :-1], padded[1:-1, 1:]
    for row, column in np.argwhere(before != behind).tolist():
        y = height - row
        add((column, y - 1), (column, y), int(before[row, column]), int(behind[row, column]))
    return ways


def chains_of(labels):
    """Every boundary between two labels, or a label and the outside, once."""
    ways, (height, width) = steps(labels), labels.shape
    nodes = {corner for corner, out in ways.items() if len(out) != 2}
    nodes |= {(x, y) for x in (0, width) for y in (0, height)}
    found, taken = [], set()
    for start in [*sorted(nodes), *sorted(ways.keys() - nodes)]:
        for second, (left, right) in sorted(ways[start].items()):
            if (start, second) in taken:
                continue
            walk = [start, second]
            while walk[-1] not in nodes and walk[-1] != start:
                walk.append(next(corner for corner in ways[walk[-1]] if corner != walk[-2]))
            taken |= {pair for one, other in zip(walk, walk[1:]) for pair in ((one, other), (other, one))}
            found.append(Chain(np.array(walk, float), left, right, start not in nodes))
    return found


def farthest(points):
    """(how far, which) of the points of a line from the chord between its ends [pixels]."""
    start, chord = points[0], points[-1] - points[0]
    away, length = points - start, np.hypot(*chord)
    far = np.abs(chord[0] * away[:, 1] - chord[1] * away[:, 0]) / length if length else np.hypot(*away.T)
    which = int(np.argmax(far))
    return float(far[which]), which


def simplified(points, tolerance):
    """Ramer, Douglas and Peucker: points of a line such that none of the others is farther than the tolerance from it."""
    kept, waiting = {0, len(points) - 1}, [(0, len(points) - 1)]
    while waiting:
        first, last = waiting.pop()
        if last - first < 2:
            continue
        far, which = farthest(points[first:last + 1])
        if far > max(tolerance, 1e-9):
            kept.add(first + which)
            waiting += [(first, first + which), (first + which, last)]
    return points[sorted(kept)]


def simplified_chain(chain, tolerance):
    """The line of a chain between its junctions; that of an island begins in its leftmost point, a corner."""
    points = chain.points
    if chain.is_island:
        begin = int(np.lexsort((points[:-1, 1], points[:-1, 0]))[0])
        points = np.vstack([points[begin:-1], points[:begin + 1]])
    return simplified(points, tolerance)


def is_degenerate(line, chain):
    return chain.is_closed and (len(line) < 4 or area(line[:-1]) * area(chain.points[:-1]) <= 0)


def segments_of(lines):
    """(points, segments, the chain of each segment)."""
    numbers, segments, owners = {}, [], []
    for k, line in enumerate(lines):
        ids = [numbers.setdefault(tuple(point), len(numbers)) for point in line.tolist()]
        segments += zip(ids, ids[1:])
        owners += [k] * (len(ids) - 1)
    return list(numbers), np.array(segments, int), np.array(owners, int)


class Simplified:
    """Chains as lines of few corners that cross nowhere: where some would, these are simplified less.

    tolerance: how far a line may be from the boundary of the pixels [pixels].
    """

    def __init__(self, chains, tolerance):
        self.chains, self.tolerances = chains, [tolerance] * len(chains)
        self.lines = [simplified_chain(chain, tolerance) for chain in chains]

    def refine(self, numbers):
        """Simplifies some chains less. Throws ValueError where all of them are as they were drawn."""
        finer = [k for k in numbers if self.tolerances[k] > 0]
        if not finer:
            raise ValueError("boundaries of pixels cross each other")
        for k in finer:
            half = self.tolerances[k] / 2
            self.tolerances[k] = half if half > FINEST else 0.0
            self.lines[k] = simplified_chain(self.chains[k], self.tolerances[k])

    def separate(self):
        """Refines until no line crosses another."""
        while True:
            points, segments, owners = segments_of(self.lines)
            wrong = set(owners[crossings(points, segments)].ravel().tolist())
            wrong |= {k for k, line in enumerate(self.lines) if is_degenerate(line, self.chains[k])}
            if not wrong:
                return points, segments, owners
            self.refine(wrong)

    def net(self, snap):
        points, segments, owners = self.separate()
        labels = {}
        for (i, j), k in zip(segments.tolist(), owners.tolist()):
            labels[i, j], labels[j, i] = self.chains[k].left, self.chains[k].right
        return Net(points, labels, snap)

    def beside(self, labels):
        """Numbers of the chains that bound one of these labels."""
        return [k for k, chain in enumerate(self.chains) if {chain.left, chain.right} & labels]


def blocks_of(labels, tolerance):
    """(points, [(label, ring)]): simple counter-clockwise polygons that fill the picture, rings of points' numbers.

    labels: (height, width) whole numbers, 0 where nothing is. Cuts end in points that are nearer than the tolerance [pixels].
    """
    lines = Simplified(chains_of(labels), tolerance)
    while True:
        net = lines.net(tolerance)
        around = [(net.labels_of(ring), ring) for ring in net.faces(lambda loop, net=net: net.labels_of(loop) != {OUTSIDE})]
        mixed = set().union(*(labels_left for labels_left, _ in around if len(labels_left) > 1))
        if not mixed:
            found = [(labels_left.pop(), ring) for labels_left, ring in around]
            return net.points, [(label, ring) for label, ring in found if label > 0]
        lines.refine(lines.beside(mixed))
