"""The study of many ranks: what it foresees, and its quick selection. `python3 test_many_ranks.py PROGRAM`."""

import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "many-ranks"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

import tables  # noqa: E402
from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None
B = 600  # unknowns between two strips of 10⁵ blocks


SOLUTIONS = 4e7  # numbers of all solutions with 10⁵ blocks


def row(blocks, ranks):
    """Of a run that has factorised once."""
    part = blocks / 1e5
    borders = (2 * (ranks - 2) + 0.5) * B**2 * part
    received = 0.0 if ranks == 1 else 8 * (borders + (1 - 2 / ranks**2) * SOLUTIONS * part) / tables.MIB
    return {"blocks": blocks, "ranks": ranks, "factorisations": 1, "received_mib": received, "factorisation": (blocks / 1e5) ** 1.5}


class Foreseen(unittest.TestCase):
    rows = [row(blocks, ranks) for blocks in (1e4, 1e5) for ranks in (1, 2, 3, 4)]

    def test_rows_between_two_strips_follow_from_what_ranks_exchange(self):
        self.assertAlmostEqual(tables.border_rows(self.rows[-4:]), B)

    def test_one_rank_has_nothing_between_strips(self):
        alone = tables.of_ranks(self.rows, 1)
        self.assertEqual([alone[name] for name in ("received", "between", "operations")], [0, 0, 0])
        self.assertAlmostEqual(alone["seconds"], (tables.LARGE / 1e5) ** 1.5)

    def test_work_between_strips_grows_with_their_number(self):
        b = B * math.sqrt(tables.LARGE / 1e5)
        four = tables.of_ranks(self.rows, 4)
        self.assertAlmostEqual(four["operations"] / (3 * b**3 / 3 + 2 * 2 * b**3), 1)
        self.assertAlmostEqual(four["between"] / (8 * 5 * b**2), 1)
        self.assertAlmostEqual(four["received"] / (8 * 4.5 * b**2), 1)

    def test_the_best_number_of_ranks_falls_with_a_slower_rank_0(self):
        self.assertGreater(tables.best_number(self.rows, 1e13), tables.best_number(self.rows, 1e9))


class Quick(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "needs the program")
    def test_quick_writes_the_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder)
            subprocess.run(["/usr/bin/python3", "-B", STUDY / "study.py", "--program", PROGRAM, "--quick", "--output", output],
                           check=True, capture_output=True)
            found = study.read_rows(output / "results" / "many-ranks.csv")
            self.assertEqual([row["ranks"] for row in found], [1, 2, 3, 4])
            for row in found:
                self.assertAlmostEqual(row["peak_load"] / found[0]["peak_load"], 1, delta=1e-5)
            self.assertTrue((output / "results" / "many-ranks.svg").exists())
            self.assertIn("### 10 million blocks", (output / "README.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
