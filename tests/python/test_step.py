"""Scenes from STEP files that gmsh writes: faces side by side and one in another, holes, curves, and what is none."""

import contextlib
import os
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path

import numpy as np

import ddapath
from ddapath import scenes
from ddapath.scenes.net import area
from ddapath.scenes.scaled import Units


@contextlib.contextmanager
def silence():
    """The translator of Open CASCADE tells of what it writes whatever is asked of gmsh."""
    sys.stdout.flush()
    kept = os.dup(1)
    with open(os.devnull, "w", encoding="utf-8") as nothing:
        os.dup2(nothing.fileno(), 1)
    try:
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)


def areas(scene):
    return sorted(area(np.array(region["vertices"])) for region in scene["regions"])


class Step(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def drawn(self, draw):
        import gmsh

        with silence():
            gmsh.initialize(readConfigFiles=False)
            gmsh.option.setNumber("General.Terminal", 0)
            draw(gmsh.model.occ)
            gmsh.model.occ.synchronize()
            gmsh.write(str(self.folder / "drawing.step"))
            gmsh.finalize()
        return self.folder / "drawing.step"

    def test_faces_holes_and_what_fills_them(self):
        """A wall with a hole, a round stone and an oval one of two halves in it, and a coping on it."""
        def draw(occ):
            stones = [(2, occ.addDisk(200, 50, 0, 20, 20))]
            for left in (300, 340):
                oval, half = occ.addDisk(340, 50, 0, 25, 15), occ.addRectangle(left, 0, 0, 40, 100)
                stones += occ.intersect([(2, oval)], [(2, half)])[0]
            parts, _ = occ.fragment([(2, occ.addRectangle(0, 0, 0, 400, 100))], stones)
            occ.cut(parts, [(2, occ.addDisk(60, 50, 0, 10, 10))])
            occ.addRectangle(0, 100, 0, 400, 30)

        scene = scenes.scene_of_step(self.drawn(draw), tolerance=0.1)
        oval, stone, hole = np.pi * 25 * 15, np.pi * 400, np.pi * 100
        found = areas(scene)
        for expected, value in zip([oval / 2, oval / 2, stone, 400 * 30], found[:3] + [12000]):
            self.assertAlmostEqual(value / expected, 1, delta=5e-3)
        self.assertIn(12000, [round(value, 6) for value in found])
        self.assertAlmostEqual(sum(found) / (400 * 130 - hole), 1, delta=1e-4)
        sides = Counter(tuple(sorted((tuple(a), tuple(b)))) for region in scene["regions"]
                        for a, b in zip(region["vertices"], [*region["vertices"][1:], region["vertices"][0]]))
        free = sum(np.hypot(a[0] - b[0], a[1] - b[1]) for (a, b), times in sides.items() if times == 1)
        self.assertAlmostEqual(free / (2 * (400 + 130) + 2 * np.pi * 10), 1, delta=1e-3)  # neighbours share all others
        self.assertEqual({region["material"] for region in scene["regions"]}, {"body"})

    def test_a_deck_that_the_program_accepts(self):
        file = self.drawn(lambda occ: [occ.addRectangle(0, k, 0, 4, 1) for k in range(3)])
        deck = self.folder / "stack.yaml"
        done = subprocess.run([sys.executable, "-B", "-m", "ddapath", "scene", file, "--scale", "100", "--out", deck],
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, f"{deck}: 3 blocks\n"), done.stderr)
        self.assertEqual(areas(ddapath.read_deck(deck)["scene"]), [40000] * 3)
        checked = subprocess.run([ddapath.find_program(), "check", deck], capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stderr)

    def test_lengths_are_millimetres(self):
        """Of a file in metres."""
        file = self.drawn(lambda occ: occ.addRectangle(0, 0, 0, 2, 1))
        text = file.read_text(encoding="utf-8")
        self.assertIn("SI_UNIT(.MILLI.,.METRE.)", text)
        file.write_text(text.replace("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)"), encoding="utf-8")
        self.assertEqual(areas(scenes.scene_of_step(file)), [2e6])
        self.assertEqual(areas(scenes.scene_of_step(file, units=Units(scale=0.001))), [2])

    def test_what_is_no_section(self):
        for expected, draw in (("has solids", lambda occ: occ.addBox(0, 0, 0, 1, 1, 1)),
                               ("has no faces", lambda occ: occ.addCircle(0, 0, 0, 1)),
                               (r"face 1 \(body\): does not lie in the plane",
                                lambda occ: occ.rotate([(2, occ.addRectangle(0, 0, 0, 1, 1))], 0, 0, 0, 1, 0, 0, 0.5))):
            with self.subTest(expected), self.assertRaisesRegex(scenes.SceneError, expected):
                scenes.scene_of_step(self.drawn(draw))
        (self.folder / "text.step").write_text("nothing", encoding="utf-8")
        with silence(), self.assertRaisesRegex(scenes.SceneError, "no STEP file that can be read"):
            scenes.scene_of_step(self.folder / "text.step")
        with self.assertRaisesRegex(scenes.SceneError, "there is no such file"):
            scenes.scene_of_step(self.folder / "absent.step")


if __name__ == "__main__":
    unittest.main()
