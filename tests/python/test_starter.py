"""The deck that is written around a scene.

    test_starter.py        with PYTHONPATH=python, and DDA naming the program
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath import scenes


class Feet(unittest.TestCase):
    """What a deck to begin with holds."""
    UNITS = {"length": "m", "force": "N"}

    def row(self, *extra, base=0):
        corners = [[[x, base], [x + 1, 0], [x + 1, 1], [x, 1]] for x in (0, 1)]
        return {"type": "polygons", "regions": [{"name": f"s {i}", "material": "s", "vertices": v} for i, v in enumerate([*corners, *extra])]}

    def test_the_lowest_blocks(self):
        deck = scenes.deck_to_begin_with(self.row([[0, 1], [1, 1], [1, 2], [0, 2]]), self.UNITS)
        self.assertEqual(deck["motion"]["held"], ["s 0", "s 1"])
        self.assertNotIn("supports", deck)

    def test_the_foot_where_all_are_the_lowest(self):
        scene = {**self.row(), "boundaries": {"bottom": [[0, 0], [2, 0]], "left": [[0, 0], [0, 1]]}}
        deck = scenes.deck_to_begin_with(scene, self.UNITS)
        self.assertEqual(deck["supports"], {"ground": {"boundary": "ground", "fix": "xy"}})
        self.assertEqual(deck["scene"]["boundaries"], {"ground": [[0, 0], [2, 0]], "left": [[0, 0], [0, 1]]})
        self.assert_rests(deck)

    def test_the_ground_that_is_drawn(self):
        scene = self.row([[0, 1], [1, 1], [1, 2], [0, 2]])
        scene["boundaries"] = {"bottom": [[0, 0], [2, 0]], "ground": [[0, 0], [1, 0], [2, 0]]}
        deck = scenes.deck_to_begin_with(scene, self.UNITS)
        self.assertEqual((deck["motion"]["held"], list(deck["supports"]), list(deck["scene"]["boundaries"])), ([], ["ground"], ["ground"]))
        self.assert_rests(deck)

    def test_corners_alone_hold_nothing(self):
        with self.assertRaisesRegex(ValueError, "stand on corners alone"):
            scenes.deck_to_begin_with(self.row(base=0.5), self.UNITS)

    def assert_rests(self, deck):
        deck["motion"]["time"] = 0.1
        with tempfile.TemporaryDirectory() as folder:
            run = ddapath.run(deck, folder=Path(folder) / "rests")
            self.assertIn("at rest", run.summary["motion"]["reason"])


class Crossing(unittest.TestCase):
    def test_is_where_the_sides_meet(self):
        paths = '<rect class="a" width="60" height="100"/><rect class="b" x="50" y="-20" width="50" height="70"/>'
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "drawing.svg"
            file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100">{paths}</svg>',
                            encoding="utf-8")
            with self.assertRaisesRegex(scenes.SceneError, r"crosses .* near \((50, 100|60, 50)\): "):
                scenes.scene_of_svg(file)


class Command(unittest.TestCase):
    def test_a_wrong_option_is_told_in_a_line(self):
        for command, option in (("scene", "--scale"), ("animate", "--fps")):
            done = subprocess.run([sys.executable, "-B", "-m", "ddapath", command, "file", option, "x"], capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"{option}: expected a number, found 'x'; ", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)

    def test_the_package_names_it(self):
        for code, arguments in ((0, ["--help"]), (2, ["scnee"])):
            done = subprocess.run([sys.executable, "-B", "-m", "ddapath", *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, code)
            self.assertIn("`python -m ddapath scene`", done.stderr if code else done.stdout)


if __name__ == "__main__":
    unittest.main()
