"""What a run may go on with another of: its controls, goals and records, and nothing of its structure.

    test_resumed_decks.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

BEAM = Path(__file__).with_name("beam.yaml")
OF_STRUCTURE = {
    "thickness": 7, "plane": "strain", "support_stiffness": 10, "units.length": "m", "supports.left.at": [1, 0],
    "stages.0.loads.0.force": [0, -2], "materials.concrete.young_modulus": 1e3, "gauges.deflection.direction": [0, 1],
    "interfaces.any.law.tensile_strength": 2, "path.load_gauge": "deflection"}


class ResumedDecks(ProgramCase):
    def setUp(self):
        super().setUp()
        ddapath.run(BEAM, {"path.stop.after_steps": 5}, folder=self.folder / "run")
        self.before = (self.folder / "run" / "curve.csv").read_bytes()

    def test_of_another_structure_is_refused(self):
        for key, value in OF_STRUCTURE.items():
            with self.subTest(key=key):
                with self.assertRaisesRegex(ddapath.InputError, f"`{key}"):
                    ddapath.resume(self.folder / "run", {key: value, "path.stop.after_steps": 0})
                self.assertEqual((self.folder / "run" / "curve.csv").read_bytes(), self.before)

    def test_a_goal_that_has_been_passed_is_refused(self):
        with self.assertRaisesRegex(ddapath.InputError, "3 steps are wanted, and the run has made 5"):
            ddapath.resume(self.folder / "run", {"path.stop.after_steps": 3})

    def test_under_another_control(self):
        whole = ddapath.run(BEAM, folder=self.folder / "whole")
        for control in ("displacement", "arc_length", "load_increments"):
            with self.subTest(control=control):
                run = ddapath.resume(self.folder / "run", {"path.control": control, "path.stop.after_steps": 0}, into=self.folder / control,
                                     check=control != "load_increments")
                self.assertLess(abs(run.summary["peak"]["load"] / whole.summary["peak"]["load"] - 1), 2e-3)
                self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])


if __name__ == "__main__":
    unittest.main()
