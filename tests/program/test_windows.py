"""Dry walls of bricks around a window: what controls tell of the load that brings them down.

    test_windows.py        with PYTHONPATH=python, and DDA naming the program
"""

import sys
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify

from program_case import ProgramCase

sys.path.append(str(Path(__file__).resolve().parents[1] / "robustness"))

from contact_scenes import rectangle, region  # noqa: E402
from dry_masonry import Opening, running_bond  # noqa: E402

LENGTH, HEIGHT, WEIGHT = 0.3, 0.1, 20.0


def wall(columns, rows, opening, degrees, modulus, points, treatment):
    """Pushed to the right by a multiple of its weight; the gauge is at its upper left corner."""
    width = columns * LENGTH
    bricks = running_bond(columns, rows, Opening(*opening), LENGTH, HEIGHT)
    regions = [region("ground", "foot", rectangle(-0.5, -0.3, width + 0.5, 0))]
    regions += [region(f"b{i}", "stone", brick) for i, brick in enumerate(bricks)]
    joint = {"law": {"type": "friction", "friction_angle": degrees}, "points": points, "treatment": treatment}
    elastic = {"type": "linear_elastic", "young_modulus": modulus, "poisson_ratio": 0.2}
    pull = lambda x, y: [{"type": "body_force", "force": [x, y], "materials": ["stone"]}]
    return {
        "units": {"length": "m", "force": "kN"}, "thickness": 0.12,
        "scene": {"regions": regions, "boundaries": {"base": [[-0.5, -0.3], [width + 0.5, -0.3]]}, "subdivision": {"type": "given"}},
        "materials": {"stone": elastic, "foot": elastic},
        "interfaces": {"joint": {"between": ["stone", "stone"], **joint}, "bed": {"between": ["stone", "foot"], **joint}},
        "supports": {"base": {"boundary": "base", "fix": "xy"}},
        "stages": [{"name": "weight", "loads": pull(0, -WEIGHT)}, {"name": "push", "loads": pull(WEIGHT, 0)}],
        "gauges": {"drift": {"type": "displacement", "at": [0, rows * HEIGHT], "direction": [1, 0]}},
    }


class Windows(ProgramCase):
    def followed(self, deck, control):
        run = ddapath.run(deck, {"path.control": control}, folder=self.folder / control, overwrite=True, check=False)
        self.assertEqual([found.check for found in verify(run.folder) if not found.holds], [])
        return run

    def test_what_moves_on_in_small_steps_is_a_mechanism(self):
        """Bricks that begin to hang on each other keep the steps below a tenth of the way. Either control, one load."""
        loads = []
        for control in ("staged", "arc_length"):
            run = self.followed(wall(6, 9, (3, 4, 3, 7), 40, 1.6e6, "gauss", "lagrange"), control)
            self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
            self.assertRegex(run.summary["reason"], "^turns as a mechanism")
            loads.append(run.curve["load"].iloc[-1])
        self.assertAlmostEqual(loads[0] / loads[1], 1, delta=1e-6)

    def test_controls_find_the_same_peak(self):
        """Where hinges open and slip one after another the load has a peak between the ends of a step."""
        for case in ((7, 8, (4, 6, 4, 6), 35, 6.6e5, "gauss", "penalty"), (7, 8, (4, 6, 3, 6), 30, 1.26e6, "gauss", "penalty")):
            peaks = [self.followed(wall(*case), control).summary["peak"]["load"] for control in ("staged", "arc_length")]
            self.assertAlmostEqual(peaks[0] / peaks[1], 1, delta=1e-4)

    def test_displacement_control_tells_that_its_gauge_turns(self):
        run = self.followed(wall(7, 10, (3, 6, 7, 8), 35, 2e6, "vertices", "consistent"), "displacement")
        self.assertEqual(run.summary["status"], "stopped_early")
        self.assertIn("'drift' snaps back here", run.summary["reason"])


if __name__ == "__main__":
    unittest.main()
