"""The size-effect study: its numbers, and its quick selection. `python3 test_size_effect.py PROGRAM`."""

import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

STUDY = Path(__file__).resolve().parents[2] / "studies" / "size-effect"
sys.path[:0] = [str(STUDY), str(STUDY.parents[1] / "python")]

import nominal  # noqa: E402
import report  # noqa: E402
import size_effect_law as law  # noqa: E402
from ddapath import study  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None
NOTCHED = nominal.BEAMS[0]


def straight_rows(exact, length=1.0, order=2):
    """Strengths with an error of 1 % on 4 mm blocks that falls with their size."""
    return [{"beam": "notched", "length": length, "block_size": h, "strength": exact * (1 + 0.01 * (h / 4)**order)}
            for h in (2.0, 4.0, 1.0)]


class Convergence(unittest.TestCase):
    def test_estimate_is_the_error_where_the_order_is_right(self):
        found = nominal.peaks(NOTCHED, straight_rows(0.34817))[0]
        self.assertAlmostEqual(found.estimate, 0.01 / 16, delta=1e-6)
        self.assertAlmostEqual(found.error, 0.01 / 16, delta=1e-12)
        self.assertAlmostEqual(found.observed_order, 2, delta=1e-9)

    def test_another_order_is_seen(self):
        self.assertAlmostEqual(nominal.peaks(NOTCHED, straight_rows(0.3, order=1))[0].observed_order, 1, delta=1e-9)

    def test_no_order_without_monotonic_convergence(self):
        self.assertTrue(math.isnan(nominal.observed_order([1.0, 1.1, 1.05], 2)))

    def test_a_size_that_the_other_solver_has_not(self):
        self.assertTrue(math.isnan(nominal.peaks(NOTCHED, straight_rows(0.3, length=3.0))[0].error))

    def test_what_is_too_far_off_is_said(self):
        rows = straight_rows(0.34817 * 1.012) + straight_rows(0.16125 * 1.012, length=10.0)
        said = "\n".join(report.verdict(NOTCHED, nominal.peaks(NOTCHED, rows)))
        self.assertIn("within 1 % for D/l_ch ≤ 4: **no**", said)
        self.assertIn("within 2 % for D/l_ch > 4: yes", said)


class Strength(unittest.TestCase):
    def test_of_a_case(self):
        import study

        deck = study.ddapath.read_deck(STUDY / "four-point.yaml")
        import pandas

        table = pandas.DataFrame([{"interfaces.ligament.law.fracture_energy": 0.003, "peak.load": 2e4, "blocks": 5,
                                   "steps": 6, "scene.parameters.ligament_size": 2}])
        row, = nominal.strengths(nominal.BEAMS[2], deck, table)
        self.assertEqual(row["length"], 10)
        self.assertAlmostEqual(row["strength"], 6 * (2e4 / 2 * 100) / (100 * 100**2) / 3)


class Law(unittest.TestCase):
    def test_exact_points_are_met(self):
        x = np.array(nominal.LENGTHS)
        found = law.fit(x, 0.6 / np.sqrt(1 + x / 0.3))
        self.assertAlmostEqual(found.b, 0.6, places=10)
        self.assertAlmostEqual(found.d0, 0.3, places=10)
        self.assertLess(max(found.b_half, found.d0_half, found.largest), 1e-9)

    def test_quantiles_of_student(self):
        # Closed forms for one and two degrees of freedom; the normal distribution for many.
        self.assertAlmostEqual(law.student(1), math.tan(0.95 * math.pi / 2), places=3)
        self.assertAlmostEqual(law.student(2), 0.95 / math.sqrt((1 - 0.95**2) / 2), places=4)
        self.assertAlmostEqual(law.student(10**6), 1.959964, places=3)

    def test_intervals_cover_the_truth_as_often_as_they_say(self):
        random, x, covered, trials = np.random.default_rng(1), np.array(nominal.LENGTHS), 0, 2000
        for _ in range(trials):
            noisy = 0.6 / np.sqrt(1 + x / 0.3) * (1 + 0.01 * random.standard_normal(len(x)))
            found = law.fit(x, noisy)
            covered += abs(found.b - 0.6) <= found.b_half
        self.assertAlmostEqual(covered / trials, law.CONFIDENCE, delta=0.02)

    def test_large_notched_beams_are_those_of_linear_elastic_fracture_mechanics(self):
        found = law.fit(nominal.LENGTHS[-3:], NOTCHED.reference[-3:])
        self.assertAlmostEqual(found.slope / law.LEFM_SLOPE, 1, delta=0.08)


class Bias(unittest.TestCase):
    def test_of_two_seeds(self):
        straight = nominal.peaks(NOTCHED, straight_rows(0.3, order=0))
        rows = [{"length": 1.0, "strength": straight[0].strength * factor} for factor in (1.1, 1.3)]
        found, = nominal.biases(NOTCHED, rows, straight)
        self.assertAlmostEqual(found.mean, 0.2)
        self.assertAlmostEqual(found.scatter, 0.2 / math.sqrt(2))


class SecondOrder(unittest.TestCase):
    def test_is_held_against_the_finest_of_first_order(self):
        straight = [row | {"seconds": 8 / row["block_size"]} for row in straight_rows(0.3, order=0)]
        row = {"length": 1.0, "block_size": 4.0, "blocks": 5, "strength": straight[0]["strength"] * 1.002, "seconds": 2.0}
        found, = nominal.second_orders(NOTCHED, [row], straight)
        self.assertAlmostEqual(found.difference, 0.002)
        self.assertAlmostEqual(found.time, 0.25)


class Quick(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "needs the program")
    def test_quick_is_right_and_written(self):
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder)
            command = ["/usr/bin/python3", "-B", STUDY / "study.py", "--program", PROGRAM, "--quick", "--output", output,
                       "--runs", output / "runs"]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr[-3000:])
            rows = study.read_rows(output / "results" / "straight.csv")
            second = study.read_rows(output / "results" / "second-order.csv")
            for beam in nominal.BEAMS:
                for peak in nominal.peaks(beam, report.of_beam(rows, beam)):
                    self.assertLess(abs(peak.error), 0.005, peak)
                orders = nominal.second_orders(beam, report.of_beam(second, beam), report.of_beam(rows, beam))
                self.assertEqual(len(orders), 6)
                for order in orders:
                    self.assertLess(abs(order.difference), 0.01, order)
            self.assertEqual(len(study.read_rows(output / "results" / "voronoi.csv")), 6)
            self.assertIn("| mesh bias |", (output / "README.md").read_text(encoding="utf-8"))
            self.assertTrue((output / "results" / "size-effect.svg").exists())


if __name__ == "__main__":
    unittest.main()
