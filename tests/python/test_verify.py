"""`dda verify`: a true run passes every check, a doctored one is refused by the check that is meant."""

import dataclasses
import json
import os
import shutil
import subprocess
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from unittest import mock

import h5py
import numpy as np
import pandas as pd

import ddapath
from ddapath.run_folder import sealed
from ddapath.verify import curve_checks, laws, verify
from ddapath.verify.model import Model

TESTS = Path(__file__).resolve().parents[1]


class Copies(unittest.TestCase):
    """A run, and for each test a copy of it that may be changed."""
    deck = "beam.yaml"
    settings = {"path.stop.load_below": 0.3, "record.fields_every": 4}

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.original = Path(cls.scratch.name) / "run"
        ddapath.run(TESTS / "program" / cls.deck, cls.settings, folder=cls.original)

    def setUp(self):
        self.folder = Path(self.scratch.name) / "copy"
        shutil.copytree(self.original, self.folder)
        self.addCleanup(shutil.rmtree, self.folder)

    def refused(self):
        return [finding.check for finding in verify(self.folder) if not finding.holds]

    def step_file(self, index):
        return sorted((self.folder / "fields").glob("[0-9]*.h5"))[index]

    def change_dataset(self, name, change, step=-1):
        """`change` gets the last stored step's rows and changes them in place; the file is sealed again."""
        path = self.step_file(step)
        with h5py.File(path, "a") as file:
            values = file[name][()]
            change(values)
            file[name][...] = values
        path.write_bytes(sealed(path.read_bytes()))

    def change_field(self, name, change, step=-1):
        self.change_dataset(f"segments/{name}", change, step)

    def change_cell(self, column, row, change):
        file = self.folder / "curve.csv"
        rows = [line.split(",") for line in file.read_text().splitlines()]
        at = rows[0].index(column)
        rows[row][at] = change(rows[row][at])
        file.write_text("\n".join(",".join(cells) for cells in rows) + "\n")

    def change_summary(self, **values):
        file = self.folder / "summary.json"
        file.write_text(json.dumps(json.loads(file.read_text()) | values))


class Doctored(Copies):
    def test_a_true_run_passes(self):
        findings = verify(self.folder)
        self.assertEqual([finding.check for finding in findings if not finding.holds], [])
        self.assertEqual([finding.check for finding in findings if not finding.is_made], ["multipliers carry the traction"])

    def test_a_traction_scaled(self):
        def scale(values):
            values[np.argmax(np.abs(values[:, 0])), 0] *= 1.01
        self.change_field("traction", scale)
        self.assertIn("block equilibrium", self.refused())
        self.assertIn("contact and normal law", self.refused())

    def test_a_traction_beyond_its_strength(self):
        def exceed(values):
            values[np.argmax(values[:, 0]), 0] = 10
        self.change_field("traction", exceed)
        self.assertIn("law envelope", self.refused())

    def test_a_block_moved(self):
        def move(values):
            values[:4] += 1e-6
        self.change_dataset("displacement", move)
        self.assertIn("contact and normal law", self.refused())

    def test_damage_lowered(self):
        def lower(values):
            values[np.argmax(values)] -= 0.01
        self.change_field("damage", lower)
        self.assertIn("damage never falls", self.refused())

    def test_a_load_altered(self):
        self.change_cell("load", -1, lambda cell: repr(1.5 * float(cell)))
        self.assertIn("last row is what the reason says", self.refused())

    def test_a_reaction_altered(self):
        self.change_cell("right", -1, lambda cell: repr(1.001 * float(cell)))
        self.assertEqual(self.refused(), ["fields agree with curve.csv"])

    def test_work_altered(self):
        self.change_cell("external_work", -1, lambda cell: repr(1.1 * float(cell)))
        self.assertIn("work = stored + dissipated + jumps", self.refused())
        self.assertIn("summary.json agrees with curve.csv", self.refused())

    def test_stored_energy_altered(self):
        self.change_cell("stored_energy", -1, lambda cell: repr(1.001 * float(cell)))
        self.assertIn("stored energy of curve.csv", self.refused())

    def test_dissipated_energy_that_falls(self):
        self.change_cell("dissipated_energy", -2, lambda cell: repr(2 * float(cell)))
        self.assertIn("dissipated energy never falls", self.refused())

    def test_a_number_that_is_none(self):
        self.change_cell("stored_energy", 3, lambda _: "nan")
        self.assertIn("every number is finite", self.refused())

    def test_unknown_stability_is_allowed(self):
        self.change_cell("negative_eigenvalues", 3, lambda _: "nan")
        self.assertEqual(self.refused(), [])

    def test_frequencies_of_some_rows_are_allowed(self):
        table = self.folder / "curve.csv"
        lines = table.read_text().splitlines()
        table.write_text("\n".join(line + tail for line, tail in zip(lines, (",frequency_1", ",3.5", *[",nan"] * len(lines)))) + "\n")
        self.assertEqual(self.refused(), [])

    def test_reasons_altered(self):
        for reason in ("deflection reached 0.5", "load below 20 % of its peak", "complete rupture", "1000 steps", "done", ""):
            self.change_summary(reason=reason)
            self.assertEqual(self.refused(), ["last row is what the reason says"], reason)

    def test_an_early_stop_needs_a_reason(self):
        self.change_summary(status="stopped_early", reason="")
        self.assertEqual(self.refused(), ["last row is what the reason says"])

    def test_threads_do_not_disturb_each_other(self):
        """A matrix product begun while another thread is at one may be wrong: see ONE_AT_A_TIME."""
        inside, most = [], []

        def slowly(*arguments):
            inside.append(1)
            most.append(len(inside))
            time.sleep(0.05)
            inside.pop()
            return Model(*arguments)
        with mock.patch("ddapath.verify.Model", slowly), ThreadPoolExecutor(4) as pool:
            self.assertEqual([found.holds for each in pool.map(verify, 4 * [self.folder]) for found in each].count(False), 0)
        self.assertEqual(max(most), 1)

    def test_an_unfinished_run(self):
        (self.folder / "summary.json").unlink()
        self.assertEqual(self.refused(), [])


class DoctoredCracks(Copies):
    """Blocks cut by a crack that turns."""
    deck = "cracked_beam.yaml"

    def test_a_true_run_passes(self):
        findings = verify(self.folder)
        self.assertEqual([finding.check for finding in findings if not finding.holds], [])
        self.assertEqual([finding.check for finding in findings if not finding.is_made], ["multipliers carry the traction"])
        self.assertGreater(len(ddapath.read_run(self.folder).cracks()), 6)

    def test_a_part_moved(self):
        """By a thousandth of how far its crack is open: neither it nor what is joined to it is at rest then."""
        fields = ddapath.read_run(self.folder).fields()

        def move(values):
            values[fields.cut.parts.offsets[-2]:, 0] += 1e-3 * fields.cracks["opening_n"].max()
        self.change_dataset("parts/displacement", move)
        self.assertIn("block equilibrium", self.refused())

    def test_a_traction_scaled(self):
        def scale(values):
            values[np.argmax(np.abs(values[:, 0])), 0] *= 1.01
        self.change_dataset("cracks/traction", scale)
        self.assertIn("block equilibrium", self.refused())

    def test_a_traction_beyond_its_strength(self):
        def exceed(values):
            values[0] = [3.5, 0, 0]
        self.change_dataset("cracks/traction", exceed, step=1)
        self.assertIn("law envelope", self.refused())

    def test_damage_lowered(self):
        def lower(values):
            values[0] -= 0.1
        self.change_dataset("cracks/damage", lower)
        self.assertIn("damage never falls", self.refused())

    def test_a_cut_forgotten(self):
        """The part beyond it hangs on nothing then."""
        def shift(values):
            values[0] = values[1]
        self.change_dataset("parts/moves", shift)
        self.assertIn("block equilibrium", self.refused())


class Command(unittest.TestCase):
    def verify(self, *folders):
        return subprocess.run([os.environ["DDA"], "verify", *map(str, folders)], capture_output=True, text=True, check=False)

    def test_codes_and_table(self):
        with tempfile.TemporaryDirectory() as scratch:
            run = ddapath.run(TESTS / "program" / "beam.yaml", {"path.stop.load_below": 0.8}, folder=Path(scratch) / "run").folder
            said = self.verify(run)
            self.assertEqual((said.returncode, said.stderr), (0, ""))
            self.assertIn("block equilibrium", said.stdout)
            summary = run / "summary.json"
            summary.write_text(summary.read_text().replace("load below 80 %", "load below 8 %"))
            said = self.verify(run)
            self.assertEqual(said.returncode, 3)
            self.assertIn("REFUSED  last row is what the reason says", said.stdout)
            kept = Path(scratch) / "verified.txt"
            quiet = self.verify("--out", kept, run)
            self.assertEqual((quiet.returncode, quiet.stdout, kept.read_text()), (3, "", said.stdout))
            lost = self.verify("--out", Path(scratch) / "none" / "verified.txt", run)
            self.assertEqual(lost.returncode, 4)
            self.assertIn("No such file or directory", lost.stderr)
            said = self.verify(run, Path(scratch) / "none")
            self.assertEqual(said.returncode, 2)
            self.assertIn("there is no such folder", said.stderr)
            summary.unlink()
            self.assertIn("all checks hold so far; the run is not finished", self.verify(run).stdout)

    def test_a_sweep_is_answered_in_words_of_the_command(self):
        with tempfile.TemporaryDirectory() as scratch:
            (Path(scratch) / "sweep.json").write_text("{}")
            said = self.verify(scratch)
            self.assertEqual((said.returncode, said.stdout), (2, ""))
            self.assertEqual(said.stderr, f"{scratch}: this is a sweep; give one of its runs, {scratch}/cases/*\n")


class Laws(unittest.TestCase):
    def state(self, damage, stiffness=1000.0):
        damage = np.atleast_1d(damage).astype(float)
        one = np.ones_like(damage)
        return laws.State(stiffness * one, damage, one, 2.0, False)

    def test_softening_curves_give_back_their_points(self):
        """From ω over the secant r = ft g/(w + ft g/k) to the damage, and back to ft g."""
        for kind in ("linear_softening", "bilinear_softening", "exponential_softening"):
            law = laws.make({"type": kind, "tensile_strength": 3, "fracture_energy": 0.1, "shear_fracture_energy": 0.4})
            for mixity in (0.0, 1.0):
                energy = 0.1 * (1 + 3 * mixity)
                for omega in (1e-6, 0.3, 0.7, 1.2, 1.9):
                    traction = 3 * law.shape.value(np.array([omega]))
                    secant = traction / (omega * energy / 3 + traction / 1000)
                    found = law.limit(np.array([mixity]), self.state(1 - secant / 1000))
                    self.assertAlmostEqual(float(found[0] / traction[0]), 1, places=8, msg=f"{kind} {omega}")

    def test_envelopes(self):
        friction = laws.make({"type": "friction", "friction_angle": 45})
        excess, _ = friction.excess(np.array([[-2.0, 1.9], [-2.0, 2.1], [0.1, 0.0]]), self.state([1, 1, 1]))
        np.testing.assert_allclose(excess, [0 - 0.1, 0.1, 0.1], atol=1e-12)
        bond = laws.make({"type": "mohr_coulomb", "tensile_strength": 3, "cohesion": 5, "friction_angle": 45})
        traction = np.array([[3.1, 0.0], [-1.0, 6.1], [1.0, 0.1], [0.1, 0.0]])
        excess, _ = bond.excess(traction, self.state([0, 0, 0.5, 1]))
        np.testing.assert_allclose(excess, 0.1, atol=1e-12)

    def test_tractions_whose_squares_vanish(self):
        """Of an exponential tail; every number stays one."""
        law = laws.make({"type": "exponential_softening", "tensile_strength": 3, "fracture_energy": 0.1, "shear_fracture_energy": 0.4})
        excess, scale = law.excess(np.array([[1e-200, 2e-200], [0.0, 1e-300], [0.0, 0.0]]), self.state([0.5, 0.5, 0.5]))
        self.assertTrue((excess < 0).all() and (scale > 0).all(), excess)

    def test_normal_tractions_of_what_is_released(self):
        bond = laws.make({"type": "mohr_coulomb", "tensile_strength": 3, "cohesion": 5})
        opening, damage = np.array([0.002, 0.002, 0.01, -0.002]), [0.5, 1, 1, 1]
        released = self.state(damage)
        releasing = dataclasses.replace(released, releasing=True)
        for state, traction in ((released, [2, 0, 0, -2]), (releasing, [2, 1.5, 3, -2])):
            np.testing.assert_allclose(bond.normal_error(np.array(traction), opening, state), 0, atol=1e-12)
        for state, traction in ((released, [0, 1.5, 3, 0]), (releasing, [1.5, 2.5, 3.5, 0])):
            self.assertTrue((bond.normal_error(np.array(traction), opening, state) > 0.4).all())


class Reasons(unittest.TestCase):
    """Each kind of goal, true and false."""
    curve = pd.DataFrame({"load": [0.0, 9.0, 6.0, 6.0], "load_factor": [0.0, 9.0, 6.0, 6.0], "drift": [0.0, 1.0, 1.5, 2.0],
                          "drift_top": [0.0, 1.0, 2.0, 3.0]})
    deck = {"path": {"stop": {"steps": 1000, "after_steps": 3}}, "interfaces": {"a": {"law": {"type": "friction"}}}}

    def holds(self, reason):
        return curve_checks.reason_is_true(self.curve, {"status": "goal_reached", "reason": reason}, self.deck).holds

    def test_true_ones(self):
        for reason in ("drift_top reached 3", "drift reached 2", "drift reached 1.9 and stands at 2", "load below 70 % of its peak",
                       "3 steps", "slides as a mechanism at a load factor of 6: 2 points slide, 0 are open", "load reached 6"):
            self.assertTrue(self.holds(reason), reason)

    def test_false_ones(self):
        for reason in ("drift_top reached 2", "drift reached 2.1 and stands at 2", "drift reached 1.9 and stands at 2.1", "1000 steps",
                       "load below 60 % of its peak", "slides as a mechanism at a load factor of 6.001", "complete rupture",
                       "complete rupture: 1.0e-03 of the peak was left", "nothing can crack; the full reference load is applied",
                       "no joint slides, opens or closes under this load, however large; it is applied in full"):
            self.assertFalse(self.holds(reason), reason)

    def test_a_load_that_has_turned_round(self):
        turned = self.curve.assign(load=[0.0, 9.0, 6.0, -4.5])
        for reason, is_true in (("load below 30 % of its peak, turned round to -50 %", True),
                                ("load below 30 % of its peak, turned round to -40 %", False),
                                ("load below 30 % of its peak", False)):
            found = curve_checks.reason_is_true(turned, {"status": "goal_reached", "reason": reason}, self.deck)
            self.assertEqual(found.holds, is_true, reason)

    def test_a_mechanism_whose_load_still_changes(self):
        moving = self.curve.assign(load=[0.0, 9.0, 7.0, 6.0])
        summary = {"status": "goal_reached", "reason": "slides as a mechanism at a load factor of 6: 2 points slide, 0 are open"}
        self.assertFalse(curve_checks.reason_is_true(moving, summary, self.deck).holds)


if __name__ == "__main__":
    unittest.main()
