"""Paths of an SVG drawing."""

import math
from pathlib import Path as FilePath

import numpy as np

from ..needed import from_debian
from .drawing import Path, scene_of_paths
from .faults import SceneError
from .scaled import Units, scaled

LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
MOST_PIECES = 4096  # of a curve
DIGITS = 12  # of coordinates: the library multiplies by pixels of the screen, which leaves noise in those beyond
PACKAGE = "python3-svgelements"


def scene_of_svg(file, *, units=Units(), tolerance=None, without=()):
    """The scene of the paths and shapes of an SVG drawing; y upwards, the lower left corner of the sheet at (0, 0).

    The layer of a shape, its material, is its class, else the name (inkscape:label, class or id) of the innermost group
    around it, else its own id. The region's name is its inkscape:label or id. Each closed part of a path is a shape.
    units: of the user units of the drawing (of its viewBox). Curves are flattened to half the tolerance [L], see scene_of_paths,
    also for `without`.
    Throws SceneError with file and place, ModuleMissing.
    """
    svgelements = from_debian("svgelements", PACKAGE)
    if not FilePath(file).is_file():
        raise SceneError(f"{file}: there is no such file")
    try:
        drawing = svgelements.SVG.parse(str(file))
    except (SyntaxError, ValueError, OSError) as error:  # ParseError of XML is a SyntaxError
        raise SceneError(f"{file}: no SVG that can be read ({error}): save it as plain SVG") from error
    shapes = list(shapes_of(svgelements, drawing, None))
    return scene_of_paths(file, *scaled(file, Sheet(svgelements, drawing, file), shapes, (units, tolerance)), without)


def layer_of(element):
    """The name that a group or shape has of its own: (inkscape:label, class, id)."""
    own = element.values.get("attributes", {})
    return own.get(LABEL), own.get("class"), own.get("id")


def shapes_of(svgelements, group, layer):
    """(shape, name of the group around it or None) of all shapes, in the order of the drawing."""
    for element in group:
        if isinstance(element, svgelements.Group):
            yield from shapes_of(svgelements, element, next(filter(None, layer_of(element)), layer))
        elif isinstance(element, svgelements.Shape):
            yield element, layer


class Sheet:
    """Shapes as paths, in the drawing's user units, y upwards from the bottom of the sheet."""

    def __init__(self, svgelements, drawing, file):
        self.svgelements, self.file = svgelements, file
        box, width = drawing.viewbox, drawing.width
        self.unit = box.width / width if box is not None and box.width and width else 1.0
        self.height = float(drawing.height or 0.0)
        sheet = max(self.height, float(width or 0.0)) * self.unit
        self.decimals = DIGITS - math.ceil(math.log10(sheet)) if sheet > 0 else DIGITS

    def paths(self, shapes, tolerance):
        """Of all shapes, curves flattened to a tolerance [user units]; None: their ends and middles alone."""
        out = []
        for number, (shape, around) in enumerate(shapes, 1):
            label, style, name = layer_of(shape)
            layer = style or around or name
            if layer is None:
                raise SceneError(f"{self.file}: shape {number}: nothing tells its material: give it a class, an id, or put it into a "
                                 "named group")
            whole = self.svgelements.Path(shape)
            for part in whole.as_subpaths():
                points, is_closed = self.flattened(part, tolerance)
                if len(points) > 1:
                    out.append(Path(layer, label or name, points, is_closed, f"{self.file}: '{layer}', shape {name or number}"))
        return out

    def flattened(self, part, tolerance):
        """((n, 2) points, is it closed?) of one part of a path."""
        kinds = self.svgelements
        points, is_closed = [], False
        for segment in part:
            is_closed = is_closed or isinstance(segment, kinds.Close)
            if isinstance(segment, kinds.Move):
                points.append(segment.end)
            elif isinstance(segment, (kinds.Line, kinds.Close)):
                points += [segment.end] if segment.end is not None else []
            else:
                points += pieces(segment, None if tolerance is None else tolerance / self.unit)
        flat = np.array([(point.x * self.unit, (self.height - point.y) * self.unit) for point in points]).reshape(-1, 2)
        is_closed = is_closed or (len(flat) > 3 and bool((flat[0] == flat[-1]).all()))
        repeats = is_closed and len(flat) > 1 and math.dist(flat[0], flat[-1]) <= 1e-9 * float(np.abs(flat).max())
        return np.round(flat[:-1] if repeats else flat, self.decimals), is_closed


def pieces(segment, tolerance):
    """Points along a curve after its start, so many that the middles of the chords are within the tolerance of it."""
    count = 2
    while tolerance is not None and count < MOST_PIECES:
        at = [segment.point(k / (2 * count)) for k in range(2 * count + 1)]
        off = max(abs(complex(at[k].x, at[k].y) - (complex(at[k - 1].x, at[k - 1].y) + complex(at[k + 1].x, at[k + 1].y)) / 2)
                  for k in range(1, 2 * count, 2))
        if off <= tolerance:
            break
        count *= 2
    return [segment.point(k / count) for k in range(1, count + 1)]
