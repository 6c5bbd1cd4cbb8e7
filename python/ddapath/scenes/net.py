"""A plane net of straight edges, and its faces as simple polygons.

    net = Net(points, {(i, j): label on the left of the way from i to j})
    rings = net.faces(is_region)           # counter-clockwise lists of points' numbers

Blocks have no holes. Where edges of the net lie around a hole of a face, or touch its outline in one point, the face is cut along
horizontal lines: from the rightmost point of each hole to what is on its right, and from the leftmost point of those that no
such line has come to. Following them one comes to the outline of the face on either side, so that no cut is a dead
end and each piece is simple.
"""

import math

import numpy as np

from .crossings import is_crossed


def area(corners):
    """Of a polygon, (n, 2) corners [L]; above 0 where they are counter-clockwise [L²]."""
    x, y = np.asarray(corners, float).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def simple_loops(ring):
    """A closed walk that comes by a point twice, as loops that do not; there and back again along an edge is no loop."""
    found, walk, place = [], [], {}
    for vertex in ring:
        if vertex in place:
            first = place[vertex]
            found.append(walk[first:])
            for left in walk[first + 1:]:
                del place[left]
            del walk[first + 1:]
        else:
            place[vertex] = len(walk)
            walk.append(vertex)
    return [loop for loop in [*found, walk] if len(loop) > 2]


class Net:
    """points: a list of (x, y) [L]. labels: of each edge and direction, {(i, j): what is on its left}; None of a cut.

    `snap` [L]: a cut that would end as near as that to a point ends there.
    """

    def __init__(self, points, labels, snap=0.0):
        self.points, self.labels, self.snap = [tuple(point) for point in points], dict(labels), snap

    def corners(self, loop):
        return np.array([self.points[vertex] for vertex in loop])

    def segments(self):
        """(n, 2) numbers of points, each edge once."""
        return np.array([edge for edge in self.labels if edge[0] < edge[1]], int).reshape(-1, 2)

    def rings(self):
        """Closed walks along edges with a face on their left: outlines counter-clockwise, holes clockwise."""
        neighbours = {}
        for i, j in self.labels:
            (x, y), (u, v) = self.points[i], self.points[j]
            neighbours.setdefault(i, []).append((math.atan2(v - y, u - x), j))
        after = {}
        for i, around in neighbours.items():
            around.sort()
            for (_, before), (_, vertex) in zip([around[-1], *around], around):
                after[vertex, i] = (i, before)
        found, waiting = [], dict.fromkeys(self.labels)
        while waiting:
            edge, ring = next(iter(waiting)), []
            while edge in waiting:
                del waiting[edge]
                ring.append(edge[0])
                edge = after[edge]
            found.append(ring)
        return found

    def loops(self):
        return [loop for ring in self.rings() for loop in simple_loops(ring)]

    def hit(self, vertex, side):
        """What a horizontal ray from a point to the left (-1) or right (1) meets first: (x, i, j), or None.

        i == j where that is a point; None as well where an edge already leaves the point in that direction.
        """
        points, segments = np.array(self.points), self.segments()
        x, y = points[vertex]
        own = (segments == vertex).any(axis=1)
        ends = points[segments[own].sum(axis=1) - vertex]
        if ((ends[:, 1] == y) & ((ends[:, 0] - x) * side > 0)).any():
            return None
        rest = segments[~own]
        start, end = points[rest[:, 0]], points[rest[:, 1]]
        spans = (np.minimum(start[:, 1], end[:, 1]) <= y) & (np.maximum(start[:, 1], end[:, 1]) >= y)
        rest, start, end = rest[spans], start[spans], end[spans]
        rise = end[:, 1] - start[:, 1]
        share = np.divide(y - start[:, 1], rise, out=np.zeros(len(rest)), where=rise != 0)
        at = np.where(share == 1, end[:, 0], start[:, 0] + share * (end[:, 0] - start[:, 0]))
        level = rise == 0
        at[level] = side * np.minimum(side * start[level, 0], side * end[level, 0])
        ahead = (at - x) * side > 0
        if not ahead.any():
            return None
        nearest = np.flatnonzero(ahead)[np.argmin(side * at[ahead])]
        i, j = map(int, rest[nearest])
        for corner in (i, j):
            if self.points[corner] == (at[nearest], y):
                return float(at[nearest]), corner, corner
        return float(at[nearest]), i, j

    def end_of_cut(self, vertex, hit):
        """The point on an edge where a cut ends: an end of that edge where it is near and in sight, else a new one."""
        at, i, j = hit
        place = (at, self.points[vertex][1])
        near = min((i, j), key=lambda corner: math.dist(place, self.points[corner]))
        if i == j or (math.dist(place, self.points[near]) <= self.snap and self.in_sight(vertex, near)):
            return near
        new = len(self.points)
        self.points.append(place)
        for one, other in ((i, j), (j, i)):
            label = self.labels.pop((one, other))
            self.labels[one, new] = self.labels[new, other] = label
        return new

    def in_sight(self, vertex, other):
        if (vertex, other) in self.labels:
            return False
        return not is_crossed(self.points, self.segments(), (vertex, other))

    def cut(self, loop, side):
        """A cut from the leftmost (-1) or rightmost (1) point of a loop, of those the lowest; whether there is a new one."""
        vertex = min(loop, key=lambda corner: (-side * self.points[corner][0], self.points[corner][1]))
        hit = self.hit(vertex, side)
        if hit is None:
            return False
        end = self.end_of_cut(vertex, hit)
        self.labels[vertex, end] = self.labels[end, vertex] = None
        return True

    def labels_of(self, loop):
        """The labels on the left of a loop, cuts aside."""
        return {self.labels[edge] for edge in zip(loop, [*loop[1:], loop[0]])} - {None}

    def is_reached(self, loop):
        """Whether a cut has come to a loop from the left."""
        here = set(loop)
        return any(label is None and j in here and i not in here and self.points[i][0] < self.points[j][0]
                   for (i, j), label in self.labels.items())

    def faces(self, is_region):
        """Counter-clockwise simple loops, all bounded faces, those cut for which is_region(loop) says so.

        is_region is asked of clockwise loops: does it lie in a face that becomes blocks?
        """
        made, side = True, 1
        while True:
            loops = self.loops()
            signed = [area(self.corners(loop)) for loop in loops]
            holes = [loop for loop, size in zip(loops, signed) if size < 0 and is_region(loop)]
            wanted = holes if side > 0 or not made else [loop for loop in holes if not self.is_reached(loop)]
            added = [self.cut(loop, side) for loop in wanted]
            if not any(added) and not (made and holes):
                return [loop for loop, size in zip(loops, signed) if size > 0]
            made, side = any(added), -1
