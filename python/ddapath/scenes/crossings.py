"""Straight segments that meet where they may not: anywhere but in a common end."""

import numpy as np


def pairs_near(low, high):
    """(n, 2) numbers of boxes that have a point in common; low, high: (m, 2) corners of the boxes."""
    order = np.argsort(low[:, 0], kind="stable")
    ends = np.searchsorted(low[order, 0], high[order, 0], side="right")
    found = [np.empty((0, 2), int)]
    for k, end in enumerate(ends):
        i, others = order[k], order[k + 1:end]
        others = others[(low[others, 1] <= high[i, 1]) & (high[others, 1] >= low[i, 1])]
        if len(others):
            found.append(np.column_stack([np.full(len(others), i), others]))
    return np.concatenate(found)


def turn(a, b, c):
    """Twice the areas of triangles (a, b, c), above 0 where they are counter-clockwise; arrays (n, 2)."""
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def meet_at_end(points, first, second):
    """Whether two segments with a common end lie on each other; (n, 2) numbers of points."""
    swapped = (first[:, 1] == second[:, 0]) | (first[:, 1] == second[:, 1])
    common = np.where(swapped, first[:, 1], first[:, 0])
    one = points[np.where(swapped, first[:, 0], first[:, 1])] - points[common]
    other = points[np.where(second[:, 0] == common, second[:, 1], second[:, 0])] - points[common]
    cross = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return (cross == 0) & ((one * other).sum(axis=1) > 0)


def crossings(points, segments):
    """(n, 2) numbers of segments that touch beyond a common end.

    points: (m, 2) [L]; segments: (k, 2) numbers of points. Exact for whole-numbered coordinates.
    """
    points, segments = np.asarray(points, float), np.asarray(segments, int).reshape(-1, 2)
    if not len(segments):
        return np.empty((0, 2), int)
    start, end = points[segments[:, 0]], points[segments[:, 1]]
    pairs = pairs_near(np.minimum(start, end), np.maximum(start, end))
    return pairs[touch(points, segments[pairs[:, 0]], segments[pairs[:, 1]])]


def touch(points, first, second):
    """Whether pairs of segments, whose boxes do, touch beyond a common end; first, second: (n, 2) numbers of points."""
    start, end, other, last = points[first[:, 0]], points[first[:, 1]], points[second[:, 0]], points[second[:, 1]]
    shares = (first[:, :, None] == second[:, None, :]).any(axis=(1, 2))
    wrong = (turn(start, end, other) * turn(start, end, last) <= 0) & (turn(other, last, start) * turn(other, last, end) <= 0) & ~shares
    wrong[shares] = meet_at_end(points, first[shares], second[shares])
    return wrong


def is_crossed(points, segments, segment):
    """Whether a segment touches any of the others beyond a common end."""
    points, segments = np.asarray(points, float), np.asarray(segments, int).reshape(-1, 2)
    corners, (low, high) = points[segments], np.sort(points[list(segment)], axis=0)
    near = segments[((corners.min(axis=1) <= high) & (corners.max(axis=1) >= low)).all(axis=1)]
    return bool(touch(points, np.tile(np.array(segment, int), (len(near), 1)), near).any())
