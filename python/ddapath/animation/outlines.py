"""Where the blocks are: outlines as complex numbers z = x + iy, polygon by polygon, and how they get from one state to the
next."""

from dataclasses import dataclass

import numpy as np

from ..errors import NothingStored
from ..fields import text_of
from ..run_folder import MESH, opened


@dataclass(frozen=True)
class Outlines:
    """z: the vertices of all polygons one after another; polygon p has those from offsets[p] to offsets[p + 1]."""

    z: np.ndarray
    offsets: np.ndarray

    @classmethod
    def of(cls, polygons):
        offsets = np.concatenate([[0], np.cumsum([len(polygon) for polygon in polygons])])
        vertices = np.concatenate(polygons)
        return cls(vertices[:, 0] + 1j * vertices[:, 1], offsets)

    @property
    def polygons(self):
        """A list of k × 2 arrays."""
        return np.split(np.column_stack([self.z.real, self.z.imag]), self.offsets[1:-1])

    def sums(self, values):
        """Of values per vertex over each polygon."""
        return np.add.reduceat(values, self.offsets[:-1])

    def spread(self, values):
        """Values per polygon, at each of its vertices."""
        return np.repeat(values, np.diff(self.offsets))

    @property
    def centres(self):
        """The means of the vertices."""
        return self.sums(self.z) / np.diff(self.offsets)

    def box(self, which=None):
        """[x_least, y_least, x_largest, y_largest] of the polygons that are meant."""
        z = self.z if which is None else self.z[self.spread(which)]
        return np.array([z.real.min(), z.imag.min(), z.real.max(), z.imag.max()])


def between(before, after, share):
    """Each polygon on its way from one place to another: centre and shape go straight, the angle turns evenly.

    z = c + e^{iθs} ((1 − s) q_a + s e^{−iθ} q_b), θ the rotation that takes q_a nearest to q_b, less than half a turn.
    """
    centres = before.centres, after.centres
    shapes = [outlines.z - outlines.spread(centre) for outlines, centre in zip((before, after), centres)]
    angle = before.spread(np.angle(before.sums(np.conj(shapes[0]) * shapes[1])))
    shape = (1 - share) * shapes[0] + share * np.exp(-1j * angle) * shapes[1]
    centre = before.spread((1 - share) * centres[0] + share * centres[1])
    return Outlines(centre + np.exp(1j * angle * share) * shape, before.offsets)


def materials_of(run):
    """The material of each region, a list of names; None where the run does not say."""
    for folder in (run.folder, run.folder / "motion"):
        try:
            with opened(folder / MESH) as file:
                if "model/region_materials" in file:
                    return [text_of(name) for name in file["model/region_materials"][()]]
        except NothingStored:
            pass  # of a path and a motion one may be there alone
    regions = run.deck["scene"].get("regions")
    return [region["material"] for region in regions] if regions else None


def names_of(region, materials):
    """The material of every block; of a run that does not say, a name for each region."""
    return [materials[number] if materials else f"region {number}" for number in region]
