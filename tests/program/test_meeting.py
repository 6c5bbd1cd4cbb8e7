"""Bodies that meet in motion, from the deck to what a user sees: impacts, friction, what is told and what is refused.

    test_meeting.py        with PYTHONPATH=python, and DDA naming the program
"""

import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import motion_checks, verify

from test_motion import alone


class Meeting(unittest.TestCase):
    """Decks without stages."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def resting(self, **motion):
        """The block of `alone` on its ground, where no interface lies."""
        deck = alone(velocities=[]) | {"gauges": {}}
        deck["motion"] |= motion
        for material in deck["materials"].values():
            material["young_modulus"] = 1e9
        deck["scene"]["regions"][1]["vertices"] = [[0, 0], [1, 0], [1, 1], [0, 1]]
        return deck

    def test_weight_that_comes_at_once_is_verified(self):
        """Energies of the middle of a step and of its end are no energy that an impact gives back; what is forged is."""
        ddapath.run(self.resting(gravity=[3.3552, -9.2184]), folder=self.folder)
        self.assertEqual([str(finding) for finding in verify(self.folder) if not finding.holds], [])
        curve = ddapath.read_run(self.folder).motion.curve.copy()
        later = curve.index >= len(curve) // 2
        curve.loc[later, "impact_and_damping"] -= 0.03 * motion_checks.scale_of(curve)
        self.assertFalse(motion_checks.impact_gives_nothing_back(curve, motion_checks.GIVEN_BACK).holds)


if __name__ == "__main__":
    unittest.main()
