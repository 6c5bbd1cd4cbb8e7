"""Scenes from the paths of a drawing."""

import re
from dataclasses import dataclass

import numpy as np

from .assembled import Block, scene_of_blocks
from .crossings import crossings
from .faults import SceneError
from .net import Net, area
from .snapped import snapped

LINE = re.compile(r"(curve|slit|boundary)[ _:-]+(.+)")
SECTIONS = {"curve": "curves", "slit": "slits", "boundary": "boundaries"}
RELATIVE = 1e-3  # tolerance by default, of the larger extent


@dataclass(frozen=True)
class Path:
    """points: (n, 2) [L], y upwards, the first of a closed one not repeated. place: of what file, layer and entity it is."""

    layer: str
    name: str | None
    points: np.ndarray
    is_closed: bool
    place: str

    @property
    def role(self):
        """("curve", "slit" or "boundary", its name) of a layer that is called so, else None."""
        found = LINE.fullmatch(self.layer)
        return found.groups() if found else None


def extent_of(paths):
    """(lower left, upper right) of all points."""
    points = np.concatenate([path.points for path in paths])
    return points.min(axis=0), points.max(axis=0)


def scene_of_paths(file, paths, tolerance=None, without=()):
    """The scene of closed paths, a region each, named after its layer and a number where it has no name of its own.

    The material is the layer. Where a path lies inside another its material fills it, and what is around it is cut so that
    no block has a hole. Open paths on layers `curve-NAME`, `slit-NAME`, `boundary-NAME` become lines of that name. Points within
    the tolerance [L] of a side, or half of it of each other, become one; by default a thousandth of the larger extent.
    without: layers whose closed paths are holes.
    Throws SceneError for an open path on another layer, paths that cross, or a drawing without closed paths.
    """
    regions, lines = sorted_out(file, paths)
    if not regions:
        raise SceneError(f"{file}: there is no closed path: close the outlines of the regions")
    low, high = extent_of(regions)
    tolerance = RELATIVE * float((high - low).max()) if tolerance is None else tolerance
    if not 0 < tolerance < float("inf"):
        raise SceneError(f"{file}: the tolerance is {tolerance:g}: give a number above 0")
    points, rings = snapped([(path.points, path.is_closed) for path in [*regions, *lines]], tolerance)
    outlines, polylines = rings[:len(regions)], rings[len(regions):]
    require_sound(points, outlines, regions)
    found = filled(points, outlines, tolerance)
    scene = scene_of_blocks(*named_blocks(file, found, (regions, without)))
    for path, line in zip(lines, polylines):
        kind, name = path.role
        scene.setdefault(SECTIONS[kind], {})[name] = points[line].tolist()
    return scene


def sorted_out(file, paths):
    """(closed ones that are regions, lines)."""
    lines = [path for path in paths if path.role]
    regions = [path for path in paths if not path.role]
    for path in regions:
        if not path.is_closed:
            raise SceneError(f"{path.place}: an open path: close it, or call its layer curve-NAME, slit-NAME or boundary-NAME")
    for path in paths:
        if not np.isfinite(path.points).all():
            raise SceneError(f"{path.place}: a coordinate is no number: remove it")
    taken = set()
    for path in lines:
        if path.role in taken:
            raise SceneError(f"{path.place}: a second path on its layer: a line is one path, give each a layer of its own")
        taken.add(path.role)
    return regions, lines


def require_sound(points, outlines, regions):
    """Throws SceneError where an outline has shrunk to nothing, comes by a point twice, or sides cross."""
    for ring, path in zip(outlines, regions):
        if len(ring) < 3:
            raise SceneError(f"{path.place}: smaller than the tolerance: lower the tolerance or remove it")
        if len(set(ring)) < len(ring):
            corner = points[next(vertex for vertex in ring if ring.count(vertex) > 1)]
            raise SceneError(f"{path.place}: comes by {place_of(corner)} twice: make several paths of it")
    owner = {}
    for number, ring in enumerate(outlines):
        for side in zip(ring, [*ring[1:], ring[0]]):
            owner.setdefault(tuple(sorted(side)), number)
    segments = np.array(list(owner), int)
    for i, j in crossings(points, segments).tolist():
        one, other = (regions[number] for number in (owner[tuple(segments[i])], owner[tuple(segments[j])]))
        what = "crosses itself" if one is other else f"crosses {other.place}"
        raise SceneError(f"{one.place}: {what} near {place_of(crossing_of(points[segments[i]], points[segments[j]]))}: draw regions side by side or one inside another, or raise "
                         "the tolerance")


def crossing_of(one, other):
    """Where two segments cross, (2, 2) ends each; of parallel ones, which lie on each other, the middle of what they share."""
    along, across = one[1] - one[0], other[1] - other[0]
    turn = along[0] * across[1] - along[1] * across[0]
    if abs(turn) > 1e-12 * np.linalg.norm(along) * np.linalg.norm(across):
        apart = other[0] - one[0]
        return one[0] + (apart[0] * across[1] - apart[1] * across[0]) / turn * along
    places = np.concatenate([one, other])
    return places[np.argsort(places @ along)[1:3]].mean(axis=0)


def place_of(point):
    return f"({point[0]:.6g}, {point[1]:.6g})"


def meets_level(corners, y):
    """Sorted x of where the outline of a polygon meets a horizontal line, which touches none of its corners."""
    start, end = corners, np.roll(corners, -1, axis=0)
    spans = (start[:, 1] > y) != (end[:, 1] > y)
    start, end = start[spans], end[spans]
    return np.sort(start[:, 0] + (y - start[:, 1]) / (end[:, 1] - start[:, 1]) * (end[:, 0] - start[:, 0]))


def is_inside(point, corners):
    """Whether a point lies in a polygon, (n, 2) corners."""
    return bool((meets_level(corners, point[1]) > point[0]).sum() % 2)


def point_inside(corners):
    """A point in a simple polygon: the middle of the longest stretch of horizontal lines between the levels of its corners.

    Levels that only rounding parts have nothing between them.
    """
    levels = np.unique(corners[:, 1])
    are_apart = np.diff(levels) > 1e-9 * np.ptp(levels)
    best = (0.0, None)
    for y in ((levels[1:] + levels[:-1]) / 2)[are_apart].tolist():
        at = meets_level(corners, y)
        k = 2 * int(np.argmax(at[1::2] - at[::2]))
        best = max(best, (float(at[k + 1] - at[k]), ((at[k] + at[k + 1]) / 2, y)), key=lambda found: found[0])
    return best[1]


def filled(points, outlines, tolerance):
    """(net, [(ring, number of the path that fills it)]): the blocks between all outlines, cut where they had holes.

    What is narrower than the tolerance, between sides that were to be the same, goes to the neighbour.
    """
    labels = {}
    for ring in outlines:
        for i, j in zip(ring, [*ring[1:], ring[0]]):
            labels[i, j] = labels[j, i] = None
    net = Net(points.tolist(), labels, tolerance)
    corners = [points[ring] for ring in outlines]
    by_size = sorted(range(len(outlines)), key=lambda k: (abs(area(corners[k])), -k))

    def filling(point):
        return next((k for k in by_size if is_inside(point, corners[k])), None)

    def is_region(loop):
        return filling(point_beside(net, loop)) is not None

    rings = net.faces(is_region)
    while joined_to_neighbours(net, [ring for ring in rings if is_narrow(net.corners(ring), tolerance)], rings):
        rings = net.faces(is_region)
    found = [(ring, filling(point_inside(net.corners(ring)))) for ring in rings]
    return net, [(ring, path) for ring, path in found if path is not None]


def is_narrow(corners, breadth):
    """Whether the mean breadth of a polygon, its area over half the length of its outline, is below a length [L]."""
    outline = np.hypot(*(corners - np.roll(corners, 1, axis=0)).T).sum()
    return 2 * area(corners) < breadth * outline


def joined_to_neighbours(net, slivers, rings):
    """Takes out the sides between slivers and the neighbour with the longest common boundary; whether there were any."""
    owner = {side: k for k, ring in enumerate(rings) for side in zip(ring, [*ring[1:], ring[0]])}
    touched = set()
    for ring in slivers:
        shared = {}
        for i, j in zip(ring, [*ring[1:], ring[0]]):
            if (j, i) in owner:
                shared.setdefault(owner[j, i], []).append((i, j))
        if not shared:
            continue
        lengths = {k: sum(np.hypot(*(np.subtract(net.points[i], net.points[j]))) for i, j in sides) for k, sides in shared.items()}
        neighbour, mine = max(lengths, key=lengths.get), owner[ring[0], ring[1]]
        if touched & {neighbour, mine}:
            continue
        touched |= {neighbour, mine}
        for i, j in shared[neighbour]:
            del net.labels[i, j], net.labels[j, i]
    return bool(touched)


def point_beside(net, loop):
    """A point in the face around a hole: between its rightmost point and what is on the right of that."""
    vertex = max(loop, key=lambda corner: (net.points[corner][0], -net.points[corner][1]))
    hit = net.hit(vertex, 1)
    x, y = net.points[vertex]
    return (x + (hit[0] if hit else x)) / 2, y


def named_blocks(file, found, how):
    """Arguments of scene_of_blocks, in the order of the drawing; how: (closed paths, layers that become nothing)."""
    (net, blocks), (regions, without) = found, how
    layers = {path.layer for path in regions}
    for layer in without:
        if layer not in layers:
            raise SceneError(f"{file}: no closed path is on a layer '{layer}': there are {', '.join(sorted(layers))}")
    kept = [Block(ring, path, regions[path].layer, regions[path].name) for ring, path in blocks
            if regions[path].layer not in without]
    if not kept:
        raise SceneError(f"{file}: nothing is left of it: name fewer layers to be left out")
    return np.array(net.points), sorted(kept, key=lambda block: block.part)
