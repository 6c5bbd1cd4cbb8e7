"""Scenes of finite-element meshes: Abaqus' sets, code_aster's groups, elements with nodes on their sides, in decks that the program
accepts."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import meshio
import numpy as np

import ddapath
from ddapath import scenes


class Elements(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="elements-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def written(self, text, name):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    INP = """*HEADING
two courses
*NODE
1, 0., 0.
2, 100., 0.
3, 200., 0.
4, 0., 100.
5, 100., 100.
6, 200., 100.
7, 0., 200.
8, 100., 200.
9, 200., 200.
*ELEMENT, TYPE=CPS4, ELSET=CONCRETE
1, 1, 2, 5, 4
2, 2, 3, 6, 5
*ELEMENT, TYPE=CPS3, ELSET=STEEL
3, 4, 8, 5
4, 4, 8, 7
*ELEMENT, TYPE=CPS4, ELSET=STEEL
5, 5, 6, 9, 8
*ELSET, ELSET=WHOLE
1, 2, 3, 4, 5
*NSET, NSET=FOOT
1, 2, 3
*NSET, NSET=BED
4, 5, 6
*NSET, NSET=WHOLE
1, 2, 3, 4, 5, 6, 7, 8, 9
"""

    def checked(self, found, expected):
        deck = scenes.deck_of_elements(found, {"length": "mm", "force": "N"})
        ddapath.write_deck(deck, self.folder / "deck.yaml")
        done = subprocess.run([ddapath.find_program(), "check", self.folder / "deck.yaml"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for line in expected:
            self.assertRegex(done.stdout, line)
        return deck

    def test_sets_of_abaqus(self):
        found = scenes.scene_of_elements(self.written(self.INP, "wall.inp"), self.folder / "wall.msh")
        self.assertEqual((found.blocks, found.materials, found.interfaces), (5, ["CONCRETE", "STEEL"], ["BED"]))
        self.assertEqual(found.boundaries, ["FOOT", "left", "right", "top"])
        deck = self.checked(found, (r"region +CONCRETE: 2 blocks of CONCRETE", r"region +STEEL: 3 blocks of STEEL", r"area +40000 mm²",
                                    r"interface +BED: 4 points", "floating blocks   none"))
        self.assertEqual(deck["supports"]["foot"]["boundary"], "FOOT")
        found = ddapath.run(deck | {"scene": {"type": "msh", "file": str(self.folder / "wall.msh")}}, folder=self.folder / "run")
        self.assertEqual(found.status, "goal_reached")
        self.assertAlmostEqual(found.curve["load"].iloc[-1] / (2e-9 * 9810 * 4e4), 1, delta=1e-9)

    def test_groups_of_code_aster(self):
        mesh = meshio.Mesh([[0, 0], [1, 0], [1, 1], [0, 1.0]], [("triangle", [[0, 1, 2], [0, 2, 3]]), ("line", [[0, 1]])],
                           cell_data={"cell_tags": [np.array([-1, -1]), np.array([-2])]})
        mesh.cell_tags = {-1: ["rock"], -2: ["floor"]}
        meshio.write(self.folder / "rock.med", mesh)
        found = scenes.scene_of_elements(self.folder / "rock.med", self.folder / "rock.msh", scale=1000)
        self.assertEqual((found.materials, found.boundaries[0], found.interfaces), (["rock"], "floor", []))
        self.checked(found, (r"region +rock: 2 blocks of rock", r"area +1e\+06 mm²"))

    def test_nodes_on_sides(self):
        points = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0], [1, 0, 0], [2, 0.5, 0], [1, 1, 0], [0, 0.5, 0]]
        meshio.write(self.folder / "one.vtk", meshio.Mesh(points, [("quad8", [[0, 1, 2, 3, 4, 5, 6, 7]])]))
        found = scenes.scene_of_elements(self.folder / "one.vtk", self.folder / "one.msh")
        self.assertEqual((found.materials, found.boundaries[0]), (["body"], "bottom"))
        self.checked(found, (r"blocks +1 \(1 with 4 corners\)", r"area +2 mm²"))

    def test_a_mesh_without_straight_ends(self):
        angles = np.linspace(0, 2 * np.pi, 7)[:-1] + 0.1
        points = [[0, 0], *np.column_stack([np.cos(angles), np.sin(angles)])]
        meshio.write(self.folder / "disc.vtk", meshio.Mesh(points, [("triangle", [[0, 1 + i, 1 + (i + 1) % 6] for i in range(6)])]))
        found = scenes.scene_of_elements(self.folder / "disc.vtk", self.folder / "disc.msh")
        self.assertEqual(found.boundaries, ["outline"])
        self.checked(found, (r"blocks +6 ",))
        with self.assertRaisesRegex(scenes.SceneError, "above 0, not 0"):
            scenes.scene_of_elements(self.folder / "disc.vtk", self.folder / "disc.msh", scale=0)

    def test_what_is_wrong_with_a_mesh(self):
        solid = self.folder / "solid.vtk"
        meshio.write(solid, meshio.Mesh(np.eye(4, 3), [("tetra", [[0, 1, 2, 3]])]))
        bent = self.folder / "bent.vtk"
        meshio.write(bent, meshio.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 1]], [("triangle", [[0, 1, 2]])]))
        empty = self.written("*NODE\n1, 0., 0.\n2, 1., 0.\n", "empty.inp")
        parts = self.written("*INCLUDE, INPUT=mesh.inp\n", "parts.inp")
        for expected, file in ((r"\*INCLUDE names another", parts), ("is not plane", solid), ("is not plane: z goes from 0 to 1", bent), ("has no triangles", empty),
                               ("there is no such file", self.folder / "no.inp"), ("meshio cannot read it", self.written("?", "x.med"))):
            with self.subTest(expected), self.assertRaisesRegex(scenes.SceneError, expected):
                scenes.scene_of_elements(file, self.folder / "out.msh")

    def told(self, *arguments):
        return subprocess.run([sys.executable, "-B", "-m", "ddapath", "scene", *map(str, arguments)], capture_output=True, text=True,
                              check=False)

    def test_a_deck_of_elements(self):
        file = self.written(self.INP, "wall.inp")
        done = self.told(file)
        self.assertEqual((done.returncode, done.stdout), (0, f"{file.with_suffix('.yaml')}: 5 blocks\n"), done.stderr)
        done = subprocess.run([ddapath.find_program(), "check", file.with_suffix(".yaml")], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        for expected, arguments in (("is there already", []), ("--width belongs to", ["--width", 3, "--overwrite"])):
            done = self.told(file, *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(expected, done.stderr)


if __name__ == "__main__":
    unittest.main()
