"""What tears in motion takes its energy from what it held, and joints that lose their strength at once lose it there, too.

    test_tearing.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
import unittest

from program_case import ProgramCase

GRAVITY, DENSITY, SIDE = 9.81, 2400, 0.1  # m/s², kg/m³, m
STRENGTH, TOUGHNESS = 3e6, 100            # N/m², N/m


def square(name, left, bottom, width, height):
    right, top = left + width, bottom + height
    return {"name": name, "material": "stone", "vertices": [[left, bottom], [right, bottom], [right, top], [left, top]]}


def scene(regions, law, motion):
    return {
        "units": {"length": "m", "force": "N"},
        "scene": {"regions": regions}, "thickness": 1,
        "materials": {"stone": {"type": "linear_elastic", "young_modulus": 3e10, "poisson_ratio": 0.2, "density": DENSITY}},
        "interfaces": {"joint": {"between": ["stone", "stone"], "law": law}},
        "motion": {"contact": {"friction": 0.5}, **motion},
    }


def thrown_apart(law, speed=1.0, **motion):
    return scene([square("left", -SIDE, 0, SIDE, SIDE), square("right", 0, 0, SIDE, SIDE)], law,
                 {"velocities": [{"regions": ["left"], "velocity": [-speed, 0]}, {"regions": ["right"], "velocity": [speed, 0]}],
                  "time": 0.05, **motion})


def hanging(law, height, **motion):
    """A block below another one that is held; its weight pulls, or shears, the joint."""
    return scene([square("top", 0, 0, 1, 1), square("block", 0, -height, 1, height)], law,
                 {"gravity": [0, -GRAVITY], "held": ["top"], "time": 0.5, **motion})


class Tearing(ProgramCase):
    def last(self, deck):
        return self.run_verified(deck).motion.curve.iloc[-1]

    def test_takes_its_fracture_energy_from_the_motion(self):
        """Bodies as fast as to open the joint whole within a step of the usual size."""
        spent, kinetic = TOUGHNESS * SIDE, DENSITY * SIDE * SIDE  # of both
        for kind, speed, integrator in (("linear_softening", 1.0, "free_flight"), ("linear_softening", 1.0, "implicit_euler"),
                                        ("linear_softening", 1.0, "trapezoidal"), ("exponential_softening", 2.0, "free_flight")):
            with self.subTest(kind=kind, speed=speed, integrator=integrator):
                law = {"type": kind, "tensile_strength": STRENGTH, "fracture_energy": TOUGHNESS}
                end = self.last(thrown_apart(law, speed, integrator=integrator))
                self.assertAlmostEqual(end["fracture"] / spent, 1, delta=1e-2)
                self.assertAlmostEqual(end["kinetic_energy"] / (kinetic * speed**2 - spent), 1, delta=0.06)

    def test_brittle_joints_let_go_at_their_strength(self):
        height = 3
        stress = DENSITY * GRAVITY * height  # at rest; at once it is up to twice that
        for share, falls in ((0.4, True), (0.9, True), (2.2, False)):
            with self.subTest(share=share):
                law = {"type": "mohr_coulomb", "tensile_strength": share * stress, "cohesion": 2 * stress, "friction_angle": 30}
                end = self.last(hanging(law, height, stop_at_rest=False))
                fallen = end["external_work"] / (stress * 1)
                self.assertAlmostEqual(fallen, GRAVITY * 0.5**2 / 2 if falls else 0, delta=0.02)

    def test_brittle_joints_break_in_a_collision(self):
        law = {"type": "mohr_coulomb", "tensile_strength": 1e5, "cohesion": 1e6, "friction_angle": 30}
        end = self.last(thrown_apart(law))
        self.assertGreater(end["fracture"], 0)
        self.assertAlmostEqual(end["kinetic_energy"] / (DENSITY * SIDE * SIDE), 1, delta=0.02)
        self.assertEqual(end["live_joints"], 0)

    def test_a_pendulum_without_damping_gives_nothing_back(self):
        """It takes and gives a little in every swing, which adds up to nothing."""
        turn = math.radians(10)
        corners = [[x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)]
                   for x, y in ((-.1, -1), (.1, -1), (.1, 0), (0, 0), (-.1, 0))]
        deck = scene([{"name": "bob", "material": "stone", "vertices": corners}], {"type": "bonded"},
                     {"gravity": [0, -GRAVITY], "time": 5, "integrator": "trapezoidal", "stop_at_rest": False})
        del deck["interfaces"]
        deck["supports"] = {"pin": {"at": [0, 0], "fix": "xy"}}
        self.run_verified(deck)


if __name__ == "__main__":
    unittest.main()
