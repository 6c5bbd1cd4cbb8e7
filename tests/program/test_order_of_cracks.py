"""Cracks that compete begin in the order in which the load reaches their strengths, however long the steps are.

    test_order_of_cracks.py        with PYTHONPATH=python, and DDA naming the program
"""

import tempfile
import unittest
from pathlib import Path

import ddapath


def notched_beam(mesh, size, fracture_energy, notch):
    """Of blocks so large that a crack beside another one is as good as that, every interface able to crack."""
    loaded = [[190, 100], [210, 100]]
    return {
        "units": {"length": "mm", "force": "N"},
        "scene": {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [400, 0], [400, 100], [0, 100]]}],
                  "subdivision": {"type": mesh, "size": size}, "slits": {"notch": [[200, 0], [200, notch]]}},
        "thickness": 100, "plane": "stress",
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"joints": {"between": ["concrete", "concrete"],
                                  "law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": fracture_energy}}},
        "supports": {"left": {"over": [[0, 0], [20, 0]], "fix": "xy"}, "right": {"over": [[380, 0], [400, 0]], "fix": "y"}},
        "stages": [{"name": "bent", "loads": [{"type": "point_load", "over": loaded, "force": [0, -1]}]}],
        "gauges": {"deflection": {"type": "displacement", "over": loaded, "direction": [0, -1]}},
        "path": {"stop": {"load_below": 0.9}},
    }


class Order(unittest.TestCase):
    def peak(self, deck, settings):
        with tempfile.TemporaryDirectory() as folder:
            return ddapath.run(deck, folder=Path(folder) / "run", settings=settings, check=False).curve["load"].max()

    def peaks_agree(self, deck):
        fine = self.peak(deck, {"path.step.largest": 0.005, "path.stop.steps": 3000})
        for control in "staged", "displacement", "arc_length", "load":
            with self.subTest(control=control):
                self.assertAlmostEqual(self.peak(deck, {"path.control": control}) / fine, 1, delta=3e-3)

    def test_triangles(self):
        self.peaks_agree(notched_beam("triangles", 22, 0.05, 40))

    def test_quads(self):
        self.peaks_agree(notched_beam("quads", 23.3, 0.1, 20))


if __name__ == "__main__":
    unittest.main()
