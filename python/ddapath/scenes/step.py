"""Faces of a STEP file."""

from contextlib import contextmanager
from pathlib import Path as FilePath

import numpy as np

from ..needed import from_debian
from .drawing import Path, scene_of_paths
from .dxf import chained
from .faults import SceneError
from .net import area
from .scaled import Units, scaled

HOLE = "hole of a face"  # the layer of an outline inside a face
WITHOUT_NAME = "body"
UNNAMED = "Open CASCADE"  # what the translator calls a product that has no name of its own; its instances are numbers
ROUGH = 1e-2  # of a curve's size, to tell the extent
FINEST = 4096  # chords of a curve


def scene_of_step(file, *, units=Units(), tolerance=None, without=()):
    """The scene of the plane faces of a STEP file (AP203, AP214, AP242), in the plane of x and y; in millimetres times the scale.

    The innermost named product is the material, `body` where there is none. Holes of a face stay empty where no other face fills
    them. units: of millimetres. Curves are flattened to half the tolerance [L], see scene_of_paths, also for `without`.
    Throws SceneError with file and face, ModuleMissing without gmsh.
    """
    gmsh = from_debian("gmsh", "python3-gmsh")
    if not FilePath(file).is_file():
        raise SceneError(f"{file}: there is no such file")
    with session(gmsh):
        sheet = Faces(file, gmsh.model)
        paths, tolerance = scaled(file, sheet, sheet.read(), (units, tolerance))
    paths = without_filled_holes(paths, tolerance)
    holes = (HOLE,) if any(path.layer == HOLE for path in paths) else ()
    return scene_of_paths(file, paths, tolerance, (*without, *holes))


@contextmanager
def session(gmsh):
    """A model of gmsh's own, which says nothing."""
    gmsh.initialize(readConfigFiles=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
        yield
    finally:
        gmsh.finalize()


class Faces:
    """Faces as paths: the outline, and a path on a layer of its own for each hole."""

    def __init__(self, file, model):
        self.file, self.model = file, model

    def read(self):
        """The tags of the faces."""
        try:
            found = self.model.occ.importShapes(str(self.file))
            self.model.occ.synchronize()
        except Exception as error:  # gmsh throws no other
            raise SceneError(f"{self.file}: no STEP file that can be read ({error}): export it anew") from None
        if any(dimension == 3 for dimension, _ in found):
            raise SceneError(f"{self.file}: has solids; blocks lie in the plane of x and y: export the face of a section")
        faces = [tag for dimension, tag in self.model.getEntities(2)]
        if not faces:
            raise SceneError(f"{self.file}: has no faces: export regions as faces, not as wires")
        return faces

    def name(self, tag):
        parts = [part for part in self.model.getEntityName(2, tag).split("/")[1:] if not part.isdecimal() and not part.startswith(UNNAMED)]
        return parts[-1] if parts else WITHOUT_NAME

    def paths(self, faces, tolerance):
        out = []
        for tag in faces:
            outlines = self.outlines(tag, tolerance)
            out += [Path(HOLE if k else self.name(tag), None, path.points, True, path.place) for k, path in enumerate(outlines)]
        return out

    def outlines(self, tag, tolerance):
        """The closed paths around a face, the outer one first."""
        place = f"{self.file}: face {tag} ({self.name(tag)})"
        pieces = []
        for _, curve in self.model.getBoundary([(2, tag)], oriented=False):
            points = self.chords(curve, tolerance)
            if np.ptp(points[:, 2]) > 1e-6 * max(np.ptp(points, axis=0).max(), 1e-300):
                raise SceneError(f"{place}: does not lie in the plane of x and y: turn it there")
            is_closed = bool(np.allclose(points[0], points[-1], rtol=0, atol=1e-9 * np.ptp(points, axis=0).max()))
            pieces.append(Path("", None, points[:-1, :2] if is_closed else points[:, :2], is_closed, place))
        size = max(np.ptp(piece.points, axis=0).max() for piece in pieces)
        closed = chained(pieces, 1e-6 * size)
        if not all(path.is_closed for path in closed):
            raise SceneError(f"{place}: its edges do not close: heal it before it is exported")
        return sorted(closed, key=lambda path: -abs(area(path.points)))

    def chords(self, curve, tolerance):
        """(n, 3) points of a curve; chords are within the tolerance, roughly where that is None."""
        (low,), (high,) = self.model.getParametrizationBounds(1, curve)

        def at(count):
            where = np.linspace(low, high, count + 1)
            return np.reshape(self.model.getValue(1, curve, where.tolist()), (-1, 3))

        count = 1 if self.model.getType(1, curve) == "Line" else 8
        points = at(count)
        bound = ROUGH * np.ptp(points, axis=0).max() if tolerance is None else tolerance
        while count > 1 and count < FINEST:
            finer = at(2 * count)
            if np.linalg.norm(finer[1::2] - (points[1:] + points[:-1]) / 2, axis=1).max() <= bound:
                break
            count, points = 2 * count, finer
        return points


def without_filled_holes(paths, tolerance):
    """A hole that one face fills is that face's outline."""
    def is_same(one, other):
        return (np.abs(np.ptp(one, axis=0) - np.ptp(other, axis=0)).max() <= tolerance
                and np.abs(one.min(axis=0) - other.min(axis=0)).max() <= tolerance
                and abs(abs(area(one)) - abs(area(other))) <= tolerance * np.ptp(one, axis=0).sum())

    faces = [path for path in paths if path.layer != HOLE]
    return faces + [path for path in paths if path.layer == HOLE and not any(is_same(path.points, face.points) for face in faces)]
