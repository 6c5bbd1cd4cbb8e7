"""Walls of bricks whose joints lose their strength at once, each of which starts another: where contacts change while one is
lost, the way is not straight, and the load at which the next one follows has to be bracketed.

    test_brittle_walls.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
import unittest

from program_case import ProgramCase

LENGTH, HEIGHT, CAP, THICKNESS, PRESSURE, FRICTION = 1000, 750, 100, 200, 1, 25  # mm, N/mm², degrees
BORNE = PRESSURE * LENGTH * THICKNESS * math.tan(math.radians(FRICTION))         # by friction, when it slides [N]


def rectangle(left, bottom, right, top):
    return [[left, bottom], [right, bottom], [right, top], [left, top]]


def brittle_wall(course, treatment="penalty", points="gauss", length=LENGTH, height=HEIGHT, strength=0.1):
    """Bricks as long as half the wall in running bond under a cap that is pressed, and pushed by its corner."""
    top = height + CAP
    mortar = {"type": "mohr_coulomb", "tensile_strength": strength, "cohesion": 1.5 * strength, "friction_angle": FRICTION}
    return {
        "units": {"length": "mm", "force": "N"},
        "scene": {"regions": [{"name": "wall", "material": "brick", "vertices": rectangle(0, 0, length, height)},
                              {"name": "cap", "material": "concrete", "vertices": rectangle(0, height, length, top)}],
                  "boundaries": {"bottom": [[0, 0], [length, 0]], "top": [[0, top], [length, top]]},
                  "subdivision": {"type": "bricks", "length": length / 2, "height": course}},
        "thickness": THICKNESS, "plane": "stress",
        "materials": {"brick": {"type": "linear_elastic", "young_modulus": 5000, "poisson_ratio": 0.15},
                      "concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {name: {"between": ["brick", other], "treatment": treatment, "points": points, "law": mortar}
                       for name, other in (("joints", "brick"), ("bed", "concrete"))},
        "supports": {"bottom": {"boundary": "bottom", "fix": "xy"}},
        "stages": [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "top", "pressure": PRESSURE}]},
                   {"name": "pushed", "loads": [{"type": "prescribed_displacement", "name": "push", "at": [0, top],
                                                 "direction": [1, 0], "displacement": 3.75}]}],
        "gauges": {"drift": {"type": "displacement", "at": [length, top], "direction": [1, 0]}},
        "path": {"stop": {"gauges": {"drift": 11.25}}},
    }


def with_window(deck, window, friction):
    deck["scene"]["holes"] = {"window": window}
    for interface in deck["interfaces"].values():
        interface["law"] = interface["law"] | {"friction_angle": friction}
    return deck


class BrittleWall(ProgramCase):
    def test_slides_under_what_friction_bears_of_its_pressure(self):
        run = self.run_verified(brittle_wall(150, "consistent", "vertices"))
        self.assertAlmostEqual(run.curve["load"].iloc[-1] / BORNE, 1, delta=1e-6)

    def test_goes_on_where_a_release_turns_contacts(self):
        run = self.run_verified(brittle_wall(375))
        self.assertLess(run.curve["load"].iloc[-1], BORNE)

    def pressed(self, deck, pressure, length):
        """The wall one step after it has been pressed: under the whole pressure, with joints that have lost their strength."""
        deck["path"] = {"stop": {"after_steps": 1}}
        run = self.run_verified(deck)
        self.assertGreater(run.curve["dissipated_energy"].iloc[0], 0)
        self.assertAlmostEqual(run.curve["bottom.y"].iloc[0] / (pressure * length * THICKNESS), 1, delta=1e-9)

    def test_is_pressed_though_some_strength_is_lost_meanwhile(self):
        """The first strength on the way to the whole pressure was looked for beyond none of it, under a pull."""
        deck = with_window(brittle_wall(125, length=1500, height=1500, strength=0.25), rectangle(600, 250, 975, 900), friction=35)
        deck["scene"]["subdivision"] |= {"length": 500, "bond": "english"}
        deck["stages"][1]["loads"] = [{"type": "point_load", "at": [0, 1500 + CAP], "force": [1, 0]}]  # held by nothing before
        self.pressed(deck, PRESSURE, 1500)

    def test_is_pressed_though_a_strength_was_passed_by_next_to_nothing(self):
        """Within what is borne beyond a strength the next one lies behind, and was not found on the way."""
        deck = with_window(brittle_wall(60, length=800, height=480, strength=0.05), rectangle(400, 120, 600, 360), friction=20)
        deck["scene"]["subdivision"]["length"] = 200
        deck["stages"][0]["loads"][0]["pressure"] = 2
        self.pressed(deck, 2, 800)

    def test_goes_on_from_a_load_far_below_its_peak(self):
        """Between one loss of strength and the next the load goes up and down; it was said to have turned round."""
        deck = with_window(brittle_wall(60, length=750, height=480, strength=0.25), rectangle(250, 120, 500, 360), friction=35)
        deck["scene"]["subdivision"]["length"] = 250
        deck["stages"][0]["loads"][0]["pressure"] = 0.5
        deck["path"] = {"stop": {"gauges": {"drift": 0.08}}}
        run = self.run_verified(deck)
        self.assertLess(run.curve["load"].iloc[1:].min(), 0.1 * run.curve["load"].max())


if __name__ == "__main__":
    unittest.main()
