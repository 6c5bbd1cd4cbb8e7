"""The dictionary `scene` of polygons that share their points."""

from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from .faults import SceneError

EDGES = {"left": (0, min), "right": (0, max), "bottom": (1, min), "top": (1, max)}


@dataclass(frozen=True)
class Scale:
    """unit: the side of a pixel [L]."""

    unit: float

    @classmethod
    def of_picture(cls, file, shape, extent):
        """Of a picture of (rows, columns) whose (width, height) [L] is given, one of them at least."""
        rows, columns = shape
        width, height = (given(file, name, value) for name, value in zip(("width", "height"), extent))
        if width is None and height is None:
            raise SceneError(f"{file}: how large is it? Give its width or its height in the units of the deck")
        found = width / columns if width is not None else height / rows
        if width is not None and height is not None and abs(found * rows - height) > found:
            raise SceneError(f"{file}: {columns} x {rows} pixels of one size are not {width:g} x {height:g}: give the width or the "
                             "height alone")
        return cls(found)


def given(file, name, value):
    """A length above 0, or None. Throws SceneError."""
    if value is not None and not 0 < value < float("inf"):
        raise SceneError(f"{file}: {name} is {value:g}: give a number above 0")
    return value


@dataclass(frozen=True)
class Block:
    """ring: numbers of its points, counter-clockwise. part: what it is a piece of, a whole number; a part that has not been cut
    is one block. name: of the part, or None: its material's and a number."""

    ring: list
    part: int
    material: str
    name: str | None = None


def names_of(blocks):
    """`stone 3`, or the part's own name; `stone 3.1` of the first piece of a part that has been cut."""
    pieces, parts = defaultdict(int), {}
    for block in blocks:
        pieces[block.part] += 1
        parts[block.part] = block
    alike, numbers, called = defaultdict(int), defaultdict(int), {}
    for block in parts.values():
        alike[block.name or block.material] += 1
    for part, block in parts.items():
        stem = block.name or block.material
        numbers[stem] += 1
        called[part] = stem if block.name and alike[stem] == 1 else f"{stem} {numbers[stem]}"
    out, piece = [], defaultdict(int)
    for block in blocks:
        piece[block.part] += 1
        out.append(called[block.part] + (f".{piece[block.part]}" if pieces[block.part] > 1 else ""))
    return out


def scene_of_blocks(points, blocks):
    """A scene of type polygons; points: (n, 2) [L]."""
    regions = [{"name": name, "material": block.material,
                "vertices": [[float(value) for value in points[vertex]] for vertex in block.ring]}
               for name, block in zip(names_of(blocks), blocks)]
    return {"type": "polygons", "regions": regions, "boundaries": boundaries(points, [block.ring for block in blocks])}


def free_sides(rings):
    """Sides (i, j) of one block alone."""
    sides = {(i, j) for ring in rings for i, j in zip(ring, [*ring[1:], ring[0]])}
    return [(i, j) for i, j in sides if (j, i) not in sides]


def boundaries(points, rings):
    """{name: [from, to]} of what is free and straight at the left, right, bottom and top of all; `left 1`, `left 2` where
    it is in pieces."""
    points, free = np.asarray(points, float), free_sides(rings)
    used = sorted({vertex for ring in rings for vertex in ring})
    found = {}
    for name, (axis, extreme) in EDGES.items():
        limit = extreme(points[used, axis].tolist())
        tolerance = 1e-12 * np.ptp(points[used], axis=0).max()
        spans = sorted(sorted((points[i, 1 - axis], points[j, 1 - axis])) for i, j in free
                       if max(abs(points[[i, j], axis] - limit)) <= tolerance)
        pieces = joined(spans, tolerance)
        for k, span in enumerate(pieces, 1):
            ends = [[limit, float(end)] if axis == 0 else [float(end), limit] for end in span]
            found[name if len(pieces) == 1 else f"{name} {k}"] = ends
    return found


def joined(spans, tolerance):
    """Sorted intervals, those that touch as one."""
    out = []
    for low, high in spans:
        if out and low <= out[-1][1] + tolerance:
            out[-1][1] = max(out[-1][1], high)
        else:
            out.append([low, high])
    return out
