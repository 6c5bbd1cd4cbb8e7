"""The study of the wall from a picture: its statics, and its quick selection. `python3 test_rubble_wall.py PROGRAM`."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "rubble-wall"
sys.path[:0] = [str(STUDY), str(STUDY.parent / "masonry-in-motion"), str(STUDY.parents[1] / "python")]

import statics  # noqa: E402
from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


class Statics(unittest.TestCase):
    BLOCKS = {"ground": box(-1, -1, 3, 0), "lower": box(0, 0, 1, 1), "upper": box(0, 1, 1, 2)}

    def test_a_stack_slides_or_turns(self):
        self.assertAlmostEqual(statics.largest_push(self.BLOCKS, ["ground"], 0.3), 0.3, places=6)
        self.assertAlmostEqual(statics.largest_push(self.BLOCKS, ["ground"], 0.8), 0.5, places=6)

    def test_a_turn_about_the_toe(self):
        self.assertAlmostEqual(statics.turns_over(self.BLOCKS, ["lower", "upper"]), 0.5, places=12)
        self.assertAlmostEqual(statics.turns_over(self.BLOCKS, ["upper"]), 1, places=12)


class Quick(unittest.TestCase):
    def test_a_wall_of_little_friction_bears_what_statics_allows(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-B", STUDY / "study.py", "--program", PROGRAM, "--quick", "--output", folder],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            (limit,) = study.read_rows(Path(folder) / "results" / "limits.csv")
        self.assertAlmostEqual(limit["found"] / limit["statics"], 1, delta=1e-3)
        self.assertLess(limit["statics"], limit["turning"])


if __name__ == "__main__":
    unittest.main()
