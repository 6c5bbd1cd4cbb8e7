"""Water that follows into cracks: a bar, a block and a dam against their closed forms, cuts through blocks, and what is refused.

    test_water_in_cracks.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
import tempfile
import unittest
from pathlib import Path

import numpy as np

import ddapath
from ddapath.verify import verify

ROOT = Path(__file__).resolve().parents[2]
BAR = ROOT / "studies" / "softening-bar" / "deck.yaml"
DAM = Path(__file__).resolve().parent / "dam_on_cracked_base.yaml"
STRENGTH, ENERGY, AREA, MODULUS, LENGTH = 3.0, 0.1, 100 * 100, 30000, 1000  # of the bar
SLID = {
    "units": {"length": "m", "force": "kN"}, "thickness": 1, "plane": "strain",
    "scene": {"type": "polygons", "boundaries": {"bottom": [[-1, -1], [3, -1]], "top": [[0, 1], [2, 1]]}, "regions": [
        {"name": "rock", "material": "rock", "vertices": [[-1, -1], [3, -1], [3, 0], [-1, 0]]},
        {"name": "block", "material": "stone", "vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}]},
    "materials": {name: {"type": "linear_elastic", "young_modulus": 3e7, "poisson_ratio": 0.2} for name in ("rock", "stone")},
    "interfaces": {"base": {"between": ["rock", "stone"], "water": {"pressure": 80}, "law": {
        "type": "linear_softening", "tensile_strength": 200, "fracture_energy": 0.05, "cohesion": 300, "friction_angle": 35}}},
    "supports": {"bottom": {"boundary": "bottom", "fix": "xy"}},
    "stages": [{"name": "weight", "loads": [{"type": "edge_traction", "boundary": "top", "pressure": 300}]},
               {"name": "push", "loads": [{"type": "point_load", "at": [0, 0.05], "force": [1, 0]}]}],
    "gauges": {"slip": {"type": "displacement", "at": [2, 0.5], "direction": [1, 0]}},
    "path": {"stop": {"gauges": {"slip": 0.02}}}}


class Water(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def run_of(self, deck, overrides=None):
        run = ddapath.run(deck, overrides, folder=self.folder, overwrite=True)
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        return run

    def assert_bar(self, run, traction, bound):
        """`traction(w)` of the crack, whose opening w is what the elongation has beyond the bar's own."""
        curve = run.curve
        t = (curve.load / AREA).to_numpy()
        w = (curve.elongation - t * LENGTH / MODULUS).to_numpy()
        open_ = w > 1e-9
        self.assertGreater(open_.sum(), 8)
        self.assertLess(np.abs(t - traction(w))[open_].max(), bound)
        missing = (curve.external_work - curve.stored_energy - curve.dissipated_energy).abs().max()
        self.assertLess(missing, 2e-4 * curve.external_work.abs().max())

    def test_a_bar_carries_what_the_water_leaves(self):
        end = 2 * ENERGY / STRENGTH
        for treatment, bound in (("consistent", 1e-10), ("lagrange", 1e-6), ("augmented_lagrangian", 1e-6)):
            for opening in (end, 0.02):
                with self.subTest(treatment=treatment, opening=opening):
                    run = self.run_of(BAR, {"interfaces.crack.treatment": treatment, "interfaces.crack.points": "midpoint",
                                            "interfaces.crack.water": {"pressure": 0.5, "opening": opening}})
                    self.assert_bar(run, lambda w: STRENGTH * np.maximum(1 - w / end, 0) - 0.5 * np.minimum(w / opening, 1), bound)

    def test_a_law_without_an_end(self):
        law = {"type": "exponential_softening", "tensile_strength": STRENGTH, "fracture_energy": ENERGY}
        run = self.run_of(BAR, {"interfaces.crack.law": law, "interfaces.crack.water": {"pressure": 0.5, "opening": 0.02}})
        self.assert_bar(run, lambda w: STRENGTH * np.exp(-w * STRENGTH / ENERGY) - 0.5 * np.minimum(w / 0.02, 1), 1e-10)
        with self.assertRaisesRegex(ddapath.InputError, "`water` needs its `opening`"):
            ddapath.run(BAR, {"interfaces.crack.law": law, "interfaces.crack.water": {"pressure": 0.5}}, folder=self.folder)

    def test_friction_bears_what_the_water_leaves_of_the_pressure(self):
        run = self.run_of(SLID)
        self.assertAlmostEqual(run.curve.load.iloc[-1] / ((600 - 160) * math.tan(math.radians(35))), 1, delta=1e-9)

    def test_water_between_bodies_that_only_touch(self):
        """All of it from the beginning: pushed, the block slides at what friction makes of the rest of the pressure; lifted, it
        parts at it."""
        dry, lift = {"type": "friction", "friction_angle": 35}, [{"type": "edge_traction", "boundary": "top", "traction": [0, 1]}]
        for treatment in ("consistent", "penalty", "lagrange", "augmented_lagrangian"):
            with self.subTest(treatment=treatment):
                change = {"interfaces.base.law": dry, "interfaces.base.treatment": treatment}
                run = self.run_of(SLID, change)
                self.assertAlmostEqual(run.curve.load.iloc[-1] / ((600 - 160) * math.tan(math.radians(35))), 1, delta=1e-6)
                np.testing.assert_allclose(run.fields().points.water_pressure, 80)
                run = self.run_of(SLID, change | {"stages": [SLID["stages"][0], {"name": "lifted", "loads": lift}],
                                                  "gauges": {"slip": {"type": "displacement", "at": [1, 1], "direction": [0, 1]}}})
                self.assertAlmostEqual(run.curve.load.iloc[-1] / (600 - 160), 1, delta=1e-6)
                missing = (run.curve.external_work - run.curve.stored_energy - run.curve.dissipated_energy).abs().max()
                self.assertLess(missing, 1e-4 * run.curve.external_work.abs().max())

    def test_a_dam_slides_on_what_the_uplift_leaves_of_its_weight(self):
        weight, uplift = 24 * 30 * (24 + 5) / 2, 9.81 * 30 * 24
        run = self.run_of(DAM)
        self.assertAlmostEqual(run.curve.load.iloc[-1] / (weight - uplift), 1, delta=1e-6)
        points = run.fields().points
        np.testing.assert_allclose(points.water_pressure, 9.81 * 30, rtol=1e-12)
        dry = self.run_of(DAM, {"interfaces.base.water.pressure": 0})
        self.assertAlmostEqual(dry.curve.load.iloc[-1] / weight, 1, delta=1e-6)

    def test_it_stays_where_a_crack_closes_again(self):
        stage = {"type": "edge_traction", "boundary": "upstream", "pressure": "9.81*(30-y)"}
        weight = {"type": "body_force", "regions": ["dam"], "force": [0, -24]}
        run = self.run_of(DAM, {"stages": [
            {"name": "weight", "loads": [weight]}, {"name": "water", "loads": [stage], "until": {"crest": 0.012}},
            {"name": "drawn down", "until": {"load_factor": 0.3}, "unload": True}, {"name": "again"}]})
        steps = [run.fields(step) for step in run.steps]
        water = np.array([step.points.water_pressure for step in steps])
        self.assertGreaterEqual(np.diff(water, axis=0).min(), -1e-9 * water.max())
        self.assertEqual(run.summary["status"], "goal_reached")

    def test_cracks_through_blocks(self):
        bending = {"interfaces": {"inside": {
            "between": ["concrete", "concrete"], "water": {"pressure": "9.81*(30-y)"},
            "law": {"type": "linear_softening", "tensile_strength": 600, "fracture_energy": 0.1, "cohesion": 700, "friction_angle": 45}}},
            "cracks": [{"through_blocks": ["dam"], "begin": [{"at": [0, 6], "direction": [1, 0]}]}],
            "path.stop": {"gauges": {"crest": 0.06}}}
        wet = self.run_of(DAM, bending)
        self.assertGreater(wet.fields().cracks.water_pressure.max(), 9.81 * 20)
        load_of_wet = wet.curve.load.iloc[-1]
        bending["interfaces"]["inside"].pop("water")
        self.assertLess(load_of_wet, 0.95 * self.run_of(DAM, bending).curve.load.iloc[-1])

    def test_what_does_not_know_it_is_refused(self):
        for change, said in (({"interfaces.base.law": {"type": "friction", "friction_angle": 30}, "stages": SLID["stages"][1:]},
                              "parts them unless something presses on them"),
                             ({"interfaces.base.law": {"type": "friction", "friction_angle": 30}, "interfaces.base.water.opening": 1e-3},
                              "is that of a crack"),
                             ({"interfaces.base.law": {"type": "mohr_coulomb", "tensile_strength": 1, "cohesion": 2, "friction_angle": 30}},
                              "`water` needs a law that softens"),
                             ({"interfaces.base.water.opening": 1e-9}, "or a larger `opening` of its `water`"),
                             ({"motion": {"time": 1}}, "is not known to `motion`")):
            with self.subTest(said=said), self.assertRaisesRegex(ddapath.InputError, said):
                ddapath.run(SLID, change, folder=self.folder)


if __name__ == "__main__":
    unittest.main()
