"""A notice of slits whose faces pass through each other: nothing is joined there, and nothing is kept apart.

    test_closed_slits.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import ddapath
from program_case import ProgramCase


def plate(pull, line="slits"):
    """A square of 100 mm with a level slit of 40 mm, pulled or pressed from above; it cracks from the slit's tip."""
    deck = {
        "units": {"length": "mm", "force": "N"}, "thickness": 10,
        "scene": {"regions": [{"name": "plate", "material": "stone", "vertices": [[0, 0], [100, 0], [100, 100], [0, 100]]}],
                  "boundaries": {"foot": [[0, 0], [100, 0]], "head": [[0, 100], [100, 100]]}, line: {"flaw": [[0, 50], [40, 50]]},
                  "curves": {"ahead": [[40, 50], [100, 50]]}, "subdivision": {"type": "quads", "size": 10}},
        "materials": {"stone": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"ahead": {"law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.1}}},
        "supports": {"foot": {"boundary": "foot", "fix": "xy"}},
        "stages": [{"loads": [{"type": "edge_traction", "boundary": "head", "traction": [0, pull]}]}],
        "path": {"stop": {"load_factor_above": 1}},
    }
    if line == "curves":
        deck["scene"]["curves"] = {"ahead": [[40, 50], [100, 50]], "flaw": [[0, 50], [40, 50]]}
        deck["interfaces"]["flaw"] = {"law": {"type": "friction", "friction_angle": 35}}
    return deck


class ClosedSlits(ProgramCase):
    def notices(self, *asked):
        run = ddapath.run(plate(*asked), folder=self.folder / "run", overwrite=True)
        return "\n".join(run.summary["notices"])

    def test_faces_that_pass_through_each_other_are_told(self):
        told = self.notices(-1)
        self.assertIn("faces of a slit pass through each other by", told)
        self.assertIn("at (5, 50)", told)  # the middle of the piece that closes most, at the mouth
        self.assertIn("`friction`", told)

    def test_faces_that_part_are_not(self):
        self.assertNotIn("faces of a slit", self.notices(0.5))

    def test_the_line_that_the_notice_proposes_bears_them(self):
        self.assertNotIn("faces of a slit", self.notices(-1, "curves"))


if __name__ == "__main__":
    unittest.main()
