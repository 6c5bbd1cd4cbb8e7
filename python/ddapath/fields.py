"""Fields of one stored step as tables: over blocks, their vertices, interface points and the points' ends.

Whatever a step's file holds becomes columns: a field `stress` with the components "xx yy xy" is stress_xx, stress_yy and
stress_xy. Zero z components, which ParaView needs, are left out.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pandas as pd

BLOCK, BLOCK_VERTEX, POINT, POINT_END = range(4)  # the attribute `place` of a dataset


@dataclass(frozen=True)
class Mesh:
    """The undeformed geometry [length unit of the deck].

    vertices: outlines of the blocks one after another, n × 2; block b has the rows offsets[b] to offsets[b + 1].
    region: a number per block, by region. segments: the part of its side that each crackable point stands for, m × 2 × 2.
    """

    vertices: np.ndarray
    offsets: np.ndarray
    region: np.ndarray
    segments: np.ndarray
    unit: str

    @property
    def num_blocks(self):
        return len(self.offsets) - 1

    @property
    def polygons(self):
        """The outline of every block, a list of k × 2 arrays."""
        return self.by_block(self.vertices)

    def by_block(self, values):
        """Rows per vertex as a list with one array per block."""
        return np.split(values, self.offsets[1:-1])

    @cached_property
    def fans(self):
        """Signed areas of the triangles (first vertex of the block, vertex, next vertex), and those three's indices.

        Mean of a linear f over a polygon, convex or not: Σ a_i (f_0 + f_i + f_{i+1}) / 3 / Σ a_i.
        """
        first = np.repeat(self.offsets[:-1], np.diff(self.offsets))
        following = np.arange(1, len(self.vertices) + 1)
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        a, b = self.vertices - self.vertices[first], self.vertices[following] - self.vertices[first]
        return (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2, first, following

    @property
    def areas(self):
        """Of the blocks [length unit²]."""
        return np.add.reduceat(self.fans[0], self.offsets[:-1])

    def means(self, values):
        """Mean over each block of what is linear in it and given at its vertices, rows per block."""
        areas, first, following = self.fans
        parts = areas[:, None] * (values[first] + values + values[following]) / 3
        return np.add.reduceat(parts, self.offsets[:-1]) / self.areas[:, None]


@dataclass(frozen=True)
class Field:
    """One dataset of a step: rows by columns, with the names of the columns."""

    name: str
    place: int
    values: np.ndarray
    columns: list
    unit: str


class Fields:
    """The fields of one stored step.

    step, load_factor; numbers: whatever else the step has as attributes; mesh: see Mesh.
    blocks        a row per block: region, area, x, y of the centroid; strain, stress; means over the block of what is
                  given at its vertices, such as the displacement
    vertices      a row per vertex of a block, index (block, vertex): x, y undeformed, displacement
    points        a row per crackable interface point: x, y, normal n and tangential s components of opening, jump and
                  traction, damage
    point_ends    two rows per point, index (point, end): displacement of the middle of the crack
    Units of the columns are in attrs["units"].
    """

    def __init__(self, mesh, numbers, stored):
        self.mesh, self.numbers, self._stored = mesh, dict(numbers), list(stored)
        self.step = int(self.numbers.pop("step"))
        self.load_factor = self.numbers.get("load_factor")

    def __repr__(self):
        return f"<fields of step {self.step}: {', '.join(dict.fromkeys(field.name for field in self._stored))}>"

    @cached_property
    def blocks(self):
        centroids = self.mesh.means(self.mesh.vertices)
        out = {"region": self.mesh.region, "area": self.mesh.areas, "x": centroids[:, 0], "y": centroids[:, 1]}
        units = {"region": "", "area": f"{self.mesh.unit}²", "x": self.mesh.unit, "y": self.mesh.unit}
        averaged = [Field(field.name, BLOCK, self.mesh.means(field.values), field.columns, field.unit)
                    for field in self._at(BLOCK_VERTEX)]
        return self._table(out, units, [*averaged, *self._at(BLOCK)], pd.RangeIndex(self.mesh.num_blocks, name="block"))

    @cached_property
    def vertices(self):
        numbers = np.diff(self.mesh.offsets)
        within = np.arange(len(self.mesh.vertices)) - np.repeat(self.mesh.offsets[:-1], numbers)
        index = pd.MultiIndex.from_arrays([np.repeat(np.arange(len(numbers)), numbers), within], names=("block", "vertex"))
        return self._positioned(self.mesh.vertices, self._at(BLOCK_VERTEX), index)

    @cached_property
    def points(self):
        middles = self.mesh.segments.mean(axis=1)
        return self._positioned(middles, self._at(POINT), pd.RangeIndex(len(middles), name="point"))

    @cached_property
    def point_ends(self):
        index = pd.MultiIndex.from_product([range(len(self.mesh.segments)), (0, 1)], names=("point", "end"))
        return self._positioned(self.mesh.segments.reshape(-1, 2), self._at(POINT_END), index)

    def polygons(self, scale=1.0):
        """Outlines of the deformed blocks, displacements times `scale`: a list of k × 2 arrays [length unit]."""
        moved = self.mesh.vertices + scale * self.vertices[["displacement_x", "displacement_y"]].to_numpy()
        return self.mesh.by_block(moved)

    def _at(self, place):
        return [field for field in self._stored if field.place == place]

    def _positioned(self, at, fields, index):
        return self._table({"x": at[:, 0], "y": at[:, 1]}, {"x": self.mesh.unit, "y": self.mesh.unit}, fields, index)

    @staticmethod
    def _table(columns, units, fields, index):
        for field in fields:
            columns |= {name: field.values[:, i] for i, name in enumerate(field.columns)}
            units |= dict.fromkeys(field.columns, field.unit)
        table = pd.DataFrame(columns, index=index)
        table.attrs["units"] = units
        return table


def text_of(value):
    return value.decode("utf-8") if isinstance(value, bytes) else str(value)


def read_field(dataset):
    """A dataset of a step as a Field."""
    name = dataset.name.rsplit("/", 1)[1]
    values = dataset[()]
    values = values.reshape(len(values), -1)
    labels = text_of(dataset.attrs.get("components", "")).split()
    if not labels:
        labels = [str(i) for i in range(values.shape[1])]
    kept = [i for i, label in enumerate(labels) if label != "z"]
    columns = [name] if values.shape[1] == 1 else [f"{name}_{labels[i]}" for i in kept]
    return Field(name, int(dataset.attrs["place"]), values[:, kept], columns, text_of(dataset.attrs.get("unit", "")))


def read_mesh(file):
    """The mesh of an open fields/mesh.h5."""
    group = file["mesh"]
    vertices = group["vertices"][()][:, :2]
    offsets = group["offsets"][()]
    region = group["region"][()] if "region" in group else np.zeros(len(offsets) - 1, dtype=int)
    ends = group["segment_ends"][()] if "segment_ends" in group else np.zeros((0, 3))
    segments = ends.reshape(-1, 3)[:, :2].reshape(-1, 2, 2)
    return Mesh(vertices, offsets, region, segments, text_of(group["vertices"].attrs.get("unit", "")))


def read_fields(mesh, file):
    """The fields of an open fields/000034.h5, say."""
    members = [item for name, item in file.items() if name != "segments"]
    if "segments" in file:
        members += list(file["segments"].values())
    return Fields(mesh, {name: value for name, value in file.attrs.items()},
                  [read_field(dataset) for dataset in members])
