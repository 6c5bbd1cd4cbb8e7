"""The quick selections of masonry-in-motion and rock-slope, and their statics. `python3 test_motion_studies.py PROGRAM`."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path[:0] = [str(STUDIES / "masonry-in-motion"), str(STUDIES / "rock-slope"), str(STUDIES.parent / "python")]

import goodman_bray  # noqa: E402
import limit_equilibrium  # noqa: E402
import shapes  # noqa: E402
import spreading  # noqa: E402
from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


class Statics(unittest.TestCase):
    def test_block_on_a_plane_needs_its_slope(self):
        blocks = {"ground": shapes.box(-1, -1, 3, 0), "block": shapes.box(0, 0, 2, 1)}
        self.assertAlmostEqual(limit_equilibrium.least_friction(blocks, ["ground"], (0.4, -1)), 0.4, places=6)

    def test_block_that_must_topple_needs_more_than_any_friction(self):
        blocks = {"ground": shapes.box(-1, -1, 3, 0), "block": shapes.box(0, 0, 1, 3)}
        self.assertFalse(limit_equilibrium.stands(blocks, ["ground"], (0.4, -1), 10))

    def test_thick_arch_needs_the_friction_of_pure_sliding(self):
        """0.309 of a semicircular arch of many stones, whatever its thickness (Cocchetti and Rizzi)."""
        found = limit_equilibrium.least_friction(shapes.semicircular_arch(20, 0.3), ["left impost", "right impost"], (0, -1))
        self.assertAlmostEqual(found, 0.309, places=3)

    def test_thrust_line_of_the_spreading_arch_begins_inside_and_passes_its_hinges(self):
        arch = spreading.SpreadArch(16, 0.15)
        largest, hinge = arch.largest_spread()
        line = arch.thrust_line(hinge, largest)
        self.assertAlmostEqual(line[-1], 1)
        self.assertAlmostEqual(line[hinge], 0)
        self.assertAlmostEqual(line[0], 1, places=3)

    def test_goodman_and_bray(self):
        slope = goodman_bray.Slope()
        self.assertAlmostEqual(slope.limiting_angle(), 38.15, delta=0.03)
        kinds = [kind for _, kind in slope.passed_on(38.13)]
        self.assertEqual(kinds, 3 * ["slides"] + 10 * ["topples"] + 3 * ["stands"])


class Quick(unittest.TestCase):
    def results(self, name, table):
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run([sys.executable, "-B", str(STUDIES / name / "study.py"), "--program", PROGRAM, "--quick",
                                   "--output", scratch], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            return study.read_rows(Path(scratch) / "results" / table)

    def test_masonry(self):
        for row in self.results("masonry-in-motion", "limits.csv"):
            self.assertLessEqual(row["error"], row["bound"], row["case"])

    def test_rock_slope(self):
        for row in self.results("rock-slope", "toppling.csv"):
            self.assertLessEqual(row["error"], row["bound"])


if __name__ == "__main__":
    unittest.main()
