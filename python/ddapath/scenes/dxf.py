"""Paths of a DXF drawing."""

from pathlib import Path as FilePath

import numpy as np

from ..needed import from_debian
from .drawing import Path, scene_of_paths
from .faults import SceneError
from .scaled import Units, scaled

PACKAGE = "python3-ezdxf"
DRAWN = ("LWPOLYLINE", "POLYLINE", "LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE")
ROUGH = 0.1  # of a drawing's units, to tell its extent


def scene_of_dxf(file, *, units=Units(), tolerance=None, without=()):
    """The scene of the polylines, lines, arcs, circles, ellipses and splines in the model space of a DXF drawing, and in its
    blocks; other entities (texts, dimensions, hatches) are passed over. Coordinates are those of the drawing times the scale.

    The layer is the material. Open entities of one layer that meet end to end within the tolerance are one path.
    units: of the drawing's units. Curves are flattened to half the tolerance [L], see scene_of_paths,
    also for `without`.
    Throws SceneError with file and place, ModuleMissing.
    """
    ezdxf = from_debian("ezdxf", PACKAGE)
    if not FilePath(file).is_file():
        raise SceneError(f"{file}: there is no such file")
    try:
        drawing = ezdxf.readfile(str(file))
    except (OSError, ValueError, ezdxf.DXFError) as error:
        raise SceneError(f"{file}: no DXF that can be read ({error}): save it as ASCII DXF, R2000 or later") from error
    entities = list(entities_of(drawing.modelspace()))
    paths, tolerance = scaled(file, Sheet(file), entities, (units, tolerance))
    return scene_of_paths(file, chained(paths, tolerance), tolerance, without)


def entities_of(entities, layer=None):
    """(entity, its layer) of all that is drawn, blocks taken apart; what is on layer 0 of a block is on that of the block."""
    for entity in entities:
        own = entity.dxf.layer if layer is None or entity.dxf.layer != "0" else layer
        if entity.dxftype() == "INSERT":
            yield from entities_of(entity.virtual_entities(), own)
        elif entity.dxftype() in DRAWN:
            yield entity, own


class Sheet:
    """Entities as paths in the drawing's units."""

    def __init__(self, file):
        self.file, self.make_path = file, from_debian("ezdxf.path", PACKAGE).make_path

    def paths(self, entities, tolerance):
        out = []
        for number, (entity, layer) in enumerate(entities, 1):
            flat = self.make_path(entity).flattening(tolerance or ROUGH, 4)
            points = np.array([(point.x, point.y) for point in flat]).reshape(-1, 2)
            if len(points) < 2:
                continue
            size = float(np.ptp(points, axis=0).max())
            is_closed = len(points) > 3 and float(np.abs(points[0] - points[-1]).max()) <= 1e-9 * size
            place = f"{self.file}: layer '{layer}', {entity.dxftype()} {entity.dxf.handle or number}"
            out.append(Path(layer, None, points[:-1] if is_closed else points, is_closed, place))
        return out


def chained(paths, tolerance):
    """Open paths of a layer joined where they meet end to end; those that come back to their start are closed."""
    done, waiting = [], [path for path in paths if not path.is_closed]
    while waiting:
        path = waiting.pop(0)
        while (k := following(path, waiting, tolerance)) is not None:
            path = with_points(path, continued(path.points, waiting.pop(k).points, tolerance), False)
        comes_back = len(path.points) > 3 and np.abs(path.points[0] - path.points[-1]).max() <= tolerance
        done.append(with_points(path, path.points[:-1], True) if comes_back else path)
    return [path for path in paths if path.is_closed] + done


def following(path, others, tolerance):
    """The number of the first of the others that goes on where a path ends, or None."""
    return next((k for k, other in enumerate(others) if other.layer == path.layer
                 and continued(path.points, other.points, tolerance) is not None), None)


def with_points(path, points, is_closed):
    return Path(path.layer, path.name, points, is_closed, path.place)


def continued(points, others, tolerance):
    """The points of a line and those of another that begins or ends at one of its ends, else None."""
    for mine in (points, points[::-1]):
        for other in (others, others[::-1]):
            if np.abs(mine[-1] - other[0]).max() <= tolerance:
                return np.vstack([mine, other[1:]])
    return None
