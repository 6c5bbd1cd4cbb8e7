"""Motions that stiffness damps: whatever the step, also the short one that is left at the end.

    test_damped_motion.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase


def cantilever(damping, step, time):
    """A beam of 10 × 1 m that lets go under its weight; 0.0155 s are 5 % of critical damping of its first mode."""
    return {
        "units": {"length": "m", "force": "N"}, "thickness": 1,
        "scene": {"regions": [{"name": "beam", "material": "steel", "vertices": [[0, 0], [10, 0], [10, 1], [0, 1]]}],
                  "boundaries": {"wall": [[0, 0], [0, 1]]}, "subdivision": {"type": "grid", "columns": 10, "rows": 2}},
        "materials": {"steel": {"type": "linear_elastic", "young_modulus": 1e9, "poisson_ratio": 0, "density": 2500}},
        "supports": {"wall": {"boundary": "wall", "fix": "xy"}},
        "gauges": {"tip": {"type": "displacement", "at": [10, 0], "direction": [0, 1]}},
        "motion": {"gravity": [0, -9.81], "time": time, "stop_at_rest": False, "step": step, "damping": {"stiffness": damping}, "contact": {"friction": 0.5}},
    }


class DampedMotion(ProgramCase):
    def end_of(self, damping, step, time):
        run = ddapath.run(cantilever(damping, step, time), folder=self.folder / "run", overwrite=True)
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        self.assertEqual(run.summary["reason"], f"motion: the time {time:g} is reached")
        return run.motion.curve

    def test_goes_on_with_short_steps(self):
        """What rounding leaves of the dampers' forces grows as damping over step."""
        tips = [self.end_of(0.0155, step, 0.03).tip.iloc[-1] for step in (1e-2, 1e-3, 1e-4)]
        self.assertAlmostEqual(tips[1] / tips[2], 1, delta=0.02)

    def test_takes_the_short_step_at_the_end(self):
        step = self.end_of(0.0155, 1e-2, 0.05).time_step.iloc[-2]
        for remainder in (0.1, 1e-3, 1e-5):
            with self.subTest(remainder):
                self.assertLess(self.end_of(0.0155, 1e-2, round((20 + remainder) * step, 12)).time_step.iloc[-1], step)


if __name__ == "__main__":
    unittest.main()
