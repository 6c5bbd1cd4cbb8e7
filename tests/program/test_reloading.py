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


def notched_beam():
    return {
        "units": {"length": "mm", "force": "N"}, "thickness": 100, "plane": "stress",
        "scene": {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [400, 0], [400, 100], [0, 100]]}],
                  "slits": {"notch": [[200, 0], [200, 30]]}, "curves": {"ligament": [[200, 30], [200, 100]]},
                  "subdivision": {"type": "triangles", "size": 25}},
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"ligament": {"law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.1}}},
        "supports": {"left": {"at": [20, 0], "fix": "xy"}, "right": {"at": [380, 0], "fix": "y"}},
        "stages": [{"name": "bend", "loads": [{"type": "point_load", "over": [[190, 100], [210, 100]], "force": [0, -1]}],
                    "until": {"deflection": 0.05}},
                   {"name": "back", "unload": True, "until": {"load": 500}}, {"name": "again"}],
        "gauges": {"deflection": {"type": "displacement", "over": [[190, 100], [210, 100]], "direction": [0, -1]}},
        "path": {"stop": {"load_below": 0.5}}}


def two_blocks():
    """Joined by what softens, one of them driven off at 45 degrees."""
    drive = {"type": "prescribed_displacement", "boundary": "right", "displacement": math.sqrt(0.5)}
    return {
        "units": {"length": "mm", "force": "N"}, "thickness": 5, "plane": "stress", "kinematics": {"type": "second_order"},
        "scene": {"regions": [{"name": "a", "material": "m", "vertices": [[0, 0], [10, 0], [10, 20], [0, 20]]},
                              {"name": "b", "material": "m", "vertices": [[10, 0], [20, 0], [20, 20], [10, 20]]}],
                  "curves": {"j": [[10, 0], [10, 20]]}, "boundaries": {"left": [[0, 0], [0, 20]], "right": [[20, 0], [20, 20]]},
                  "subdivision": {"type": "given"}},
        "materials": {"m": {"type": "linear_elastic", "young_modulus": 1e6, "poisson_ratio": 0.2}},
        "interfaces": {"j": {"law": {"type": "bilinear_softening", "tensile_strength": 3, "fracture_energy": 0.1, "cohesion": 2,
                                     "shear_fracture_energy": 0.4, "mixed_mode_exponent": 2}}},
        "supports": {"p": {"boundary": "left", "fix": "xy"}},
        "stages": [{"name": "s", "loads": [drive | {"direction": [1, 0]}, drive | {"direction": [0, 1]}]}],
        "gauges": {"ux": {"type": "displacement", "over": [[20, 0], [20, 20]], "direction": [1, 0]}},
        "path": {"stop": {"load_below": 0}}}


class Reloading(ProgramCase):
    def test_a_shear_box_ends_at_its_residual_friction(self):
        for control in ("staged", "displacement"):
            run = ddapath.run(shear_box(), {"path.control": control}, folder=self.folder / control)
            self.assertEqual(run.summary["reason"], "u reached 1", control)
            residual = NORMAL * math.tan(math.radians(RESIDUAL))
            self.assertAlmostEqual(run.curve.load.iloc[-1], residual, delta=1e-5 * residual)

    def test_what_is_stable_under_dead_load_is_so_under_any_control(self):
        for control in ("staged", "displacement", "arc_length"):
            with self.subTest(control=control):
                curve = ddapath.run(notched_beam(), {"path.control": control}, folder=self.folder / control).curve
                stable = curve[curve["negative_eigenvalues"] == 0]
                self.assertTrue(stable["control"].str.contains("unload").any())
                self.assertEqual(stable["negative_under_control"].max(), 0)

    def test_a_joint_at_its_strength_is_no_mechanism(self):
        """The load stands while the joint of stiff blocks begins to soften: its work is spent."""
        spent = {}
        for modulus in (3e5, 1e6):
            run = ddapath.run(two_blocks(), {"materials.m.young_modulus": modulus}, folder=self.folder / str(modulus))
            self.assertEqual(run.summary["reason"], "complete rupture")
            spent[modulus] = run.curve["dissipated_energy"].iloc[-1]
        self.assertLess(abs(spent[1e6] / spent[3e5] - 1), 1e-2)


if __name__ == "__main__":
    unittest.main()
