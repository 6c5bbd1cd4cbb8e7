"""The stability study: what it takes for wrong, and its quick selection. `python3 test_stability.py PROGRAM`."""

import csv
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STUDY = Path(__file__).resolve().parents[2] / "studies" / "stability"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

import decks  # noqa: E402
import placement  # noqa: E402
import runs  # noqa: E402
import transform  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None
NAMES = ("load", "load_factor", "left.x", "left.y", "right", "dissipated_energy", "stored_energy", "external_work", "cmod")


def outcome(**changes):
    """A run that reached its end, with some of its results changed."""
    found = {"exit": 0, "said": "", "status": "goal_reached", "load": [0.0, 10.0, 1.0],
             "steps": [{"step": 1, "residual": 1e-10, "tolerance": 1e-9}]} | changes
    curve = {"load": found["load"], "left.y": [load / 2 for load in found["load"]],
             "right": [load / 2 for load in found["load"]]}
    summary = {"status": found["status"], "peak": {"load": max(found["load"])}}
    return runs.Outcome(runs.Case("case", {}), found["exit"], 1.0, found["said"], Path("."), summary, curve, found["steps"])


class Verdict(unittest.TestCase):
    def test_reached(self):
        self.assertEqual(outcome().verdict, "reached")

    def test_what_is_no_success(self):
        for changes in ({"exit": 3}, {"status": "stopped_early"}, {"load": [0.0, 10.0, 1.1]},
                        {"steps": [{"step": 1, "residual": 2e-9, "tolerance": 1e-9}]},
                        {"steps": [{"step": 1, "residual": math.nan, "tolerance": 1e-9}]}):
            self.assertIn("FAILED", outcome(**changes).verdict, changes)

    def test_only_blocks_too_large_are_an_excuse(self):
        too_large = "the blocks are too large for the softening of interface 'joints'"
        self.assertTrue(outcome(exit=2, said=too_large).refused)
        self.assertFalse(outcome(exit=2, said="unknown key 'tensile'").refused)


class Distance(unittest.TestCase):
    path = {name: [0.0, 1.0, 0.5] for name in NAMES}

    def test_same(self):
        self.assertEqual(transform.distance(self.path, self.path, ["cmod"])[0], 0)

    def test_one_value_off(self):
        for name in set(NAMES) - {"external_work"}:
            other = self.path | {name: [0.0, 1.0, 0.5 + 1e-6]}
            self.assertAlmostEqual(transform.distance(self.path, other, ["cmod"])[0], 1e-6, delta=1e-12, msg=name)

    def test_another_number_of_points(self):
        other = {name: values[:2] for name, values in self.path.items()}
        self.assertEqual(transform.distance(self.path, other, ["cmod"])[0], math.inf)


class Conversion(unittest.TestCase):
    def setUp(self):
        self.deck = decks.beam({"type": "given"}, decks.softening("linear", 100))
        self.deck["gauges"]["force"] = {"type": "load", "scale": 1}
        self.deck["record"]["at"] = {"force": [5.0]}

    def test_units(self):
        metres = placement.UNITS["m, N"].convert(self.deck)
        law = metres["interfaces"]["joints"]["law"]
        self.assertAlmostEqual(metres["materials"]["concrete"]["young_modulus"] / 30e9, 1)
        self.assertAlmostEqual(law["tensile_strength"] / 3e6, 1)
        self.assertAlmostEqual(law["fracture_energy"] / 100, 1)
        self.assertAlmostEqual(metres["scene"]["slits"]["notch"][1][1], decks.BEAM.notch / 1000)

    def test_rotation(self):
        turned = transform.rotation(90).convert(self.deck)
        for found, wanted in zip(turned["stages"][0]["loads"][0]["force"], [1, 0]):
            self.assertAlmostEqual(found, wanted)
        for found, wanted in zip(turned["supports"]["left"]["at"], [0, -150]):
            self.assertAlmostEqual(found, wanted)


@unittest.skipUnless(PROGRAM, "needs the program")
class Quick(unittest.TestCase):
    def test_everything_is_right_and_written(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-B", STUDY / "study.py", "--program", PROGRAM, "--quick", "--output", folder]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout[-4000:] + done.stderr[-2000:])
            with (Path(folder) / "results" / "matrix.csv").open(encoding="utf-8") as stream:
                rows = list(csv.DictReader(stream))
            self.assertEqual({row["shape"] for row in rows}, set(decks.SHAPES))
            self.assertTrue(all(row["verdict"] == "reached" and float(row["peak"]) > 0 for row in rows))
            self.assertIn("of 12 runs reached", (Path(folder) / "README.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
