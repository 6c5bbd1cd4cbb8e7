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


class Command(unittest.TestCase):
    def test_the_package_names_it(self):
        for code, arguments in ((0, ["--help"]), (2, ["scnee"])):
            done = subprocess.run([sys.executable, "-B", "-m", "ddapath", *arguments], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, code)
            self.assertIn("`python -m ddapath scene`", done.stderr if code else done.stdout)


if __name__ == "__main__":
    unittest.main()
