"""Paths of a drawing on common points: what is nearly the same becomes the same."""

import numpy as np

from ..needed import from_debian

MOST_PASSES = 8
OF_POINTS = 0.5  # of the tolerance: a side whose ends have moved by that is still within the tolerance of what was on it


def tree_of(points):
    return from_debian("scipy.spatial", "python3-scipy").cKDTree(points)


def representatives(points, tolerance):
    """For each of (n, 2) points the number of the first that it coincides with, within the tolerance [L]."""
    first = np.arange(len(points))
    for i, j in sorted(tree_of(points).query_pairs(tolerance)):
        if first[i] == i and first[j] == j:
            first[j] = i
    return first


def without_repeats(ring, is_closed):
    """Numbers of points, no two that follow each other the same; of a closed one without ways there and back again."""
    out = []
    for vertex in ring:
        if out and out[-1] == vertex:
            continue
        if is_closed and len(out) > 1 and out[-2] == vertex:
            out.pop()
        else:
            out.append(vertex)
    while is_closed and len(out) > 1 and out[0] == out[-1]:
        out.pop()
    while is_closed and len(out) > 2 and out[1] == out[-1]:
        del out[0], out[-1]
    while is_closed and len(out) > 2 and out[0] == out[-2]:
        del out[-2:]
    return out


def on_side(points, side, candidates, tolerance):
    """Those of the candidates that lie on a side, ends aside, from its start to its end."""
    i, j = side
    along = points[j] - points[i]
    length = np.hypot(*along)
    away = points[candidates] - points[i]
    share = away @ along / length**2
    off = np.abs(away[:, 0] * along[1] - away[:, 1] * along[0]) / length
    on = (off <= tolerance) & (share > 0) & (share < 1) & (candidates != i) & (candidates != j)
    return candidates[on][np.argsort(share[on], kind="stable")].tolist()


def refined(points, ring, is_closed, how):
    """A path with all points that lie on its sides; how: (tree of the points in use, their numbers, tolerance)."""
    tree, used, tolerance = how
    ends = [*ring[1:], ring[0]] if is_closed else ring[1:]
    out = []
    for side in zip(ring, ends):
        middle, half = points[list(side)].mean(axis=0), np.hypot(*(points[side[1]] - points[side[0]])) / 2
        near = used[tree.query_ball_point(middle, half + tolerance)]
        out += [side[0], *(vertex for vertex in on_side(points, side, near, tolerance) if vertex not in ring)]
    return out if is_closed else [*out, ring[-1]]


def snapped(paths, tolerance):
    """(points, rings): the paths' points, those within half the tolerance of an earlier one replaced by it, and for each path
    the numbers of its points, with those that lie within the tolerance of its sides.

    paths: [((n, 2) points [L], is it closed)].
    """
    points = np.concatenate([corners for corners, _ in paths])
    first = representatives(points, OF_POINTS * tolerance)
    starts = np.cumsum([0, *(len(corners) for corners, _ in paths)])
    rings = [without_repeats(first[begin:end].tolist(), closed)
             for begin, end, (_, closed) in zip(starts, starts[1:], paths)]
    for _ in range(MOST_PASSES):
        used = np.unique(np.concatenate([np.array(ring, int) for ring in rings]))
        how = (tree_of(points[used]), used, tolerance)
        finer = [without_repeats(refined(points, ring, closed, how), closed) if len(ring) > 1 else ring for ring, (_, closed) in zip(rings, paths)]
        if finer == rings:
            break
        rings = finer
    return points, rings
