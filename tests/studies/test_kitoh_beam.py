"""The study of Kitoh's beam: its tables, and its quick selection. `python3 test_kitoh_beam.py PROGRAM`."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "kitoh-beam"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

import report  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


class Tables(unittest.TestCase):
    def test_bias_is_against_the_reference(self):
        rows = [{"name": "law", "blocks": 130.0, "peak_load": 14997 * share} for share in (1.1, 1.3)]
        line = list(report.bias_table(rows))[-1]
        self.assertEqual(line, "| law | 130 | 2 | +20.0 % | +10.0 % | +30.0 % |")

    def test_a_straight_crack_is_compared_with_its_own_size(self):
        row = {"name": "h = 800, Gf = 0.1", "peak_load": 84220 * 1.01, "blocks": 1, "steps": 2, "seconds": 3}
        self.assertIn("| 800 | 0.1 | 84.220 | 85.062 | +1.00 % |", list(report.straight_table([row]))[-1])


class Quick(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "needs the program")
    def test_quick_writes_tables_and_figures(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder)
            subprocess.run(["/usr/bin/python3", "-B", STUDY / "study.py", "--program", PROGRAM, "--quick", "--output",
                            output], check=True, capture_output=True)
            text = (output / "README.md").read_text(encoding="utf-8")
            self.assertIn("| fracture energy, coarse | 130 |", text)
            self.assertIn("release, increments, Newton, coarse: failure: no equilibrium", text)
            for figure in ("curve", "cracks-coarse", "release-coarse"):
                self.assertTrue((output / "results" / f"{figure}.svg").exists(), figure)


if __name__ == "__main__":
    unittest.main()
