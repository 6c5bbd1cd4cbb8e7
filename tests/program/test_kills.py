"""Runs that are killed: what is lost is a second or so, whatever they store.

    test_kills.py        with PYTHONPATH=python, and DDA naming the program
"""

import subprocess
import time
import unittest

import ddapath
import yaml

from program_case import ProgramCase
from test_mortar_walls import running_bond


class Kills(ProgramCase):
    def test_a_run_that_stores_no_fields_goes_on_after_a_kill(self):
        deck = running_bond(pressure=.4, strength=.1, energy=.02, columns=7, courses=14) | {"record": {"fields_every": 0}}
        (self.folder / "deck.yaml").write_text(yaml.safe_dump(deck), encoding="utf-8")
        self.dda("run", "deck.yaml", "--folder", "whole", "--quiet")
        rows = len((self.folder / "whole" / "curve.csv").read_text().splitlines())
        killed = self.folder / "killed"
        curve, restart = killed / "curve.csv", killed / "restart.h5"
        run = subprocess.Popen([str(ddapath.find_program()), "run", "deck.yaml", "--folder", "killed", "--quiet"], cwd=self.folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while run.poll() is None and not (curve.exists() and len(curve.read_text().splitlines()) > rows - 4):
            time.sleep(0.01)
        run.kill()
        run.wait()
        self.assertFalse((killed / "summary.json").exists(), "killed before its end")
        self.assertLess(curve.stat().st_mtime - restart.stat().st_mtime, 1.5, "what the kill loses [s]")
        self.dda("resume", "killed", "--quiet")
        self.assertEqual(curve.read_bytes(), (self.folder / "whole" / "curve.csv").read_bytes())

    def test_a_run_that_was_killed_before_it_had_begun_is_told_from_one_that_has(self):
        (self.folder / "empty").mkdir()
        self.assertRegex(self.dda("resume", "empty", code=2), "there is no run here, or it ended before it had begun; .* --overwrite` starts it")
        deck = running_bond(pressure=.4, strength=.1, energy=.02, columns=2, courses=2)
        (self.folder / "deck.yaml").write_text(yaml.safe_dump(deck | {"path": {"stop": {"after_steps": 1}}}), encoding="utf-8")
        self.dda("run", "deck.yaml", "--folder", "begun", "--quiet")
        for file in ("restart.h5", "summary.json"):
            (self.folder / "begun" / file).unlink()
        self.assertRegex(self.dda("resume", "begun", code=2), "ended before its first restart file; .* --overwrite` starts it again")


if __name__ == "__main__":
    unittest.main()
