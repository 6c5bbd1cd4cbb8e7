"""Bodies that nothing but contact holds, in a structure every side of which may crack: exact joints find the load of the others.

    test_enclosed_bodies.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest
from pathlib import Path

import ddapath
from program_case import ProgramCase

DECK = Path(__file__).resolve().parent / "headed_stud.yaml"


class HeadedStud(ProgramCase):
    def peak(self, treatment):
        deck = ddapath.read_deck(DECK)
        for joint in deck["interfaces"].values():
            joint["treatment"] = treatment
        summary = ddapath.run(deck, folder=self.folder / treatment).summary
        self.assertEqual(summary["status"], "goal_reached", summary["reason"])
        return summary["peak"]["load"]

    def test_multipliers_on_every_side_bear_what_consistent_joints_do(self):
        self.assertAlmostEqual(self.peak("augmented_lagrangian") / self.peak("consistent"), 1, delta=0.03)


if __name__ == "__main__":
    unittest.main()
