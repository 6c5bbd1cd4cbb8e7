"""The scaling study: its exponents, and its quick selection. `python3 test_scaling.py PROGRAM`."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "scaling"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

import report  # noqa: E402
from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


def rows(exponent, blocks=(1000, 10_000, 30_000, 100_000)):
    return [{"blocks": n, "total": 1e-4 * n**exponent} for n in blocks]


class Exponent(unittest.TestCase):
    def test_of_a_power(self):
        self.assertAlmostEqual(report.exponent(rows(1.3), "total"), 1.3, places=10)

    def test_small_beams_do_not_count(self):
        found = rows(1.2)
        found[0]["total"] *= 100
        self.assertAlmostEqual(report.exponent(found, "total"), 1.2, places=10)

    def test_needs_two_large_beams(self):
        self.assertIsNone(report.exponent(rows(1, (1000, 3000, 10_000)), "total"))

    def test_a_limit_that_is_missed_is_said(self):
        said = " ".join(report.verdicts([row | {"one reduced iteration": 1, "one step": 1} for row in rows(1.5)]))
        self.assertIn("Exponent of total: 1.50, at most 1.45: **no**", said)
        self.assertIn("Exponent of one reduced iteration: 0.00, at most 0.7: yes", said)
        self.assertIn("Exponent of one step: 0.00, at most 0.75: yes", said)


class Quick(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "needs the program")
    def test_quick_writes_table_and_figure(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder)
            subprocess.run(["/usr/bin/python3", "-B", STUDY / "study.py", "--program", PROGRAM, "--quick", "--output",
                            output], check=True, capture_output=True)
            found = study.read_rows(output / "results" / "scaling.csv")
            self.assertEqual([row["beam"] for row in found], ["triangles", "triangles", "voronoi", "voronoi", "through blocks", "through blocks"])
            for row in found:
                if row["beam"] != "through blocks":  # whose segments may be aimed anew after they were factorised
                    self.assertEqual(row["factorisations"], 1)
                self.assertLess(row["factorisations"], 5, row)
                self.assertLess(row["predicted_mib"], row["memory_mib"], row)
            self.assertIn("| reduced iterations [s] |", (output / "README.md").read_text(encoding="utf-8"))
            self.assertTrue((output / "results" / "scaling.svg").exists())


if __name__ == "__main__":
    unittest.main()
