"""The quick selection of the study of bodies in motion. `python3 test_bodies_in_motion.py PROGRAM`."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "bodies-in-motion"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

import several  # noqa: E402
from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


class Statics(unittest.TestCase):
    def test_regions_of_the_chart(self):
        found = {several.behaviour(*case) for case in several.CHART}
        self.assertEqual(found, {"stands", "slides", "topples", "both"})
        self.assertEqual(several.behaviour(0.5, 26.5, 40), "stands")
        self.assertEqual(several.behaviour(0.5, 26.6, 40), "topples")


class Quick(unittest.TestCase):
    def test_is_within_its_bounds(self):
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run([sys.executable, "-B", str(STUDY / "study.py"), "--program", PROGRAM, "--quick", "--output",
                                   scratch], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = study.read_rows(Path(scratch) / "results" / "single.csv")
            self.assertGreater(len(rows), 5)
            for row in rows:
                self.assertLessEqual(row["error"], row["bound"], row["case"])
            self.assertIn("| throw, 1 s, longest steps |", (Path(scratch) / "README.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
