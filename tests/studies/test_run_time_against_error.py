"""The study run-time-against-error on its coarse blocks: errors, figures, tables. Times are not looked at.

    test_run_time_against_error.py PROGRAM
"""

import csv
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "run-time-against-error"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

import fronts  # noqa: E402
import report  # noqa: E402
from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1)
PROBLEMS = ("elastic-cantilever", "softening-bar", "notched-beam")


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.output = Path(folder.name)
        command = [sys.executable, "-B", STUDY / "study.py", "--program", PROGRAM, "--quick", "--output", cls.output]
        subprocess.run(command, check=True, capture_output=True)
        cls.runs = {}
        for problem in PROBLEMS:
            with (cls.output / "results" / f"{problem}.csv").open(newline="", encoding="utf-8") as stream:
                for row in csv.DictReader(stream):
                    key = (problem, row["block_type"], row["treatment"], row["parameter"])
                    cls.runs.setdefault(key, []).append(row)

    def errors(self, *key):
        return [float(row["error"]) for row in self.runs[key]]

    def test_consistent_converges_on_every_type_of_block(self):
        for problem in ("elastic-cantilever", "notched-beam"):
            for shape in ("triangles", "quads", "voronoi"):
                coarse, fine = self.errors(problem, shape, "consistent", "")
                self.assertLess(abs(fine), abs(coarse), (problem, shape))
                self.assertLess(abs(fine), 0.05, (problem, shape))

    def test_peak_load_of_the_notched_beam(self):
        for shape, limits in {"triangles": (0.012, 0.01), "quads": (0.03, 0.011), "voronoi": (0.025, 0.016)}.items():
            for error, limit in zip(self.errors("notched-beam", shape, "consistent", ""), limits):
                self.assertGreater(error, 0)
                self.assertLess(error, limit, shape)

    def test_a_stiff_penalty_locks_quads_and_cells(self):
        for problem in ("elastic-cantilever", "notched-beam"):
            for shape in ("quads", "voronoi"):
                self.assertGreater(abs(self.errors(problem, shape, "penalty", "100")[-1]), 0.3)

    def test_the_bar_is_exact_with_any_consistent_stiffness(self):
        for shape in ("triangles", "quads", "voronoi"):
            for alpha in ("0.6", "2", "10"):
                self.assertLess(max(map(abs, self.errors("softening-bar", shape, "consistent", alpha))), 1e-9)

    def test_penalty_adds_the_compliance_of_its_springs_to_the_bar(self):
        """Quads: 2c − 1 joints at distances 50/c mm, c columns in a half: u = ft (2c − 1) 50/(c · factor · E)."""
        for factor in (10, 100):
            for row in self.runs["softening-bar", "quads", "penalty", f"{factor}"]:
                columns = max(1, int(row["size"]) // 2)
                added = 3 * (2 * columns - 1) * 50 / columns / (factor * 30000) / (0.2 / 3)
                self.assertAlmostEqual(float(row["error"]), added, delta=1e-4 * added)

    def test_figures_are_drawn(self):
        for problem in PROBLEMS:
            text = (self.output / "results" / f"{problem}.svg").read_text(encoding="utf-8")
            self.assertGreater(len(xml.etree.ElementTree.fromstring(text)), 0)

    def test_the_region_of_the_readme_and_nothing_else_is_written(self):
        whole = (STUDY / "README.md").read_text(encoding="utf-8")
        made = (self.output / "README.md").read_text(encoding="utf-8")
        begin, end = study.marks()
        self.assertEqual(made.split(begin)[0], whole.split(begin)[0])
        self.assertEqual(made.split(end)[1], whole.split(end)[1])
        region = made.split(begin)[1].split(end)[0]
        row = self.runs["notched-beam", "quads", "consistent", ""][-1]
        self.assertIn(f"{row['blocks']}: {report.percent(float(row['error']))}", region)
        for problem in PROBLEMS:
            self.assertIn(f"(results/{problem}.svg)", region)


class Fronts(unittest.TestCase):
    def test_an_error_that_grows_again_was_touched_not_reached(self):
        through_zero = [(1, 0.1), (2, 0.001), (4, -0.05)]
        self.assertIsNone(fronts.reached(through_zero, 0.01))
        self.assertEqual(fronts.first_touch({"soft": through_zero}, 0.01), (2, "soft"))
        self.assertEqual(fronts.reached([(1, 0.1), (2, 0.01), (4, 0.001)], 0.01), 1)

    def test_time_is_interpolated_on_logarithmic_axes(self):
        line = [(1, 0.1), (4, 0.001)]
        self.assertAlmostEqual(fronts.time_to(line, 0.01), 2)
        self.assertEqual(fronts.time_to(line, 0.5), 1)
        self.assertEqual(fronts.time_to(line, 1e-4), float("inf"))

    def test_a_failed_run_reaches_nothing(self):
        failed = [(1, 0.1), (2, 0.001), (4, float("nan"))]
        self.assertIsNone(fronts.reached(failed, 0.01))
        self.assertEqual(fronts.time_to([(1, float("nan")), (2, 0.001)], 0.01), 2)
        self.assertEqual(fronts.front([failed]), [(1, 0.1), (2, 0.001)])

    def test_the_best_reaches_the_target_first_or_keeps_the_smallest_error(self):
        lines = {"slow": [(1, 0.1), (9, 0.001)], "fast": [(1, 0.1), (3, 0.008)], "coarse": [(1, 0.02), (2, 0.02)]}
        self.assertEqual(fronts.best(lines, 0.01), "fast")
        self.assertEqual(fronts.best(lines, 1e-6), "slow")


if __name__ == "__main__":
    unittest.main()
