"""What a release has unloaded and friction bears anew is no load that has fallen.

    test_reloading.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
import unittest

import ddapath

from program_case import ProgramCase

NORMAL, RESIDUAL = 2500.0, 25.0  # N, degrees


def shear_box():
    """Two halves pressed on each other, the joint between them released at once where it reaches its strength."""
    return {
        "units": {"length": "mm", "force": "N"},
        "scene": {"regions": [{"name": "low", "material": "s", "vertices": [[0, 0], [100, 0], [100, 30], [0, 30]]},
                              {"name": "up", "material": "s", "vertices": [[0, 30], [100, 30], [100, 60], [0, 60]]}],
                  "curves": {"j": [[0, 30], [100, 30]]}, "boundaries": {"floor": [[0, 0], [100, 0]], "top": [[0, 60], [100, 60]]},
                  "subdivision": {"type": "grid", "columns": 6, "rows": 2}},
        "thickness": 50, "plane": "stress",
        "materials": {"s": {"type": "linear_elastic", "young_modulus": 10000, "poisson_ratio": 0.2}},
        "interfaces": {"j": {"law": {"type": "mohr_coulomb", "tensile_strength": 0.3, "cohesion": 0.4, "friction_angle": 35,
                                     "residual_friction_angle": RESIDUAL}}},
        "supports": {"f": {"boundary": "floor", "fix": "xy"}},
        "stages": [{"name": "press", "loads": [{"type": "edge_traction", "boundary": "top", "pressure": 0.5}]},
                   {"name": "shear", "loads": [{"type": "point_load", "over": [[0, 30], [0, 60]], "force": [1, 0]}]}],
        "gauges": {"u": {"type": "displacement", "over": [[0, 30], [0, 60]], "direction": [1, 0]}},
        "path": {"stop": {"gauges": {"u": 1.0}}},
    }


class Reloading(ProgramCase):
    def test_a_shear_box_ends_at_its_residual_friction(self):
        for control in ("staged", "displacement"):
            run = ddapath.run(shear_box(), {"path.control": control}, folder=self.folder / control)
            self.assertEqual(run.summary["reason"], "u reached 1", control)
            residual = NORMAL * math.tan(math.radians(RESIDUAL))
            self.assertAlmostEqual(run.curve.load.iloc[-1], residual, delta=1e-5 * residual)


if __name__ == "__main__":
    unittest.main()
