"""Drawings in the units of a deck."""

from dataclasses import dataclass, replace

from .assembled import given
from .drawing import RELATIVE, extent_of
from .faults import SceneError

FLATTER = 0.5  # of the tolerance: how far the chords of a curve are from it


@dataclass(frozen=True)
class Units:
    """scale: of a unit of the drawing [L]; or the width or height [L] of all that is drawn. Else a unit is a unit."""

    scale: float | None = None
    width: float | None = None
    height: float | None = None

    def factor(self, file, extent):
        """Units of the deck in one of a drawing of this (width, height). Throws SceneError."""
        wanted = [given(file, name, getattr(self, name)) for name in ("scale", "width", "height")]
        if sum(value is not None for value in wanted) > 1:
            raise SceneError(f"{file}: give one of scale, width and height")
        scale, width, height = wanted
        for name, value, size in (("width", width, extent[0]), ("height", height, extent[1])):
            if value is not None and not size > 0:
                raise SceneError(f"{file}: it has no {name}: give the scale")
        return scale or (width / extent[0] if width else height / extent[1] if height else 1.0)


def scaled(file, sheet, shapes, how):
    """(paths in the deck's units, tolerance [L]); how: (units, tolerance [L] or None).

    sheet.paths(shapes, tolerance): the paths in units of the drawing, roughly where the tolerance is None.
    """
    units, tolerance = how
    rough = sheet.paths(shapes, None)
    if not rough:
        raise SceneError(f"{file}: there is no path in it: draw regions as closed paths")
    low, high = extent_of(rough)
    factor = units.factor(file, (high - low).tolist())
    if tolerance is None:
        tolerance = RELATIVE * float((high - low).max()) * factor
    if not 0 < tolerance < float("inf"):
        raise SceneError(f"{file}: the tolerance is {tolerance:g}: give a number above 0")
    paths = sheet.paths(shapes, FLATTER * tolerance / factor)
    return [replace(path, points=path.points * factor) for path in paths], tolerance
