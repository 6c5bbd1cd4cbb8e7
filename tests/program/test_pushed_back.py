"""Stages whose loads push back what those before have opened, pulled or sheared, and stages that press on it.

    test_pushed_back.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify

BAR = Path(__file__).resolve().parents[2] / "studies" / "softening-bar" / "deck.yaml"
SOFTENING = {"type": "linear_softening", "tensile_strength": 1e5, "fracture_energy": 20, "cohesion": 1.5e5, "friction_angle": 35}
RELEASING = {"type": "mohr_coulomb", "tensile_strength": 1e5, "cohesion": 1.5e5, "friction_angle": 35}
WEIGHT = {"type": "body_force", "materials": ["rock"], "force": [0, -20000]}


def rocking(law):
    """A block of 40 kN, 1 m wide and 2 m high, pushed at its top until it has turned about a corner of its joint."""
    return {
        "units": {"length": "m", "force": "N"}, "thickness": 1, "plane": "stress",
        "scene": {"regions": [{"name": "ground", "material": "ground", "undivided": True, "vertices": [[-1, -1], [2, -1], [2, 0], [-1, 0]]},
                              {"name": "block", "material": "rock", "vertices": [[0, 0], [1, 0], [1, 2], [0, 2]]}],
                  "boundaries": {"floor": [[-1, -1], [2, -1]]}},
        "materials": {name: {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2} for name in ("ground", "rock")},
        "interfaces": {"joint": {"between": ["ground", "rock"], "law": law, "points": "vertices"}},
        "supports": {"floor": {"boundary": "floor", "fix": "xy"}},
        "stages": [{"name": "weight", "loads": [WEIGHT]},
                   {"name": "over", "loads": [{"type": "point_load", "at": [0, 2], "force": [100, 0]}], "until": {"u": 0.003}},
                   {"name": "back", "loads": [{"type": "point_load", "at": [0, 2], "force": [-100, 0]}]}],
        "gauges": {"u": {"type": "displacement", "at": [0, 2], "direction": [1, 0]}}}


def swayed(joint, width, height, pressure, drift):
    """A block under an even pressure, pushed at its top to and fro, and to again, each time as far; every push is held."""
    top = [[0, height], [width, height]]
    floor = [[-0.5, -0.3], [width + 0.5, -0.3]]
    push = {name: {"name": name, "loads": [{"type": "point_load", "over": top, "force": [sign, 0]}], "until": {"drift": sign * drift}}
            for name, sign in (("forth", 1), ("back", -1), ("again", 1))}
    return {
        "units": {"length": "m", "force": "N"}, "thickness": 1, "plane": "stress",
        "scene": {"regions": [{"name": "ground", "material": "ground", "undivided": True, "vertices": [*floor, [width + 0.5, 0], [-0.5, 0]]},
                              {"name": "block", "material": "rock", "undivided": True, "vertices": [[0, 0], [width, 0], *top[::-1]]}],
                  "boundaries": {"floor": floor, "top": top}},
        "materials": {name: {"type": "linear_elastic", "young_modulus": 5e9, "poisson_ratio": 0.2} for name in ("ground", "rock")},
        "interfaces": {"joint": {"between": ["ground", "rock"], "points": "vertices"} | joint},
        "supports": {"floor": {"boundary": "floor", "fix": "xy"}},
        "stages": [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "top", "traction": [0, -pressure]}]}, *push.values()],
        "gauges": {"drift": {"type": "displacement", "over": top, "direction": [1, 0]}}}


def couplet(law):
    """Two blocks on each other, sheared by 1 mm, held, pressed twice as much, sheared on and back (mm, N)."""
    press = {"type": "edge_traction", "boundary": "top", "traction": [0, -0.2]}
    shear = {"type": "body_force", "materials": ["above"], "force": [0.001, 0]}
    names = ("below", "above")
    return {
        "units": {"length": "mm", "force": "N"}, "thickness": 100, "plane": "stress",
        "scene": {"regions": [{"name": name, "material": name, "vertices": [[0, y], [200, y], [200, y + 50], [0, y + 50]]}
                              for name, y in zip(names, (0, 50))],
                  "boundaries": {"floor": [[0, 0], [200, 0]], "top": [[0, 100], [200, 100]]}},
        "materials": {name: {"type": "linear_elastic", "young_modulus": 20000, "poisson_ratio": 0.15} for name in names},
        "interfaces": {"joint": {"between": list(names), "law": {
            "type": law, "tensile_strength": 0.3, "fracture_energy": 0.02, "cohesion": 0.5, "friction_angle": 35, "shear_fracture_energy": 0.2}}},
        "supports": {"floor": {"boundary": "floor", "fix": "xy"}},
        "stages": [{"name": "pressed", "loads": [press]}, {"name": "sheared", "loads": [shear], "until": {"slip": 1}},
                   {"name": "pressed more", "loads": [press], "until": {"load_factor": 1}},
                   {"name": "sheared on", "loads": [shear], "until": {"slip": 2}},
                   {"name": "back", "loads": [shear | {"force": [-0.001, 0]}]}],
        "gauges": {"slip": {"type": "relative_displacement", "from": [100, 50], "from_inside": [99, 49], "to": [100, 50], "to_inside": [99, 51],
                            "direction": [1, 0]}},
        "path": {"stop": {"gauges": {"slip": -1}}}}


class PushedBack(unittest.TestCase):
    def run_of(self, deck, overrides=None):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        run = ddapath.run(deck, overrides, folder=Path(scratch.name) / "run")
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        return run

    def test_a_block_that_has_turned_turns_back_and_over_the_other_corner(self):
        """Held at 10 kN it turns back under nothing more, and the other way under twice that."""
        for law in (SOFTENING, RELEASING, {"type": "friction", "friction_angle": 35}):
            with self.subTest(law=law["type"]):
                run = self.run_of(rocking(law))
                self.assertAlmostEqual(run.curve.load_factor.iloc[-1] / 200, 1, delta=1e-6)
                self.assertLess(run.curve.u.iloc[-1], 0)

    def test_a_block_on_a_long_tail_goes_to_and_fro(self):
        """Behind its peak it turns about either corner at N b/2h, and slides either way at N tan φ: from one held push to the next it takes twice
        that, whatever is left of its joint."""
        law = {"type": "exponential_softening", "tensile_strength": 3e5, "cohesion": 4.5e5, "friction_angle": 39, "fracture_energy": 60}
        sliding = law | {"cohesion": 2e5, "friction_angle": 20, "shear_fracture_energy": 60}
        for treatment in ("consistent", "penalty", "lagrange", "augmented_lagrangian"):
            for shape, joint, size, force in (("turns", law, (1, 1, 1e5, 0.006), 1e5), ("slides", sliding, (2, 0.3, 5e4, 0.02), 2e5 * math.tan(math.radians(20)))):
                with self.subTest(shape, treatment=treatment):
                    run = self.run_of(swayed({"law": joint, "treatment": treatment}, *size))
                    self.assertAlmostEqual(run.curve.load_factor.iloc[-1] / force, 1, delta=1e-6)

    def test_a_warmed_stack_is_driven_either_way(self):
        """Its joint has cracked evenly as it warmed: the drive starts from nothing, and the force is the same to either side."""
        law = {"type": "exponential_softening", "tensile_strength": 2e5, "fracture_energy": 50, "cohesion": 3e5, "friction_angle": 30}
        peaks = []
        for way in (1, -1):
            deck = swayed({"law": law}, 1, 0.8, 1.2e5, 0.004)
            drive = {"type": "prescribed_displacement", "over": [[0, 0.8], [1, 0.8]], "direction": [way, 0], "displacement": 0.004, "name": "H"}
            warmth = {"type": "initial_strain", "expansion": 1e-5, "temperature": 40, "materials": ["rock"]}
            deck["stages"][1:] = [{"name": "warmed", "loads": [warmth], "until": {"load_factor": 1}}, {"name": "driven", "loads": [drive]}]
            deck["path"] = {"stop": {"load_factor_above": 1, "load_below": 0}}
            run = self.run_of(deck)
            peaks.append(run.summary["peak"]["load"])
            self.assertLess(len(run.curve), 300)
        self.assertAlmostEqual(peaks[1] / peaks[0], 1, delta=1e-6)

    def test_a_cooled_block_slides_to_and_fro(self):
        """Cracked as it cooled, it slides either way at N tan φ; what its balance leaves of the energy under next to no load is no error."""
        law = {"type": "linear_softening", "tensile_strength": 3e5, "cohesion": 4.5e5, "friction_angle": 20, "fracture_energy": 60}
        deck = swayed({"law": law, "points": "gauss"}, 1, 0.3, 1e5, 0.006)
        cold = {"type": "initial_strain", "expansion": 1e-5, "temperature": -20, "materials": ["rock"]}
        deck["stages"].insert(1, {"name": "cooled", "loads": [cold], "until": {"load_factor": 1}})
        self.assertAlmostEqual(self.run_of(deck).curve.load_factor.iloc[-1] / (2e5 * math.tan(math.radians(20))), 1, delta=1e-6)

    def test_an_anchor_that_is_needed_cannot_be_let_go(self):
        """A block that slides on 35° with φ = 25°: nothing of what its anchor bears can be taken away."""
        along, up = [math.cos(math.radians(35)), math.sin(math.radians(35))], [-math.sin(math.radians(35)), math.cos(math.radians(35))]
        at = lambda s, n: [s * along[0] + n * up[0], s * along[1] + n * up[1]]
        deck = {"units": {"length": "m", "force": "N"}, "thickness": 1, "plane": "stress",
                "scene": {"regions": [{"name": "rock", "material": "rock", "undivided": True, "vertices": [at(-1, -1), at(4, -1), at(4, 0), at(-1, 0)]},
                                      {"name": "block", "material": "block", "undivided": True, "vertices": [at(1, 0), at(2, 0), at(2, 0.5), at(1, 0.5)]}],
                          "boundaries": {"below": [at(-1, -1), at(4, -1)], "up": [at(2, 0), at(2, 0.5)]}},
                "materials": {name: {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2} for name in ("rock", "block")},
                "interfaces": {"joint": {"between": ["rock", "block"], "law": {"type": "friction", "friction_angle": 25}, "points": "vertices"}},
                "supports": {"below": {"boundary": "below", "fix": "xy"}, "anchor": {"boundary": "up", "direction": along, "stiffness": 1e8}},
                "stages": [{"name": "weight", "loads": [{"type": "body_force", "materials": ["block"], "force": [0, -24000]}]},
                           {"name": "off", "loads": [{"type": "support_removal", "support": "anchor"}], "until": {"load_factor": 1}}],
                "gauges": {"d": {"type": "displacement", "at": at(1, 0.5), "direction": [-along[0], -along[1]]}}}
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        with self.assertRaisesRegex(ddapath.StoppedEarly, "slides as a mechanism at a load factor of 0"):
            ddapath.run(deck, folder=Path(scratch.name) / "run")

    def test_what_has_been_released_and_slid_slides_back(self):
        """A block of 40 kN under λ times 4 kN: held at μ N it slides back under twice that."""
        wide = [rocking(RELEASING)["scene"]["regions"][0] | {"vertices": [[-1, -1], [3, -1], [3, 0], [-1, 0]]},
                {"name": "block", "material": "rock", "vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}]
        push = {"type": "body_force", "materials": ["rock"], "force": [2000, 0]}
        changes = {"scene": {"regions": wide, "boundaries": {"floor": [[-1, -1], [3, -1]]}},
                   "gauges": {"u": {"type": "displacement", "at": [0, 1], "direction": [1, 0]}},
                   "stages": [{"name": "weight", "loads": [WEIGHT]}, {"name": "over", "loads": [push], "until": {"u": 0.003}},
                              {"name": "back", "loads": [push | {"force": [-2000, 0]}]}]}
        for points in ("vertices", "gauss"):
            for law in (RELEASING | {"friction_angle": 20}, {"type": "friction", "friction_angle": 20}):
                with self.subTest(law=law["type"], points=points):
                    run = self.run_of(rocking(law) | changes, {"interfaces.joint.points": points})
                    self.assertAlmostEqual(run.curve.load_factor.iloc[-1] / (2 * 10 * math.tan(math.radians(20))), 1, delta=1e-8)
                    self.assertRegex(run.summary["reason"], "slides as a mechanism")

    def test_what_is_pressed_more_while_it_softens_stays(self):
        for law in ("linear_softening", "exponential_softening"):
            with self.subTest(law=law):
                curve = self.run_of(couplet(law)).curve
                pressed = curve[curve.stage == 3]
                self.assertLess((pressed.slip - 1).abs().max(), 0.01)
                self.assertAlmostEqual(pressed.load_factor.iloc[-1], 1, delta=1e-9)

    def test_a_bar_that_has_softened_is_let_go_by_the_opposite_load(self):
        pull = {"type": "edge_traction", "boundary": "right", "traction": [1, 0]}
        stages = [{"name": "pull", "loads": [pull], "until": {"mouth": 0.03}}, {"name": "back", "loads": [pull | {"traction": [-1, 0]}]}]
        mouth = {"type": "relative_displacement", "from": [50, 50], "from_inside": [49, 50], "to": [50, 50], "to_inside": [51, 50], "direction": [1, 0]}
        curve = self.run_of(BAR, {"stages": stages, "gauges": {"mouth": mouth}, "path.stop": {"load_factor_above": 0.5, "load_below": 0}}).curve
        back = curve[curve.stage == 2]
        self.assertLess(back.mouth.max(), 0.03)
        self.assertAlmostEqual(back.dissipated_energy.iloc[-1] / curve.dissipated_energy[curve.stage == 1].iloc[-1], 1, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
