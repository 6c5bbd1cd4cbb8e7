"""Paths on which friction is at its limit: where a load goes on to rise while what it works on goes back, where a stage begins, and
where loads turn round beyond what they were.

    test_friction_limits.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
import unittest

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

LENGTH, HEIGHT, WEIGHT = 1.0, 0.5, 10e3  # of a block on an incline: m, m, N
STEEL = {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2}
UNITS = {"N/m": (1, 1), "MN/m": (1, 1e6), "N/mm": (1e3, 1)}  # lengths in a metre, newtons in a force


def corners(angle):
    """Of the block and of the plane it lies on, and directions along and across that."""
    along = (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
    across = (-along[1], along[0])
    return lambda x, y: [x * along[0] + y * across[0], x * along[1] + y * across[1]]


def on_incline(angle, friction):
    """A block of 10 kN on an incline, pulled straight up by its upper face."""
    at = corners(angle)
    block = [at(0, 0), at(LENGTH, 0), at(LENGTH, HEIGHT), at(0, HEIGHT)]
    base = [at(-1, -0.5), at(2, -0.5), at(2, 0), at(-1, 0)]
    return {
        "units": {"length": "m", "force": "N"}, "thickness": 1, "plane": "stress",
        "scene": {"regions": [{"name": "base", "material": "rock", "vertices": base}, {"name": "block", "material": "stone", "vertices": block}],
                  "subdivision": "given", "boundaries": {"bottom": base[:2]}},
        "materials": {"rock": STEEL, "stone": STEEL},
        "interfaces": {"foot": {"between": ["stone", "rock"], "law": {"type": "friction", "friction_angle": friction}, "points": "vertices"}},
        "supports": {"bottom": {"boundary": "bottom", "fix": "xy"}},
        "stages": [{"name": "weight", "loads": [{"type": "body_force", "materials": ["stone"], "force": [0, -WEIGHT / LENGTH / HEIGHT]}]},
                   {"name": "pull", "loads": [{"type": "point_load", "over": block[2:], "force": [0, WEIGHT]}]}]}


def turns_at(angle):
    """Pull over weight at which the block turns about its upper corner."""
    at = corners(angle)
    corner, centre, pulled = at(LENGTH, 0), at(LENGTH / 2, HEIGHT / 2), at(LENGTH / 2, HEIGHT)
    return (corner[0] - centre[0]) / (corner[0] - pulled[0])


def slid(stages, unit="N/m", friction=15):
    """A block of 8 kN, 1 m long and 0.4 m high, pushed until its top has moved 2 mm, which is held; then further stages."""
    m, newton = UNITS[unit]

    def of(x):
        return [m * c for c in x]

    def pushed(x, force):
        return {"type": "point_load", "over": [of([x, 0]), of([x, 0.4])], "force": [force / newton, 0]}

    ground = [[-1, -0.5], [2, -0.5], [2, 0], [-1, 0]]
    of_stress = 1 / newton / m**2
    weight = {"type": "body_force", "materials": ["stone"], "force": [0, -20000 / newton / m**3]}
    return {
        "units": {"length": "mm" if unit == "N/mm" else "m", "force": "MN" if unit == "MN/m" else "N"}, "thickness": m, "plane": "stress",
        "scene": {"regions": [{"name": "ground", "material": "rock", "vertices": [of(x) for x in ground]},
                              {"name": "block", "material": "stone", "vertices": [of(x) for x in ([0, 0], [1, 0], [1, 0.4], [0, 0.4])]}],
                  "subdivision": "given", "boundaries": {"bottom": [of(x) for x in ground[:2]]}},
        "materials": {name: STEEL | {"young_modulus": 1e10 * of_stress} for name in ("rock", "stone")},
        "interfaces": {"foot": {"between": ["stone", "rock"], "law": {"type": "friction", "friction_angle": friction}, "points": "vertices"}},
        "supports": {"bottom": {"boundary": "bottom", "fix": "xy"}},
        "gauges": {"top": {"type": "displacement", "at": of([0, 0.4]), "direction": [1, 0]}},
        "stages": [{"name": "weight", "loads": [weight]}, {"name": "forth", "loads": [pushed(0, 1000)], "until": {"top": 0.002 * m}},
                   *(stage(pushed) for stage in stages)]}


def back(pushed):
    return {"name": "back", "loads": [pushed(1, -1000)], "until": {"load_factor": 1}}


def unload(pushed):
    """What has pushed to the limit, taken off."""
    return {"name": "unload", "loads": [pushed(0, -1000)], "until": {"load_factor": 8 * math.tan(math.radians(15))}}


def cool(_):
    return {"name": "cool", "until": {"load_factor": 1},
            "loads": [{"type": "initial_strain", "regions": ["block"], "expansion": 1e-5, "temperature": -40}]}


def lift(pushed):
    """A kN at the middle of the upper face."""
    (x, low), (_, high) = pushed(0.5, 0)["over"]
    return {"name": "lift", "loads": [{"type": "point_load", "at": [x, high], "force": [0, 1000]}]}


def held_and_lifted(share):
    """The block, pushed by a share of what it bears, that is held, and lifted."""
    deck = slid([lift])
    push = {"type": "point_load", "over": [[0, 0], [0, 0.4]], "force": [share * 8000 * math.tan(math.radians(15)), 0]}
    deck["stages"][1] = {"name": "push", "loads": [push]}
    return deck


def wedged():
    """A block of 13 kN in a notch of two rocks, lifted off its seat, pressed into it, and again."""
    left, right = [[0, 0], [1.5, 0], [1.5, 0.3], [1, 1], [0, 1]], [[1.5, 0], [3, 0], [3, 1], [2, 1], [1.5, 0.3]]
    block = [[1, 1], [1.5, 0.3], [2, 1], [2, 1.3], [1, 1.3]]
    lift = {"type": "prescribed_displacement", "boundary": "head", "direction": [0, 1]}
    legs = [{"name": f"leg {i}", "unload": True, "until": {"lift": sign * 0.002}} for i, sign in enumerate((-1, 1, -1, 1))]
    return {
        "units": {"length": "m", "force": "N"}, "thickness": 1, "plane": "stress",
        "scene": {"regions": [{"name": name, "material": material, "vertices": outline} for name, material, outline in
                              (("left", "rock", left), ("right", "rock", right), ("block", "stone", block))],
                  "subdivision": "given", "boundaries": {"bottom": [[0, 0], [3, 0]], "head": block[3:]}},
        "materials": {"rock": STEEL, "stone": STEEL},
        "interfaces": {"seat": {"between": ["stone", "rock"], "law": {"type": "friction", "friction_angle": 35}, "points": "vertices"}},
        "supports": {"bottom": {"boundary": "bottom", "fix": "xy"}},
        "gauges": {"lift": {"type": "displacement", "at": [1, 1.3], "direction": [0, 1]}},
        "stages": [{"name": "weight", "loads": [{"type": "body_force", "materials": ["stone"], "force": [0, -20000]}]},
                   {"name": "off", "loads": [lift], "until": {"lift": 0.002}}, *legs]}


class FrictionLimits(ProgramCase):
    def run_(self, deck):
        run = ddapath.run(deck, folder=self.folder / "run", overwrite=True)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        return run

    def test_a_block_pulled_off_a_steep_plane_turns_about_its_corner(self):
        """On the way a corner begins to slide while the load rises and what it works on goes back."""
        for angle, friction in ((60, 70), (60, 85), (33, 60), (45, 65)):
            with self.subTest(angle=angle, friction=friction):
                run = self.run_(on_incline(angle, friction))
                self.assertIn("as a mechanism", run.summary["reason"])
                limit = turns_at(angle)
                self.assertLess(abs(run.summary["peak"]["load_factor"] / limit - 1), 1e-4)

    def test_a_stage_that_pushes_back_at_the_limit_sticks(self):
        """2144 N held less 1000 N is below the limit: nothing slides, and the block springs back by next to nothing."""
        run = self.run_(slid([back]))
        spent = run.curve["dissipated_energy"]
        self.assertLess(abs(spent.iloc[-1] / spent[run.curve["stage"] == run.curve["stage"].iloc[0]].max() - 1), 0.01)
        self.assertLess(abs(run.curve["top"].iloc[-1] / 0.002 - 1), 0.01)

    def test_a_stage_that_cools_at_the_limit_is_the_same_in_all_units(self):
        tops = [self.run_(slid([cool], unit)).curve["top"].iloc[-1] / UNITS[unit][0] for unit in UNITS]
        self.assertLess(max(tops) / min(tops) - 1, 1e-3)
        self.assertLess(abs(tops[0] / 0.002 - 1), 0.5)

    def test_an_unloaded_block_cools_towards_its_middle(self):
        """Both corners come to their limits at once, after a slip a thousand times as far as they overlap."""
        for unit in UNITS:
            for treatment in ("consistent", "lagrange"):
                with self.subTest(unit=unit, treatment=treatment):
                    deck = slid([unload, cool], unit)
                    deck["interfaces"]["foot"]["treatment"] = treatment
                    curve = self.run_(deck).curve
                    before = curve["top"][curve["stage"] < curve["stage"].iloc[-1]].iloc[-1]
                    self.assertLess(abs((curve["top"].iloc[-1] - before) / UNITS[unit][0] / 2e-4 - 1), 0.01)

    def test_what_cools_at_the_limit_and_is_lifted_slides_at_once(self):
        for unit in UNITS:
            with self.subTest(unit=unit):
                run = self.run_(slid([cool, lift], unit))
                self.assertRegex(run.summary["reason"], "slides as a mechanism at a load factor of 0|joints slide on")

    def test_what_is_held_by_friction_and_lifted_slides_beside_its_load(self):
        """At 8 kN (1 - share): the lift does no work on what slides level, of which nothing is wanted, or that it rises."""
        for points in ("vertices", "gauss"):
            for treatment in ("consistent", "penalty", "lagrange", "augmented_lagrangian"):
                for share, wanted in ((0.5, None), (0.5, 0.01), (0.999, 0.01), (1, None), (1, 0.01), (None, 0.01)):
                    with self.subTest(points=points, treatment=treatment, share=share, wanted=wanted):
                        deck = held_and_lifted(share) if share else slid([lift])
                        deck["interfaces"]["foot"] |= {"points": points, "treatment": treatment}
                        deck["gauges"]["rise"] = {"type": "displacement", "at": [0.5, 0.4], "direction": [0, 1]}
                        if wanted:
                            deck["path"] = {"stop": {"gauges": {"rise": wanted}}}
                        run = ddapath.run(deck, folder=self.folder / "run", overwrite=True, check=False)
                        self.assertRegex(run.summary["reason"], "slides as a mechanism|joints slide on")
                        self.assertEqual(run.summary["status"], "stopped_early" if wanted else "goal_reached")
                        self.assertAlmostEqual(run.curve.load.iloc[-1] / 8000, 1 - (share or 1), delta=1e-8)
                        self.assertLess(run.curve.top.abs().max(), 0.02)
                        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])

    def test_what_has_softened_and_slid_and_is_lifted_slides_at_once(self):
        for points in ("vertices", "gauss"):
            for treatment in ("consistent", "penalty", "lagrange"):
                with self.subTest(points=points, treatment=treatment):
                    deck = slid([lift])
                    deck["interfaces"]["foot"] |= {"points": points, "treatment": treatment, "law": {
                        "type": "linear_softening", "tensile_strength": 1e4, "cohesion": 1e4, "fracture_energy": 2, "friction_angle": 15}}
                    deck["path"] = {"stop": {"gauges": {"top": 0.5}}}
                    run = self.run_(deck)
                    self.assertEqual(run.summary["reason"], "top reached 0.5")
                    self.assertLess(abs(run.curve.load.iloc[-1]), 0.01)  # of 8 kN
                    self.assertLess(len(run.curve), 200)

    def test_loads_beyond_those_of_the_other_way_are_followed_in_few_steps(self):
        """Of 13 kN on the way up and thousands on the way down: steps are sized by both."""
        self.assertLess(self.run_(wedged()).summary["steps"], 400)


if __name__ == "__main__":
    unittest.main()
