"""Ground that settles under dry masonry goes down as far as it is driven, whatever the joints and the stiffness of the bricks.

    test_settlement.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

DECK = Path(__file__).parent / "settling_wall.yaml"
INTERFACES = ("joints", "bed", "gap")


class Settlement(ProgramCase):
    def settle(self, treatment, points="gauss", **overrides):
        """The run, which has gone down by 20 mm, or as far as `overrides` say, in states that hold."""
        joints = {f"interfaces.{name}.{key}": value for name in INTERFACES for key, value in (("treatment", treatment), ("points", points))}
        run = ddapath.run(DECK, {**joints, **overrides}, self.folder / "run", overwrite=True, check=False)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        return run

    def test_all_joints_follow(self):
        for treatment, points in (("consistent", "gauss"), ("penalty", "gauss"), ("penalty", "vertices"), ("lagrange", "gauss")):
            with self.subTest(treatment, points=points):
                self.assertAlmostEqual(self.settle(treatment, points).curve["sunk"].iloc[-1] / 0.02, 1, delta=1e-8)

    def test_stiff_bricks_and_half_a_metre(self):
        self.settle("consistent", "vertices", **{"materials.brick.young_modulus": 5e7})
        self.assertAlmostEqual(self.settle("consistent", **{"path.stop.gauges.sunk": 0.5}).curve["sunk"].iloc[-1] / 0.5, 1, delta=1e-8)


if __name__ == "__main__":
    unittest.main()
