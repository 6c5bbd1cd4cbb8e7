"""Laws in Python: the curve of the built-in law that they repeat, what they raise, how they are registered."""

import math
import unittest
from pathlib import Path

import numpy as np

import ddapath

ROOT = Path(__file__).resolve().parents[2]
FRICTIONAL = ROOT / "examples/plugin/deck.yaml"
PLAIN = ROOT / "tests/program/beam.yaml"
SHORT = {"path.stop.load_below": 0.7}
COMPARED = ("load_factor", "load", "dissipated_energy", "stored_energy", "external_work")


@ddapath.register_law("straight")
class Straight(ddapath.SofteningCurve):
    """Linear softening down to a stress-free crack, as a curve."""

    def value(self, omega):
        return max(1 - omega / 2, 0.0)

    def slope(self, omega):
        return -0.5 if omega < 2 else 0.0

    def steepest(self):
        return 0.5

    def end(self):
        return 2.0

    def spent(self, omega):
        if omega >= 2:
            return 1.0
        g = self.value(omega)
        return 0.5 * (1 + g) * omega - 0.5 * omega * g

    def at_trial_opening(self, opening, scale, kappa0):
        if opening >= scale * 2:
            return opening / scale
        return max((opening - kappa0) / (scale - kappa0 / 2), 0.0)

    def at_same_compliance(self, omega, ratio):
        if omega >= 2:
            return omega
        y = ratio * omega / self.value(omega)
        return y / (1 + y / 2)


class Bisected(Straight):
    """The same with the general solutions of the base class."""

    at_trial_opening = ddapath.SofteningCurve.at_trial_opening
    at_same_compliance = ddapath.SofteningCurve.at_same_compliance


@ddapath.register_law("whole")
class Whole(ddapath.InterfaceLaw):
    """Linear softening down to a stress-free crack, as a whole law: t_eq = ft (w_c − κ)/(w_c − κ0), w_c = 2 Gf/ft."""

    ft = ddapath.Number("stress", above=0, text="Strength.")
    energy = ddapath.Number("energy_per_area", above=0, text="Energy of a complete crack.")

    def strength(self):
        return self.ft

    def rupture_kappa(self, k):
        return 2 * self.energy / self.ft

    def steepest_slope(self):
        return 0.5 * self.ft**2 / self.energy

    def omega(self, kappa, k):
        scale, kappa0 = self.energy / self.ft, self.ft / k
        if kappa >= 2 * scale:
            return kappa / scale
        return max((kappa - kappa0) / (scale - kappa0 / 2), 0.0)

    def secant(self, kappa, k):
        return self.ft * max(1 - self.omega(kappa, k) / 2, 0.0) / kappa

    def secant_slope(self, kappa, k):
        omega = self.omega(kappa, k)
        slope = -0.5 if omega < 2 else 0.0
        rate = self.ft * slope / (self.energy / self.ft + self.ft / k * slope)
        return (rate - self.ft * max(1 - omega / 2, 0.0) / kappa) / kappa

    def spent(self, kappa, k):
        if kappa < self.ft / k:
            return 0.0, 0.0
        omega = self.omega(kappa, k)
        if omega >= 2:
            return self.energy, 0.0
        g = 1 - omega / 2
        value = self.energy * (0.5 * (1 + g) * omega - 0.5 * omega * g)
        return value, self.energy * 0.5 * (g + omega / 2) / (self.energy / self.ft - 0.5 * self.ft / k)


def followed(deck, law, settings):
    deck = ddapath.read_deck(deck)
    for interface in deck["interfaces"].values():
        interface["law"] = law(interface["law"])
    return list(ddapath.follow(deck, settings))


class Curves(unittest.TestCase):
    def assert_same(self, mine, theirs):
        self.assertEqual(len(mine), len(theirs))
        self.assertGreater(len(mine), 15)
        for name in COMPARED:
            largest = max(abs(getattr(point, name)) for point in theirs)
            for one, other in zip(mine, theirs):
                self.assertLessEqual(abs(getattr(one, name) - getattr(other, name)), 1e-12 * largest, (name, one.step))

    def test_a_curve_with_mixed_mode_and_friction(self):
        mine = followed(FRICTIONAL, lambda law: {**law, "type": "straight"}, SHORT)
        self.assert_same(mine, followed(FRICTIONAL, lambda law: {**law, "type": "linear_softening"}, SHORT))

    def test_a_whole_law(self):
        first = {"path.stop.after_steps": 26}  # sizes of later steps follow last digits
        mine = followed(PLAIN, lambda law: {"type": "whole", "ft": law["tensile_strength"], "energy": law["fracture_energy"]}, first)
        self.assert_same(mine, followed(PLAIN, lambda law: law, first))

    def test_general_solutions_of_the_base_class(self):
        exact, bisected = Straight(), Bisected()
        for opening in (0.0, 0.01, 0.02, 0.5, 1.0, 1.9, 2.5):
            self.assertAlmostEqual(bisected.at_trial_opening(opening, 1.0, 0.02), exact.at_trial_opening(opening, 1.0, 0.02), delta=1e-14)
        for omega in (0.0, 0.3, 1.0, 1.7, 2.0, 3.0):
            for ratio in (0.5, 1.0, 3.0):
                self.assertAlmostEqual(bisected.at_same_compliance(omega, ratio), exact.at_same_compliance(omega, ratio), delta=1e-13)


class Responding(unittest.TestCase):
    def test_a_sequence_of_openings(self):
        stiffness, widest = 1e5, 2 * 0.05 / 3
        opening = np.concatenate([np.linspace(0, 0.02, 50), np.linspace(0.02, 0, 5), np.linspace(0, 0.05, 60)])
        openings = np.column_stack([opening, 0 * opening])
        answers = [ddapath.respond(law, openings, stiffness)
                   for law in ({"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.05},
                               {"type": "straight", "tensile_strength": 3, "fracture_energy": 0.05},
                               {"type": "whole", "ft": 3, "energy": 0.05})]
        for answer in answers[1:]:
            for mine, theirs in zip(answer, answers[0]):
                np.testing.assert_allclose(mine, theirs, rtol=1e-12, atol=1e-15)
        tractions, damage, dissipated = answers[0]
        slope = 3 / widest
        on_curve = (opening > 3 / stiffness) & (np.arange(len(opening)) < 50)
        np.testing.assert_allclose(tractions[on_curve, 0], (3 - slope * opening[on_curve]) / (1 - slope / stiffness), rtol=1e-12)
        self.assertEqual(tractions[54, 0], 0)  # unloaded to the origin
        self.assertEqual(damage[-1], 1)
        self.assertAlmostEqual(dissipated[-1], 0.05, delta=1e-15)

    def test_what_cannot_be(self):
        with self.assertRaisesRegex(ddapath.InputError, "did you mean 'linear_softening'"):
            ddapath.respond({"type": "linear_softenin"}, np.zeros((1, 2)), 1.0)
        with self.assertRaisesRegex(ValueError, "n rows"):
            ddapath.respond("bonded", np.zeros(3), 1.0)
        with self.assertRaisesRegex(ValueError, "larger than 0"):
            ddapath.respond("bonded", np.zeros((1, 2)), 0.0)


class Failing(unittest.TestCase):
    def test_what_a_law_raises_comes_out_of_the_loop(self):
        @ddapath.register_law("raising")
        class Raising(Straight):
            """Fails beyond a little opening."""

            def value(self, omega):
                if omega > 0.2:
                    raise ArithmeticError("no curve here")
                return super().value(omega)

        path = ddapath.follow(PLAIN, {"interfaces.any.law.type": "raising"})
        points = []
        with self.assertRaisesRegex(ArithmeticError, "no curve here"):
            for point in path:
                points.append(point)
        self.assertGreater(len(points), 0)
        self.assertTrue(path.has_ended)
        self.assertGreater(points[-1].load, 0)
        fine = followed(PLAIN, lambda law: law, SHORT)
        self.assertEqual(points[0].load, fine[0].load)

    def test_a_value_of_a_wrong_type(self):
        @ddapath.register_law("wordy")
        class Wordy(Straight):
            """Gives words."""

            def steepest(self):
                return "steep"

        with self.assertRaisesRegex(TypeError, "Wordy.steepest gave 'steep'"):
            ddapath.follow(PLAIN, {"interfaces.any.law.type": "wordy"})

    def test_a_value_that_is_no_number(self):
        @ddapath.register_law("numberless")
        class Numberless(Straight):
            """Has a stress of nan."""

            def value(self, omega):
                return math.nan

        with self.assertRaisesRegex(TypeError, "Numberless.value gave nan"):
            list(ddapath.follow(PLAIN, {"interfaces.any.law.type": "numberless"}))

    def test_a_function_that_is_missing(self):
        @ddapath.register_law("half")
        class Half(ddapath.SofteningCurve):
            """Has no functions."""

        with self.assertRaisesRegex(NotImplementedError, "Half"):
            list(ddapath.follow(PLAIN, {"interfaces.any.law.type": "half"}))


class Registering(unittest.TestCase):
    def test_numbers_of_a_curve(self):
        given = []

        @ddapath.register_law("numbered")
        class Numbered(Straight):
            """Has a number of its own."""

            kink = ddapath.Number(fallback=0.3, at_most=1, text="Not used.")

            def __init__(self, **numbers):
                super().__init__(**numbers)
                given.append(self.kink)

        ddapath.follow(PLAIN, {"interfaces.any.law.type": "numbered"})
        ddapath.follow(PLAIN, {"interfaces.any.law.type": "numbered", "interfaces.any.law.kink": 0.5})
        self.assertEqual(sorted(set(given)), [0.3, 0.5])
        with self.assertRaisesRegex(ddapath.InputError, "kink.*at most 1"):
            ddapath.follow(PLAIN, {"interfaces.any.law.type": "numbered", "interfaces.any.law.kink": 2})

    def test_a_class_again(self):
        made = []
        for number in (1, 2):
            @ddapath.register_law("again")
            class Again(Straight):
                """Of a cell that is run again."""

                NUMBER = number

                def __init__(self, **numbers):
                    super().__init__(**numbers)
                    made.append(self.NUMBER)

            ddapath.follow(PLAIN, {"interfaces.any.law.type": "again"})
        self.assertEqual(sorted(set(made)), [1, 2])

    def test_what_may_not_be_registered(self):
        with self.assertRaisesRegex(ValueError, "one of the program's"):
            ddapath.register_law("linear_softening")(Straight)
        with self.assertRaisesRegex(ValueError, "with other parameters"):
            ddapath.register_law("whole")(Straight)
        with self.assertRaisesRegex(TypeError, "derive it from ddapath.SofteningCurve"):
            ddapath.register_law("none")(dict)
        with self.assertRaisesRegex(ValueError, "there is no dimension 'strain'"):
            ddapath.Number("strain")


if __name__ == "__main__":
    unittest.main()
