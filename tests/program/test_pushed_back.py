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
