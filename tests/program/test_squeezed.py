"""Joints that carry by friction alone, pressed together by strain that is there before the load: a flat arch without weight.

    test_squeezed.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify

ANGLE = 20


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def flat_arch(voussoirs, treatment):
    """Voussoirs of 2 m in all between abutments, which a strain presses on these; the load is on the middle one."""
    width = 2 / voussoirs
    stones = [{"name": f"v{i}", "material": ("even", "odd")[i % 2], "vertices": box(-1 + i * width, 0, -1 + (i + 1) * width, 0.5)}
              for i in range(voussoirs)]
    abutments = [{"name": "left", "material": "abutment", "vertices": box(-1.5, -0.5, -1, 0.5)},
                 {"name": "right", "material": "abutment", "vertices": box(1, -0.5, 1.5, 0.5)}]
    joint = {"law": {"type": "friction", "friction_angle": ANGLE}, "points": "vertices", "treatment": treatment}
    return {"units": {"length": "m", "force": "N"}, "thickness": 1, "plane": "stress",
            "scene": {"regions": abutments + stones, "boundaries": {"l": [[-1.5, -0.5], [-1.5, 0.5]], "r": [[1.5, -0.5], [1.5, 0.5]]},
                      "subdivision": {"type": "given"}},
            "materials": {name: {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2, "density": 2500}
                          for name in ("abutment", "odd", "even")},
            "interfaces": {"between": joint | {"between": ["odd", "even"]}, "ends": joint | {"between": ["even", "abutment"]}},
            "supports": {"l": {"boundary": "l", "fix": "xy"}, "r": {"boundary": "r", "fix": "xy"}},
            "stages": [{"name": "squeezed", "loads": [{"type": "initial_strain", "xx": 1e-5, "materials": ["odd", "even"]}]},
                       {"name": "load", "loads": [{"type": "point_load", "at": [0, 0.5], "force": [0, -1000]}]}],
            "gauges": {"d": {"type": "displacement", "at": [0, 0.5], "direction": [0, -1]}}}


class FlatArch(unittest.TestCase):
    def test_slides_at_twice_what_friction_bears_of_its_thrust(self):
        """All joints reach their limit at once, so that which of them slide is open; the load is not: 2 N tan φ."""
        for voussoirs, treatment in ((3, "consistent"), (3, "penalty"), (3, "lagrange"), (3, "augmented_lagrangian"), (5, "consistent")):
            with self.subTest(voussoirs=voussoirs, treatment=treatment), tempfile.TemporaryDirectory() as scratch:
                run = ddapath.run(flat_arch(voussoirs, treatment), folder=Path(scratch) / "run", check=False)
                self.assertRegex(run.summary["reason"], "slides as a mechanism")
                end = run.curve.iloc[-1]
                self.assertAlmostEqual(end.load / (2 * math.tan(math.radians(ANGLE)) * end["l.x"]), 1, delta=1e-8)
                self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])


if __name__ == "__main__":
    unittest.main()
