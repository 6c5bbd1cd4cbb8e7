"""Walls of bricks whose joints lose their strength at once, each of which starts another: where contacts change while one is
lost, the way is not straight, and the load at which the next one follows has to be bracketed.

    test_brittle_walls.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import math
import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify

LENGTH, HEIGHT, CAP, THICKNESS, PRESSURE, FRICTION = 1000, 750, 100, 200, 1, 25  # mm, N/mm², degrees
TOP = HEIGHT + CAP


def brittle_wall(course, treatment="penalty", points="gauss"):
    """Bricks as long as half the wall in running bond under a cap that is pushed by its corner."""
    mortar = {"type": "mohr_coulomb", "tensile_strength": 0.1, "cohesion": 0.15, "friction_angle": FRICTION}
    return {
        "units": {"length": "mm", "force": "N"},
        "scene": {"regions": [
            {"name": "wall", "material": "brick", "vertices": [[0, 0], [LENGTH, 0], [LENGTH, HEIGHT], [0, HEIGHT]]},
            {"name": "cap", "material": "concrete", "vertices": [[0, HEIGHT], [LENGTH, HEIGHT], [LENGTH, TOP], [0, TOP]]}],
            "boundaries": {"bottom": [[0, 0], [LENGTH, 0]], "top": [[0, TOP], [LENGTH, TOP]]},
            "subdivision": {"type": "bricks", "length": LENGTH / 2, "height": course}},
        "thickness": THICKNESS, "plane": "stress",
        "materials": {"brick": {"type": "linear_elastic", "young_modulus": 5000, "poisson_ratio": 0.15},
                      "concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {name: {"between": ["brick", other], "treatment": treatment, "points": points, "law": mortar}
                       for name, other in (("joints", "brick"), ("bed", "concrete"))},
        "supports": {"bottom": {"boundary": "bottom", "fix": "xy"}},
        "stages": [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "top", "pressure": PRESSURE}]},
                   {"name": "pushed", "loads": [{"type": "prescribed_displacement", "name": "push", "at": [0, TOP],
                                                 "direction": [1, 0], "displacement": 3.75}]}],
        "gauges": {"drift": {"type": "displacement", "at": [LENGTH, TOP], "direction": [1, 0]}},
        "path": {"stop": {"gauges": {"drift": 11.25}}},
    }


class BrittleWall(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def follow(self, deck):
        run = ddapath.run(deck, folder=self.folder / "run", check=False)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertEqual([finding for finding in verify(run.folder) if not finding.holds], [])
        return run

    def test_slides_under_what_friction_bears_of_its_pressure(self):
        run = self.follow(brittle_wall(150, "consistent", "vertices"))
        borne = PRESSURE * LENGTH * THICKNESS * math.tan(math.radians(FRICTION))
        self.assertAlmostEqual(run.curve["load"].iloc[-1] / borne, 1, delta=1e-6)

    def test_goes_on_where_a_release_turns_contacts(self):
        run = self.follow(brittle_wall(375))
        self.assertLess(run.curve["load"].iloc[-1], PRESSURE * LENGTH * THICKNESS * math.tan(math.radians(FRICTION)))

    def test_is_pressed_though_some_strength_is_lost_meanwhile(self):
        """The first strength on the way to the whole pressure was looked for beyond none of it, under a pull."""
        deck = copy.deepcopy(brittle_wall(125))
        wall, cap = deck["scene"]["regions"]
        deck["units"] = {"length": "m", "force": "N"}
        wall["vertices"] = [[0, 0], [1.5, 0], [1.5, 1.5], [0, 1.5]]
        cap["vertices"] = [[0, 1.5], [1.5, 1.5], [1.5, 1.6], [0, 1.6]]
        deck["scene"]["boundaries"] = {"bottom": [[0, 0], [1.5, 0]], "top": [[0, 1.6], [1.5, 1.6]]}
        deck["scene"]["holes"] = {"window": [[.6, .25], [.975, .25], [.975, .9], [.6, .9]]}
        deck["scene"]["subdivision"] = {"type": "bricks", "length": .5, "height": .125, "bond": "english"}
        deck["thickness"] = .2
        for material, modulus in (("brick", 5e9), ("concrete", 30e9)):
            deck["materials"][material]["young_modulus"] = modulus
        for interface in deck["interfaces"].values():
            interface["law"] = {"type": "mohr_coulomb", "tensile_strength": 250e3, "cohesion": 375e3, "friction_angle": 35}
        deck["stages"] = [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "top", "pressure": 1e6}]},
                          {"name": "pushed", "loads": [{"type": "point_load", "at": [0, 1.6], "force": [1, 0]}]}]
        deck["gauges"] = {"drift": {"type": "displacement", "at": [1.5, 1.6], "direction": [1, 0]}}
        deck["path"] = {"stop": {"after_steps": 1}}
        run = self.follow(deck)
        self.assertGreater(run.curve["dissipated_energy"][0], 0)
        self.assertAlmostEqual(run.curve["bottom.y"][0], 1e6 * 1.5 * .2, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
