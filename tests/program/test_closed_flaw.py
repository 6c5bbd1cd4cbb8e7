"""A plate of Voronoi cells with a closed flaw under compression: of the branches that leave its equilibria one unloads, cracks closing and
sliding back, and its peak lies beyond the first of them.

    test_closed_flaw.py   with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

ROCK = {"type": "linear_elastic", "young_modulus": 20000, "poisson_ratio": 0.2}
BREAKS = {"type": "linear_softening", "tensile_strength": 4, "cohesion": 12, "friction_angle": 35, "fracture_energy": 0.05,
          "shear_fracture_energy": 0.5}
SQUEEZED = {
    "units": {"length": "mm", "force": "N"}, "thickness": 50, "materials": {"rock": ROCK},
    "scene": {"regions": [{"name": "plate", "material": "rock", "vertices": [[0, 0], [60, 0], [60, 120], [0, 120]]}],
              "boundaries": {"foot": [[0, 0], [60, 0]], "head": [[60, 120], [0, 120]]},
              "slits": {"flaw": [[23, 53], [37, 67]]}, "subdivision": {"type": "voronoi", "size": 6}},
    "interfaces": {"any": {"between": ["rock", "rock"], "law": BREAKS}},
    "supports": {"foot": {"boundary": "foot", "fix": "y"}, "pin": {"at": [30, 0], "fix": "x"}},
    "stages": [{"loads": [{"type": "prescribed_displacement", "boundary": "head", "direction": [0, -1], "displacement": 1}]}],
    "path": {"stop": {"load_factor_above": 0.5, "load_below": 0.4}},
}


class ClosedFlaw(ProgramCase):
    def test_is_loaded_again_where_its_path_unloads(self):
        run = ddapath.run(SQUEEZED, folder=self.folder / "run", check=False)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        curve = run.curve
        self.assertAlmostEqual(curve["load_factor"].iloc[-1], 0.5, places=9)
        self.assertIn("jump", set(curve["control"]))
        self.assertGreater(curve["load"].iloc[-1], 0.95 * curve["load"].max())
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])


if __name__ == "__main__":
    unittest.main()
