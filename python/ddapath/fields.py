"""Fields of one stored step as tables: over blocks, their vertices, interface points and the points' ends; where cracks
have cut blocks also over the parts of these, and over the pieces of the cracks.

Whatever a step's file holds becomes columns: a field `stress` with the components "xx yy xy" is stress_xx, stress_yy and
stress_xy. Zero z components, which ParaView needs, are left out.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pandas as pd

# the attribute `place` of a dataset
BLOCK, BLOCK_VERTEX, POINT, POINT_END, PART, PART_VERTEX, CRACK, CRACK_END = range(8)


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

    @cached_property
    def uncut(self):
        """CutBlocks without any."""
        return cut_blocks(self, {})

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


@dataclass(frozen=True)
class CutBlocks:
    """What cracks have made of the blocks at a step [length unit of the deck].

    parts: a Mesh of the parts of the blocks that are cut, its segments the pieces of cracks, one per interface point.
    block: to which each part belongs. moves: rows (part, cut), the part moves by the jump across the cut beside its block.
    pieces: columns cut, crack, is_provisional of each piece. cuts: a row per cut, in the order in which they came, with
    crack, is_provisional (it lies ahead of its crack), block, side (along which it runs; -1: through the block),
    start_x … end_y, length, interface, stiffness k. forces: dead and reference loads on the jump across each cut, n × 3, and
    where several stages are followed reference_N of each that comes after the first.
    spring_parts: what supports and driven points feel of jumps, columns spring, cut and row (n × 3).
    """

    parts: Mesh
    block: np.ndarray
    moves: np.ndarray
    pieces: pd.DataFrame
    cuts: pd.DataFrame
    forces: dict
    spring_parts: dict

    def equals(self, other):
        """Whether cracks have cut the same blocks, in the same parts, with the same loads and supports on them."""
        def arrays(of):
            named = {**of.forces, **{f"spring part's {name}": values for name, values in of.spring_parts.items()}}
            return {"vertices": of.parts.vertices, "offsets": of.parts.offsets, "block": of.block, "moves": of.moves, **named}

        ours, theirs = arrays(self), arrays(other)
        return (self.cuts.equals(other.cuts) and ours.keys() == theirs.keys()
                and all(np.array_equal(values, theirs[name]) for name, values in ours.items()))


class Fields:
    """The fields of one stored step.

    step, load_factor; numbers: whatever else the step has as attributes, of a path load, energies, gauges and reactions, of
    a motion time, energies and gauges; mesh: see Mesh; cut: see CutBlocks.
    rest: displacements at which springs of supports that stages have put in bear nothing, in the order in which they came [L].
    borne: by those that have been taken away, when that began, in the order in which they went [F]; (1 − λ) of it acts in
    their place, λ being the load factor of the stage that took them away.
    blocks        a row per block: region, area, x, y of the centroid; strain, stress, principal stresses in the plane; means
                  over the block of what is given at its vertices, such as the displacement
    vertices      a row per vertex of a block, index (block, vertex): x, y undeformed, displacement
    points        a row per crackable interface point: x, y, normal n and tangential s components of opening, jump and
                  traction, damage
    point_ends    two rows per point, index (point, end): displacement of the middle of the crack
    parts         a row per part of the blocks that cracks have cut: block, area, x, y; the rest as of blocks
    part_vertices a row per vertex of a part, index (part, vertex): as of vertices
    cracks        a row per piece of a crack: crack, cut, is_provisional (it lies ahead of the crack); start_x, start_y,
                  end_x, end_y; the rest as of points
    crack_ends    two rows per piece, index (piece, end): displacement of the middle of the crack
    Units of the columns are in attrs["units"].
    """

    def __init__(self, mesh, numbers, stored, cut, supports=None):
        self.mesh, self.numbers, self._stored, self.cut = mesh, dict(numbers), list(stored), cut
        self.rest, self.borne = (np.asarray((supports or {}).get(name, ()), dtype=float) for name in ("rest", "borne"))
        self.step = int(self.numbers.pop("step"))
        self.load_factor = self.numbers.get("load_factor")

    def __repr__(self):
        return f"<fields of step {self.step}: {', '.join(dict.fromkeys(field.name for field in self._stored))}>"

    @cached_property
    def blocks(self):
        centroids = self.mesh.means(self.mesh.vertices)
        out = {"region": self.mesh.region, "area": self.mesh.areas, "x": centroids[:, 0], "y": centroids[:, 1]}
        units = {"region": "", "area": f"{self.mesh.unit}²", "x": self.mesh.unit, "y": self.mesh.unit}
        averaged = [Field(field.name, BLOCK, self._block_means(field), field.columns, field.unit)
                    for field in self._at(BLOCK_VERTEX)]
        return self._table(out, units, [*averaged, *self._at(BLOCK)], pd.RangeIndex(self.mesh.num_blocks, name="block"))

    def _block_means(self, field):
        """Of a block that is cut, over its parts."""
        means = self.mesh.means(field.values)
        for of_parts in (other for other in self._at(PART_VERTEX) if other.name == field.name):
            parts, block = self.cut.parts, self.cut.block
            means[block] = 0
            np.add.at(means, block, parts.means(of_parts.values) * (parts.areas / self.mesh.areas[block])[:, None])
        return means

    @cached_property
    def vertices(self):
        return self._of_vertices(self.mesh, BLOCK_VERTEX, ("block", "vertex"))

    @cached_property
    def points(self):
        middles = self.mesh.segments.mean(axis=1)
        return self._positioned(middles, self._at(POINT), pd.RangeIndex(len(middles), name="point"))

    @cached_property
    def point_ends(self):
        return self._of_ends(self.mesh, POINT_END, ("point", "end"))

    @cached_property
    def parts(self):
        parts = self.cut.parts
        centroids = parts.means(parts.vertices)
        out = {"block": self.cut.block, "area": parts.areas, "x": centroids[:, 0], "y": centroids[:, 1]}
        units = {"block": "", "area": f"{parts.unit}²", "x": parts.unit, "y": parts.unit}
        averaged = [Field(field.name, PART, parts.means(field.values), field.columns, field.unit)
                    for field in self._at(PART_VERTEX)]
        return self._table(out, units, [*averaged, *self._at(PART)], pd.RangeIndex(parts.num_blocks, name="part"))

    @cached_property
    def part_vertices(self):
        return self._of_vertices(self.cut.parts, PART_VERTEX, ("part", "vertex"))

    @cached_property
    def cracks(self):
        ends = self.cut.parts.segments
        out = {name: self.cut.pieces[name].to_numpy() for name in self.cut.pieces}
        units = dict.fromkeys(out, "")
        corners = {f"{end}_{axis}": ends[:, i, j] for i, end in enumerate(("start", "end")) for j, axis in enumerate("xy")}
        units |= dict.fromkeys(corners, self.mesh.unit)
        return self._table(out | corners, units, self._at(CRACK), pd.RangeIndex(len(ends), name="piece"))

    @cached_property
    def crack_ends(self):
        return self._of_ends(self.cut.parts, CRACK_END, ("piece", "end"))

    def crack_path(self, crack=0):
        """Corners of the line along which a crack has grown, from where it began to its tip, n × 2 [length unit]."""
        cuts = self.cut.cuts
        grown = cuts[(cuts["crack"] == crack) & ~cuts["is_provisional"]]
        starts, ends = grown[["start_x", "start_y"]].to_numpy(), grown[["end_x", "end_y"]].to_numpy()
        return np.concatenate([starts, ends[-1:]])

    def polygons(self, scale=1.0):
        """Outlines of the deformed blocks, of those that are cut of their parts, displacements times `scale`: a list of
        k × 2 arrays [length unit]."""
        blocks = self._moved(self.mesh, self.vertices, scale)
        parts = self._moved(self.cut.parts, self.part_vertices, scale) if len(self.cut.block) else []
        return [block for block, whole in zip(blocks, self._is_whole) if whole] + parts

    @property
    def polygon_regions(self):
        """The number of the region of each of `polygons`."""
        return np.concatenate([self.mesh.region[self._is_whole], self.mesh.region[self.cut.block]])

    @property
    def _is_whole(self):
        """Of every block: no crack has cut it."""
        out = np.ones(self.mesh.num_blocks, dtype=bool)
        out[self.cut.block] = False
        return out

    @staticmethod
    def _moved(mesh, table, scale):
        return mesh.by_block(mesh.vertices + scale * table[["displacement_x", "displacement_y"]].to_numpy())

    def _of_vertices(self, mesh, place, names):
        numbers = np.diff(mesh.offsets)
        within = np.arange(len(mesh.vertices)) - np.repeat(mesh.offsets[:-1], numbers)
        index = pd.MultiIndex.from_arrays([np.repeat(np.arange(len(numbers)), numbers), within], names=names)
        return self._positioned(mesh.vertices, self._at(place), index)

    def _of_ends(self, mesh, place, names):
        index = pd.MultiIndex.from_product([range(len(mesh.segments)), (0, 1)], names=names)
        return self._positioned(mesh.segments.reshape(-1, 2), self._at(place), index)

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


def lines_of(group, name):
    """Ends of segments, m × 2 × 2."""
    ends = group[name][()] if name in group else np.zeros((0, 3))
    return ends.reshape(-1, 3)[:, :2].reshape(-1, 2, 2)


def read_mesh(file):
    """The mesh of an open fields/mesh.h5."""
    group = file["mesh"]
    vertices = group["vertices"][()][:, :2]
    offsets = group["offsets"][()]
    region = group["region"][()] if "region" in group else np.zeros(len(offsets) - 1, dtype=int)
    return Mesh(vertices, offsets, region, lines_of(group, "segment_ends"), text_of(group["vertices"].attrs.get("unit", "")))


def read_cuts(group):
    """The group /cuts of a step as a table."""
    columns = {name: group[name][()] if name in group else np.zeros(0, dtype=int)
               for name in ("crack", "is_provisional", "block", "side", "interface", "stiffness")}
    ends = group["ends"][()].reshape(-1, 4) if "ends" in group else np.zeros((0, 4))
    columns |= dict(zip(("start_x", "start_y", "end_x", "end_y"), ends.T))
    columns |= {"is_provisional": columns["is_provisional"].astype(bool),
                "length": np.hypot(ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1])}
    return pd.DataFrame(columns, index=pd.RangeIndex(len(ends), name="cut"))


def read_cut_blocks(mesh, file):
    """What cracks have cut in an open file of a step; empty where there are none, and the same for every step of a mesh."""
    groups = {name: file[name] for name in ("parts", "cracks", "cuts") if name in file}
    return cut_blocks(mesh, groups) if groups else mesh.uncut


def cut_blocks(mesh, groups):
    parts, cracks = groups.get("parts", {}), groups.get("cracks", {})
    block = parts["block"][()] if "block" in parts else np.zeros(0, dtype=int)
    vertices = parts["vertices"][()][:, :2] if "vertices" in parts else np.zeros((0, 2))
    offsets = parts["offsets"][()] if "offsets" in parts else np.zeros(1, dtype=int)
    moves = parts["moves"][()].reshape(-1, 2) if "moves" in parts else np.zeros((0, 2), dtype=int)
    pieces = pd.DataFrame({name: cracks[name][()] if name in cracks else np.zeros(0, dtype=int)
                           for name in ("crack", "cut", "is_provisional")})
    pieces["is_provisional"] = pieces["is_provisional"].astype(bool)
    outlines = Mesh(vertices, offsets, mesh.region[block], lines_of(cracks, "ends"), mesh.unit)
    cuts = groups.get("cuts", {})
    forces = {name: np.zeros((0, 3)) for name in ("dead", "reference")}
    forces |= {name: cuts[name][()].reshape(-1, 3) for name in cuts if name == "dead" or name.startswith("reference")}
    felt = {name: cuts[f"spring_part/{name}"][()] if "spring_part" in cuts else np.zeros(0) for name in ("spring", "cut", "row")}
    felt = {"spring": felt["spring"].astype(int), "cut": felt["cut"].astype(int), "row": felt["row"].reshape(-1, 3)}
    return CutBlocks(outlines, block, moves, pieces, read_cuts(cuts), forces, felt)


def read_fields(mesh, file):
    """The fields of an open fields/000034.h5, say."""
    groups = [file] + [file[name] for name in ("segments", "parts", "cracks") if name in file]
    members = [item for group in groups for item in group.values() if "place" in item.attrs]
    supports = {name: item[()] for name, item in file.get("supports", {}).items()}
    return Fields(mesh, dict(file.attrs.items()), [read_field(dataset) for dataset in members], read_cut_blocks(mesh, file), supports)
