"""Runs and points for pyvista and meshio. Where these are not installed stand-ins that keep what they are given take their place."""

import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import ddapath

DECK = Path(__file__).resolve().parents[1] / "program" / "beam.yaml"
SETTINGS = {"path.stop.after_steps": 8}


class PolyData:
    """As much of pyvista's as is used."""

    def __init__(self, points, faces):
        self.points, self.faces, self.point_data, self.cell_data = points, faces, {}, {}


class MeshioMesh:
    """As much of meshio's as is used; it checks sizes as meshio does."""

    def __init__(self, points, cells, point_data, cell_data):
        self.points, self.cells, self.point_data, self.cell_data = points, cells, point_data, cell_data
        for values in cell_data.values():
            if [len(part) for part in values] != [len(corners) for _, corners in cells]:
                raise ValueError("cell data that do not fit the cells")


def stand_in(name, **members):
    module = types.ModuleType(name)
    vars(module).update(members)
    return mock.patch.dict(sys.modules, {name: module})


class Meshes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.path = ddapath.follow(DECK, SETTINGS, folder=Path(scratch.name) / "run")
        *_, cls.point = cls.path
        cls.fields = cls.path.run.fields()

    def assert_outlines(self, corners):
        self.assertEqual([len(outline) for outline in corners], [len(outline) for outline in self.fields.mesh.polygons])

    def test_pyvista(self):
        with stand_in("pyvista", PolyData=PolyData):
            for mesh in (self.point.to_pyvista(), self.path.run.to_pyvista()):
                moved = self.fields.vertices[["displacement_x", "displacement_y"]].to_numpy()
                np.testing.assert_allclose(mesh.points[:, :2], self.fields.mesh.vertices + moved, atol=1e-12)
                np.testing.assert_array_equal(mesh.point_data["displacement"][:, :2], moved)
                faces, corners = list(mesh.faces), []
                while faces:
                    corners.append(faces[1:1 + faces[0]])
                    faces = faces[1 + faces[0]:]
                self.assert_outlines(corners)
                self.assertEqual(sum(corners, []), list(range(len(moved))))
        np.testing.assert_array_equal(mesh.cell_data["stress_xx"], self.fields.blocks["stress_xx"])

    def check_meshio(self):
        for mesh in (self.point.to_meshio(), self.path.run.to_meshio()):
            cells = [(cell.type, cell.data) if hasattr(cell, "data") else cell for cell in mesh.cells]
            corners = sorted((list(row) for _, rows in cells for row in rows), key=lambda row: row[0])
            self.assert_outlines(corners)
            np.testing.assert_array_equal(mesh.points[:, :2], self.fields.mesh.vertices)
        self.assertEqual({len(rows[0]): kind for kind, rows in cells}.get(4, "quad"), "quad")
        stresses = np.concatenate(mesh.cell_data["stress_xx"])
        np.testing.assert_array_equal(np.sort(stresses), np.sort(self.fields.blocks["stress_xx"]))

    def test_meshio(self):
        with stand_in("meshio", Mesh=MeshioMesh):
            self.check_meshio()

    def test_meshio_itself(self):
        try:
            import meshio  # noqa: F401
        except ImportError:
            self.skipTest("meshio is not installed (Debian: python3-meshio)")
        self.check_meshio()

    def test_a_library_that_is_missing(self):
        for name, how in (("pyvista", "pip install pyvista"), ("meshio", "apt-get install python3-meshio")):
            with mock.patch.dict(sys.modules, {name: None}):
                with self.assertRaisesRegex(ImportError, how):
                    getattr(self.point, f"to_{name}")()

    def test_a_notebook_shows_the_curve(self):
        run = self.path.run
        self.assertTrue(run._repr_svg_().lstrip().startswith("<"))
        self.assertIn("<svg", run._repr_html_())
        self.assertIn("goal_reached", run._repr_html_())
        (run.folder / "curve.svg").rename(run.folder / "away.svg")
        self.addCleanup(lambda: (run.folder / "away.svg").rename(run.folder / "curve.svg"))
        self.assertIsNone(run._repr_svg_())
        self.assertNotIn("<svg", run._repr_html_())


if __name__ == "__main__":
    unittest.main()
