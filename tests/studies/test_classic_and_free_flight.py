"""The quick selection of classic-and-free-flight. `python3 test_classic_and_free_flight.py PROGRAM`."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "classic-and-free-flight"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        cls.done = subprocess.run([sys.executable, "-B", str(STUDY / "study.py"), "--program", PROGRAM, "--quick", "--output",
                                   cls.scratch.name], capture_output=True, text=True, check=False)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def rows(self, table):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        return study.read_rows(self.folder / "results" / table)

    def test_both_integrators_are_within_their_bounds(self):
        rows = self.rows("scenes.csv")
        self.assertEqual({row["integrator"].split(",")[0] for row in rows}, {"free_flight", "classic"})
        for row in rows:
            self.assertLess(row["missed"], 1e-5, row)
            self.assertEqual(row["ended"], "True", row)

    def test_rotation_in_first_order_lets_a_block_grow(self):
        """A hundred steps a turn: by 1 + r² in each of a thousand."""
        grown = [row for row in self.rows("scenes.csv") if "first_order" in row["integrator"]]
        r = 2 * 3.141592653589793 / 100
        self.assertAlmostEqual(grown[0]["found"] / (1 + r * r)**1000, 1, delta=0.02)

    def test_rebound_is_none_of_free_flight(self):
        found = {row["integrator"].split(",")[0]: row["found"] for row in self.rows("scenes.csv") if row["scene"].startswith("falls")}
        self.assertLess(found["free_flight"], 0.05)
        self.assertGreater(found["classic"], 0.2)

    def test_collapses_are_told(self):
        rows = self.rows("collapse.csv")
        self.assertEqual([row["scene"].split()[0] for row in rows], ["column", "column", "falling", "falling"])
        for row in rows:
            self.assertLess(row["missed"], 1e-4, row)
        for name in ("rebound.svg", "collapse.svg"):
            self.assertIn("</svg>", (self.folder / name).read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
