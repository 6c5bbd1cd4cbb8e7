"""Every step of every control is converged by NOX and taken by LOCA's stepper.

    test_taken_steps.py        with DDA naming the program
"""

import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS / "studies"))

import taken_steps  # noqa: E402

DDA = os.environ["DDA"]
BEAM = TESTS / "program" / "beam.yaml"
RELEASING = "interfaces.any.law={type: mohr_coulomb, tensile_strength: 3, cohesion: 3, friction_angle: 30}"
SLIDING = "interfaces.any.law={type: linear_softening, tensile_strength: 3, fracture_energy: 0.05, friction_angle: 40}"
DEAD_LOAD = ("stages=[{loads: [{type: body_force, force: [0, -2.4e-5]}]}, "
             "{loads: [{type: point_load, at: [150, 100], force: [0, -1]}]}]")
# Beside each control: how else its steps are found.
VARIANTS = {"as it is": (), "all unknowns": ("path.update=refactorise",), "friction": (SLIDING,), "release": (RELEASING,),
            "after dead loads": (DEAD_LOAD,)}


def controls():
    said = subprocess.run([DDA, "explain", "control"], capture_output=True, text=True, check=True).stdout
    return re.findall(r"^  (\w+)  ", said, re.MULTILINE)


class TakenSteps(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def follow(self, *settings, deck=BEAM):
        """The rows of a run that has ended by itself."""
        command = [DDA, "run", deck, "--quiet", "--overwrite", "--folder", self.folder]
        for setting in (*settings, "path.stop.after_steps=40"):
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        self.assertEqual(list(taken_steps.complaints(self.folder)), [])
        with (self.folder / "curve.csv").open(newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def test_under_every_control(self):
        names = controls()
        self.assertIn("staged", names)
        for control in names:
            for variant, settings in VARIANTS.items():
                with self.subTest(control=control, variant=variant):
                    self.assertGreater(len(self.follow(f"path.control={control}", *settings)), 1)

    def test_rows_tell_the_iterations_of_releases_and_increments(self):
        for control, kind in (("staged", "release"), ("load_increments", "load_increments")):
            rows = self.follow(f"path.control={control}", RELEASING)
            found = [int(row["newton_iterations"]) for row in rows if row["control"] == kind]
            self.assertTrue(found, control)
            self.assertGreater(min(found), 0, control)

    def test_the_summary_has_the_iterations_of_the_rows(self):
        for settings in ((), ("path.update=refactorise",)):
            rows = self.follow(*settings)
            summary = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
            self.assertEqual(summary["newton_iterations"], sum(int(row["newton_iterations"]) for row in rows))
            self.assertGreater(summary["newton_iterations"], 0)

    def test_a_resumed_run_counts_on(self):
        self.follow("path.stop.steps=7")
        resumed = subprocess.run([DDA, "resume", self.folder, "--quiet", "--set", "path.stop.steps=20"], capture_output=True,
                                 text=True, check=False)
        self.assertEqual(resumed.returncode, 3, resumed.stderr)
        self.assertEqual(list(taken_steps.complaints(self.folder)), [])


if __name__ == "__main__":
    unittest.main()
