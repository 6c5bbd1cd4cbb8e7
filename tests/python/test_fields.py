"""Tables of fields: geometry of the blocks, and columns for whatever a step's file holds."""

import io
import unittest

import h5py
import numpy as np

from ddapath import fields

# A square of side 2 and an L of area 3, which is not convex; two interface points on x = 2.
SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
L = [(2, 0), (4, 0), (4, 1), (3, 1), (3, 2), (2, 2)]


# The square cut at x = 0.5: its parts, and the two pieces of the crack.
LEFT, RIGHT = [(0, 0), (0.5, 0), (0.5, 2), (0, 2)], [(0.5, 0), (2, 0), (2, 2), (0.5, 2)]
PIECES = [(0.5, 0), (0.5, 1), (0.5, 1), (0.5, 2)]


def in_space(rows):
    rows = np.asarray(rows, dtype=float)
    return np.hstack([rows, np.zeros((len(rows), 1))])


def put(group, name, values, attributes):
    dataset = group.create_dataset(name, data=values)
    for key, value in attributes.items():
        dataset.attrs[key] = value


def put_cuts(step):
    """What lies right of the cut has moved by (1, 0) more; a second cut lies ahead of the crack."""
    parts, cracks, cuts = (step.create_group(name) for name in ("parts", "cracks", "cuts"))
    parts["vertices"], parts["offsets"] = in_space(LEFT + RIGHT), [0, 4, 8]
    parts["block"], parts["moves"] = [0, 0], [[1, 0]]
    x = np.array(LEFT + RIGHT, dtype=float)
    moved = np.column_stack([1 + 2 * x[:, 0] + np.repeat([0, 1], 4), 3 * x[:, 1] - x[:, 0]])
    put(parts, "displacement", in_space(moved), {"unit": "mm", "components": "x y z", "place": 5})
    put(parts, "stress", [[1.0, 2, 3]] * 2, {"unit": "MPa", "components": "xx yy xy", "place": 4})
    cracks["ends"], cracks["cut"], cracks["crack"], cracks["is_provisional"] = in_space(PIECES), [0, 0], [0, 0], [0, 0]
    put(cracks, "opening", in_space([(1, 0), (1, 0)]), {"unit": "mm", "components": "n s", "place": 6})
    put(cracks, "displacement", in_space([(2, 1)] * 4), {"unit": "mm", "components": "x y z", "place": 7})
    cuts["ends"] = [[0.5, 2, 0.5, 0], [0.5, 0, 0.25, -1], [0.25, -1, 0, -2]]
    for name, values in (("block", [0, 1, 1]), ("side", [-1, 3, 4]), ("crack", [0, 0, 0]), ("is_provisional", [0, 0, 1]),
                         ("interface", [0, 0, 0]), ("stiffness", [5.0, 6.0, 7.0])):
        cuts[name] = values


def stored(is_cut=False):
    """A results file in memory, with one step and a field that no run of today has."""
    file = h5py.File(io.BytesIO(), "w")
    put(file, "mesh/vertices", in_space(SQUARE + L), {"unit": "mm"})
    file["mesh/offsets"], file["mesh/region"] = [0, 4, 10], [0, 7]
    put(file, "mesh/segment_ends", in_space([(2, 0), (2, 1), (2, 1), (2, 2)]), {"unit": "mm"})
    step = file.create_group("field/000012")
    for name, value in (("step", 12), ("time", 12.0), ("load_factor", 0.5)):
        step.attrs[name] = value
    x = np.array(SQUARE + L, dtype=float)
    put(step, "displacement", in_space(np.column_stack([1 + 2 * x[:, 0], 3 * x[:, 1] - x[:, 0]])),
        {"unit": "mm", "components": "x y z", "place": 1})
    put(step, "stress", [[1.0, 2, 3], [4, 5, 6]], {"unit": "MPa", "components": "xx yy xy", "place": 0})
    put(step, "mode 1", in_space(x), {"unit": "", "components": "x y z", "place": 1})
    put(step, "segments/opening", in_space([(0.1, 0.2), (0.3, 0.4)]), {"unit": "mm", "components": "n s", "place": 2})
    put(step, "segments/damage", [0.5, 1.0], {"unit": "", "components": "", "place": 2})
    put(step, "segments/displacement", in_space([(0, 0)] * 4), {"unit": "mm", "components": "x y z", "place": 3})
    if is_cut:
        put_cuts(step)
    return fields.read_fields(fields.read_mesh(file), step)


class Geometry(unittest.TestCase):
    def setUp(self):
        self.fields = stored()

    def test_outlines(self):
        self.assertEqual([outline.tolist() for outline in self.fields.mesh.polygons],
                         [np.array(outline, dtype=float).tolist() for outline in (SQUARE, L)])

    def test_areas_and_centroids(self):
        blocks = self.fields.blocks
        np.testing.assert_allclose(blocks["area"], [4, 3])
        np.testing.assert_allclose(blocks["x"], [1, 2 + 5 / 6])
        np.testing.assert_allclose(blocks["y"], [1, 5 / 6])
        self.assertEqual(blocks["region"].tolist(), [0, 7])

    def test_mean_displacement_is_that_of_the_centroid(self):
        blocks = self.fields.blocks
        np.testing.assert_allclose(blocks["displacement_x"], 1 + 2 * blocks["x"])
        np.testing.assert_allclose(blocks["displacement_y"], 3 * blocks["y"] - blocks["x"])

    def test_deformed_outlines(self):
        moved = self.fields.polygons(scale=10)
        np.testing.assert_allclose(moved[0][2], [2 + 10 * 5, 2 + 10 * 4])
        np.testing.assert_allclose(self.fields.polygons(0)[1], L)


class Columns(unittest.TestCase):
    def setUp(self):
        self.fields = stored()

    def test_step(self):
        self.assertEqual((self.fields.step, self.fields.load_factor), (12, 0.5))

    def test_blocks(self):
        blocks = self.fields.blocks
        self.assertEqual(blocks["stress_xy"].tolist(), [3, 6])
        self.assertEqual(blocks.attrs["units"]["stress_xy"], "MPa")
        self.assertEqual(blocks.attrs["units"]["area"], "mm²")
        self.assertFalse([name for name in blocks.columns if name.endswith("_z")])

    def test_vertices(self):
        vertices = self.fields.vertices
        self.assertEqual(vertices.loc[(1, 2), ["x", "y", "displacement_x"]].tolist(), [4, 1, 9])
        self.assertEqual(len(vertices), 10)

    def test_points(self):
        points = self.fields.points
        self.assertEqual(points.columns.tolist(), ["x", "y", "damage", "opening_n", "opening_s"])
        self.assertEqual(points.loc[1].tolist(), [2, 1.5, 1.0, 0.3, 0.4])
        self.assertEqual(points.attrs["units"]["opening_n"], "mm")
        self.assertEqual(self.fields.point_ends.loc[(1, 1), "y"], 2)

    def test_a_field_that_nobody_foresaw(self):
        np.testing.assert_allclose(self.fields.vertices["mode 1_x"], self.fields.vertices["x"])
        np.testing.assert_allclose(self.fields.blocks["mode 1_y"], self.fields.blocks["y"])


class Cut(unittest.TestCase):
    def setUp(self):
        self.fields = stored(is_cut=True)

    def test_parts(self):
        parts = self.fields.parts
        self.assertEqual(parts["block"].tolist(), [0, 0])
        np.testing.assert_allclose(parts["area"], [1, 3])
        np.testing.assert_allclose(parts["x"], [0.25, 1.25])
        np.testing.assert_allclose(parts["displacement_x"], [1 + 2 * 0.25, 2 + 2 * 1.25])
        self.assertEqual(parts["stress_yy"].tolist(), [2, 2])
        self.assertEqual(parts.attrs["units"]["area"], "mm²")
        self.assertEqual(self.fields.part_vertices.loc[(1, 1), ["x", "y", "displacement_x"]].tolist(), [2, 0, 6])

    def test_the_mean_of_a_block_is_that_of_its_parts(self):
        np.testing.assert_allclose(self.fields.blocks["displacement_x"], [(1.5 + 3 * 4.5) / 4, 1 + 2 * (2 + 5 / 6)])

    def test_cracks(self):
        cracks = self.fields.cracks
        self.assertEqual(cracks.loc[1, ["start_x", "start_y", "end_x", "end_y"]].tolist(), [0.5, 1, 0.5, 2])
        self.assertEqual(cracks["opening_n"].tolist(), [1, 1])
        self.assertEqual(cracks["is_provisional"].tolist(), [False, False])
        self.assertEqual(cracks.attrs["units"]["opening_n"], "mm")
        self.assertEqual(self.fields.crack_ends.loc[(1, 1), ["y", "displacement_x"]].tolist(), [2, 2])

    def test_the_path_ends_where_the_crack_has_grown_to(self):
        self.assertEqual(self.fields.crack_path().tolist(), [[0.5, 2], [0.5, 0], [0.25, -1]])
        self.assertEqual(self.fields.crack_path(crack=1).tolist(), [])
        self.assertEqual(self.fields.cut.cuts["length"].tolist()[0], 2)

    def test_deformed_outlines_are_those_of_the_parts(self):
        self.assertEqual([outline.tolist() for outline in self.fields.polygons(0)],
                         [np.array(outline, dtype=float).tolist() for outline in (L, LEFT, RIGHT)])
        np.testing.assert_allclose(self.fields.polygons(scale=10)[2][1], [2 + 10 * 6, 10 * -2])


class Whole(unittest.TestCase):
    """Tables of what is not there are empty."""

    def test_no_cracks(self):
        whole = stored()
        for table in (whole.parts, whole.part_vertices, whole.cracks, whole.crack_ends, whole.cut.cuts):
            self.assertEqual(len(table), 0)
        self.assertEqual(whole.crack_path().tolist(), [])


if __name__ == "__main__":
    unittest.main()
