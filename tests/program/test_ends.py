"""Where a path ends, and why: what its goal says is true of the last row, and nothing that is wanted is passed over.

    test_ends.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import math
import subprocess
import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify

BEAM = {
    "units": {"length": "mm", "force": "N"},
    "scene": {"regions": [{"name": "beam", "material": "c", "vertices": [[0, 0], [400, 0], [400, 100], [0, 100]]}],
              "subdivision": {"type": "voronoi", "size": 25}},
    "thickness": 100, "plane": "stress",
    "materials": {"c": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
    "interfaces": {"j": {"between": ["c", "c"], "law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.1}}},
    "supports": {"left": {"over": [[10, 0], [30, 0]], "fix": "xy"}, "right": {"over": [[370, 0], [390, 0]], "fix": "y"}},
    "stages": [{"name": "b", "loads": [{"type": "point_load", "over": [[180, 100], [220, 100]], "force": [0, -1]}]}],
    "gauges": {"defl": {"type": "displacement", "over": [[180, 100], [220, 100]], "direction": [0, -1]}},
    "path": {"stop": {"load_below": 0.1}},
}

# Two blocks on a bed, of which one is pushed and one is looked at.
BLOCKS = {
    "units": {"length": "mm", "force": "N"},
    "scene": {"regions": [{"name": name, "material": "s", "undivided": True, "vertices": [[x, y], [x + w, y], [x + w, y + h], [x, y + h]]}
                          for name, x, y, w, h in (("bed", 0, 0, 600, 50), ("pushed", 50, 50, 100, 50), ("other", 400, 50, 100, 50))],
              "curves": {"joint": [[50, 50], [150, 50]], "other joint": [[400, 50], [500, 50]]},
              "boundaries": {"floor": [[0, 0], [600, 0]]}},
    "thickness": 10, "plane": "stress",
    "materials": {"s": {"type": "linear_elastic", "young_modulus": 10000, "poisson_ratio": 0.2, "density": 2e-9}},
    "interfaces": {name: {"law": {"type": "friction", "friction_angle": 30}} for name in ("joint", "other joint")},
    "supports": {"floor": {"boundary": "floor", "fix": "xy"}},
    "stages": [{"name": "weight", "loads": [{"type": "body_force", "force": [0, -1e-3]}]},
               {"name": "push", "loads": [{"type": "point_load", "over": [[50, 50], [50, 100]], "force": [1, 0]}]}],
    "gauges": {"push": {"type": "displacement", "over": [[50, 50], [50, 100]], "direction": [1, 0]},
               "other": {"type": "displacement", "over": [[400, 50], [400, 100]], "direction": [1, 0]}},
}

# A block that is pushed, and lifted by the load: friction lets it go although the load does no work on the way.
LIFTED = {
    "units": {"length": "m", "force": "N"}, "thickness": 1, "plane": "stress",
    "scene": {"regions": [{"name": "ground", "material": "ground", "undivided": True, "vertices": [[-1, -1], [3, -1], [3, 0], [-1, 0]]},
                          {"name": "block", "material": "rock", "vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}],
              "boundaries": {"floor": [[-1, -1], [3, -1]]}},
    "materials": {name: {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2} for name in ("ground", "rock")},
    "interfaces": {"bed": {"between": ["ground", "rock"], "law": {"type": "friction", "friction_angle": 20}, "points": "vertices"}},
    "supports": {"floor": {"boundary": "floor", "fix": "xy"}},
    "stages": [{"name": "weight and push", "loads": [{"type": "body_force", "materials": ["rock"], "force": [5000, -20000]}]},
               {"name": "lift", "loads": [{"type": "body_force", "materials": ["rock"], "force": [0, 1000]}]}],
    "gauges": {"u": {"type": "displacement", "at": [0, 1], "direction": [1, 0]}},
}


class Ends(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)

    def run_(self, deck, **changes):
        deck = copy.deepcopy(deck)
        for section, entries in changes.items():
            if section.endswith("_"):
                deck[section[:-1]] = entries
            else:
                deck.setdefault(section, {}).update(entries)
        return ddapath.run(deck, folder=Path(self.scratch.name) / "run", overwrite=True, check=False)

    def test_a_gauge_is_led_to_its_goal_where_nothing_can_crack(self):
        run = self.run_(BEAM, interfaces={"j": {"between": ["c", "c"], "law": "bonded"}}, path={"stop": {"gauges": {"defl": 1}}})
        self.assertEqual(run.summary["status"], "goal_reached")
        self.assertAlmostEqual(run.curve["defl"].iloc[-1], 1, delta=1e-9)

    def test_what_slides_beside_its_load_is_a_mechanism(self):
        run = self.run_(LIFTED)
        self.assertRegex(run.summary["reason"], "slides as a mechanism")
        self.assertAlmostEqual(run.curve.load_factor.iloc[-1] / ((40 - 10 / math.tan(math.radians(20))) / 2), 1, delta=1e-8)
        self.assertLess(run.curve.u.abs().max(), 1e-3)
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])

    def test_what_could_crack_but_is_pressed(self):
        law = {"type": "linear_softening", "tensile_strength": 1e5, "fracture_energy": 20, "cohesion": 1.5e5, "friction_angle": 35}
        weight = {"type": "body_force", "materials": ["rock"], "force": [0, -20000]}
        run = self.run_(LIFTED, interfaces={"bed": {"between": ["ground", "rock"], "law": law}}, stages_=[{"name": "weight", "loads": [weight]}])
        self.assertEqual(run.summary["reason"], "nothing cracks under this load, however large; it is applied in full")
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])

    def test_a_stage_that_begins_where_joints_slide_on(self):
        weight = {"type": "body_force", "materials": ["rock"], "force": [0, -20000]}
        point = {"type": "point_load", "at": [0, 0.5], "force": [-100, 0]}
        body = {"type": "body_force", "materials": ["rock"], "force": [-1000, 0]}
        flat = [LIFTED["scene"]["regions"][0], {"name": "block", "material": "rock", "vertices": [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]}]
        rough = {"bed": {"between": ["ground", "rock"], "law": {"type": "friction", "friction_angle": 45}, "points": "vertices"}}
        gauge = {"u": {"type": "displacement", "at": [0, 0.5], "direction": [1, 0]}}
        for push, more, changes, said in (
                (point, body, {"scene": {"regions": flat}, "interfaces": rough, "gauges": gauge},
                 "the stage 'more' begins where joints slide on under its load, however small"),
                (body, body, {}, "slides as a mechanism at a load factor of 0")):
            stages = [{"name": "weight", "loads": [weight]}, {"name": "push", "loads": [push], "until": {"u": -0.004}},
                      {"name": "more", "loads": [more]}]
            with self.subTest(said=said):
                run = self.run_(LIFTED, stages_=stages, **changes)
                self.assertIn(said, run.summary["reason"])
                self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])

    def test_a_load_factor_must_have_been_above_what_it_is_to_fall_to(self):
        run = self.run_(BEAM, path={"stop": {"load_factor_below": 2000}})
        factors = run.curve["load_factor"]
        self.assertEqual(run.summary["status"], "goal_reached")
        self.assertAlmostEqual(factors.iloc[-1], 2000, delta=1e-3)
        self.assertGreater(factors.max(), 2001)
        self.assertGreater(len(factors), 5)

    def test_what_a_release_leaves_on_its_way_is_not_the_end(self):
        brittle = {"type": "mohr_coulomb", "tensile_strength": 3, "cohesion": 5, "friction_angle": 30}
        run = self.run_(BEAM, interfaces={"j": {"between": ["c", "c"], "law": brittle}}, path={"stop": {"load_below": 0.3}})
        if run.summary["reason"].startswith("load below"):
            self.assertNotEqual(run.curve["control"].iloc[-1], "release")
        of_release = run.curve[run.curve["control"] == "release"]
        self.assertGreater(len(of_release), 0)
        self.assertTrue(of_release["negative_eigenvalues"].isna().all())

    def test_a_mechanism_that_no_wanted_gauge_is_on(self):
        run = self.run_(BLOCKS, path={"stop": {"gauges": {"other": 1}, "load_below": 0}})
        self.assertEqual((run.summary["status"], run.summary["stop"]), ("stopped_early", "mechanism"))
        self.assertIn("comes no nearer", run.summary["reason"])
        friction = 100 * 50 * 10 * 1e-3 * 3 ** -0.5  # weight of the pushed block, times tan φ [N]
        self.assertAlmostEqual(run.curve["load"].iloc[-1] / friction, 1, delta=1e-7)

    def test_the_same_mechanism_goes_on_to_a_gauge_on_it(self):
        run = self.run_(BLOCKS, path={"stop": {"gauges": {"push": 5}, "load_below": 0}})
        self.assertEqual(run.summary["status"], "goal_reached")
        self.assertAlmostEqual(run.curve["push"].iloc[-1], 5, delta=1e-6)

    def test_a_mechanism_that_unloads_is_none_any_more(self):
        weight, push = BLOCKS["stages"]
        slides = {**push, "until": {"push": 0.05}}
        back = {"name": "back", "until": {"load_factor": 5}, "unload": True}
        for stages, is_offered in (([weight, slides], True), ([weight, slides, back], False)):
            run = self.run_(BLOCKS, stages_=stages, path={"stop": {"load_below": 0}})
            self.assertEqual(run.summary["status"], "goal_reached")
            self.assertEqual(any("ends in a mechanism" in notice for notice in run.summary["notices"]), is_offered)
        self.assertAlmostEqual(run.curve["load_factor"].iloc[-1], 5, delta=1e-6)

    def test_what_rocks_comes_back_under_the_load_at_which_it_rocks(self):
        """A block of 100 × 400 mm turns about its corner at weight · 50/350, there and back, and spends nothing."""
        side = [[50, 350], [50, 450]]
        scene = copy.deepcopy(BLOCKS["scene"])
        scene["regions"][1]["vertices"] = [[50, 50], [150, 50], [150, 450], [50, 450]]
        law = {"law": {"type": "friction", "friction_angle": 60}, "points": "vertices"}
        push = {"name": "push", "loads": [{"type": "point_load", "over": side, "force": [1, 0]}], "until": {"push": 2}}
        run = self.run_(BLOCKS, scene_=scene, interfaces={"joint": law}, gauges={"push": {"type": "displacement", "over": side, "direction": [1, 0]}},
                        stages_=[BLOCKS["stages"][0], push, {"name": "back", "until": {"load_factor": 0}, "unload": True}],
                        path={"stop": {"load_below": 0}})
        self.assertEqual((run.summary["status"], run.summary["reason"]), ("goal_reached", "load_factor reached 0"))
        rocking = 100 * 400 * 10 * 1e-3 * 50 / 350
        self.assertAlmostEqual(run.curve["load_factor"].max() / rocking, 1, delta=1e-6)
        back = run.curve[run.curve.index > run.curve["push"].idxmax()]
        coming = back[back["push"] > 0.1]["load_factor"]
        self.assertGreater(len(coming), 3)
        self.assertLess(abs(coming / rocking - 1).max(), 1e-6)
        self.assertLess(run.curve["dissipated_energy"].iloc[-1], 1e-4 * rocking * 2)

    def test_no_load_is_no_rupture_where_friction_would_bear_it_again(self):
        deck = Path(__file__).parent / "dam_on_friction.yaml"
        run = ddapath.run(deck, folder=Path(self.scratch.name) / "run", overwrite=True, check=False)
        loads = run.curve["load"]
        nothing = loads[loads <= 0].index[0]
        weight = (32 + 5) / 2 * 40 * 2.4 * 9.81
        self.assertGreater(loads[nothing:].max(), weight * math.tan(math.radians(40)))
        self.assertNotIn("rupture", run.summary["reason"])
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])

    def test_the_unit_of_a_moment_is_a_matter_of_taste(self):
        """Loads without a resultant: the load is the load factor, however large the forces are that it multiplies."""
        deck = {
            "units": {"length": "m", "force": "N"},
            "scene": {"regions": [{"name": "w", "material": "m", "vertices": [[0, 0], [4, 0], [4, 1], [0, 1]]}],
                      "boundaries": {"left": [[0, 0], [0, 1]]}, "curves": {"c": [[2, 0], [2, 1]]},
                      "subdivision": {"type": "grid", "columns": 8, "rows": 10}},
            "thickness": 1, "plane": "stress",
            "materials": {"m": {"type": "linear_elastic", "young_modulus": 3e10, "poisson_ratio": 0.2}},
            "interfaces": {"c": {"law": {"type": "linear_softening", "tensile_strength": 3e6, "fracture_energy": 200}}},
            "supports": {"l": {"boundary": "left", "fix": "xy"}},
            "path": {"stop": {"load_below": 0.1}},
        }
        peaks = []
        for unit in (1, 1e6, 1e8):
            run = self.run_(deck, stages_=[{"name": "p", "loads": [{"type": "moment", "over": [[4, 0], [4, 1]], "moment": unit}]}])
            self.assertEqual(run.summary["reason"], "load below 10 % of its peak")
            peaks.append(run.summary["peak"]["load"] * unit)
        self.assertLess(max(peaks) / min(peaks) - 1, 1e-6)

    def test_a_held_bar_that_shrinks_cracks_and_gives_way(self):
        """Strain, which moves nothing that is held, is no mechanism: λ ε0 E = ft, then σ = ft (1 − w/wc) and λ ε0 L = σ L/E + w down to
        λ = wc/(ε0 L) = 0.5, with Gf A spent."""
        bar = {
            "units": {"length": "m", "force": "N"},
            "scene": {"regions": [{"name": "bar", "material": "m", "vertices": [[0, 0], [10, 0], [10, 40], [0, 40]]}],
                      "boundaries": {"base": [[0, 0], [10, 0]], "head": [[0, 40], [10, 40]]}, "curves": {"c": [[0, 20], [10, 20]]},
                      "subdivision": {"type": "grid", "columns": 4, "rows": 16}},
            "thickness": 1, "plane": "stress",
            "materials": {"m": {"type": "linear_elastic", "young_modulus": 3e10, "poisson_ratio": 0}},
            "interfaces": {"c": {"law": {"type": "linear_softening", "tensile_strength": 3e6, "fracture_energy": 3000}}},
            "supports": {"base": {"boundary": "base", "fix": "y"}, "head": {"boundary": "head", "fix": "y"}, "pin": {"at": [0, 0], "fix": "x"}},
            "stages": [{"name": "shrinks", "loads": [{"type": "initial_strain", "yy": -1e-4}]}],
            "path": {"stop": {"load_below": 0.1, "steps": 200}},
        }
        run = self.run_(bar)
        self.assertIn("no joint begins to crack", run.summary["reason"])
        self.assertAlmostEqual(run.summary["peak"]["load"], 1, delta=1e-6)
        self.assertAlmostEqual(run.curve["load_factor"].iloc[-1], 0.5, delta=1e-6)
        self.assertAlmostEqual(run.curve["dissipated_energy"].iloc[-1] / 30000, 1, delta=1e-6)

    def test_stages_after_a_rupture_are_told(self):
        pull, shear = ({"name": name, "loads": [{"type": "prescribed_displacement", "name": name, "boundary": "right", "direction": way}]}
                       for name, way in (("pull", [1, 0]), ("shear", [0, 1])))
        bar = {
            "units": {"length": "mm", "force": "N"},
            "scene": {"regions": [{"name": "bar", "material": "c", "vertices": [[0, 0], [100, 0], [100, 50], [0, 50]]}],
                      "curves": {"middle": [[50, 0], [50, 50]]}, "boundaries": {"left": [[0, 0], [0, 50]], "right": [[100, 0], [100, 50]]},
                      "subdivision": {"type": "grid", "columns": 2, "rows": 2}},
            "thickness": 10, "plane": "stress",
            "materials": {"c": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0}},
            "interfaces": {"middle": {"law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.2}}},
            "supports": {"left": {"boundary": "left", "fix": "xy"}},
            "gauges": {"ux": {"type": "displacement", "at": [100, 25], "direction": [1, 0]}},
            "path": {"stop": {"load_below": 0}},
        }
        run = self.run_(bar, stages_=[{**pull, "until": {"ux": 1}}, shear])
        self.assertEqual((run.summary["status"], run.summary["stop"]), ("stopped_early", "stages-left"))
        self.assertIn("complete rupture; not followed any more: 'shear'", run.summary["reason"])
        run = self.run_(bar, stages_=[pull])
        self.assertEqual((run.summary["status"], run.summary["reason"]), ("goal_reached", "complete rupture"))

    def test_load_control_names_the_mechanism_at_which_it_ends(self):
        run = self.run_(BLOCKS, path={"control": "load", "stop": {"gauges": {"push": 5}, "load_below": 0}})
        self.assertEqual((run.summary["status"], run.summary["stop"]), ("stopped_early", "limit-point"))
        self.assertIn("moves on as a mechanism, which load control cannot follow", run.summary["reason"])
        friction = 100 * 50 * 10 * 1e-3 * 3 ** -0.5
        self.assertAlmostEqual(run.curve["load"].iloc[-1] / friction, 1, delta=1e-5)

    def test_a_load_that_slips_off_from_the_start(self):
        """Leaning by more than the angle of friction, nothing holds it, however small; by less, something does."""
        for angle, ends in ((20, "stopped_early"), (30, "goal_reached")):
            law = {"type": "friction", "friction_angle": angle}
            leaning = [{"name": "lean", "loads": [{"type": "edge_traction", "boundary": "head", "traction": [0.5, -1]}]}]
            run = self.run_(BLOCKS, interfaces={"joint": {"law": law}},
                            scene={"boundaries": {"floor": [[0, 0], [600, 0]], "head": [[50, 100], [150, 100]]}}, stages_=leaning)
            self.assertEqual(run.summary["status"], ends, run.summary["reason"])
            if ends == "stopped_early":
                self.assertIn("no equilibrium was found under the load, however small", run.summary["reason"])

    def test_without_friction_the_mechanism_needs_no_load(self):
        run = self.run_(BLOCKS, interfaces={"joint": {"law": {"type": "friction", "friction_angle": 0}}},
                        path={"stop": {"load_below": 0}})
        self.assertEqual(run.summary["status"], "goal_reached")
        self.assertIn("as a mechanism at a load factor of 0:", run.summary["reason"])
        self.assertEqual(subprocess.run([str(ddapath.find_program()), "verify", str(run.folder)], capture_output=True).returncode, 0)

    def test_joints_that_lock_are_named_where_they_stop_a_path(self):
        mortar = {"type": "linear_softening", "tensile_strength": 0.2, "fracture_energy": 0.02, "cohesion": 0.3, "friction_angle": 35}
        wall = {
            "units": {"length": "mm", "force": "N"},
            "scene": {"regions": [{"name": "w", "material": "b", "vertices": [[0, 0], [1000, 0], [1000, 480], [0, 480]]}],
                      "boundaries": {"floor": [[0, 0], [1000, 0]], "top": [[0, 480], [1000, 480]]},
                      "subdivision": {"type": "bricks", "length": 250, "height": 120}},
            "thickness": 100, "plane": "stress",
            "materials": {"b": {"type": "linear_elastic", "young_modulus": 5000, "poisson_ratio": 0.15}},
            "interfaces": {"joints": {"between": ["b", "b"], "law": mortar, "treatment": "augmented_lagrangian"}},
            "supports": {"floor": {"boundary": "floor", "fix": "xy"}},
            "stages": [{"name": "pressed", "loads": [{"type": "edge_traction", "boundary": "top", "traction": [0, -0.3]}]},
                       {"name": "pushed", "loads": [{"type": "point_load", "over": [[0, 360], [0, 480]], "force": [1, 0]}]}],
            "gauges": {"drift": {"type": "displacement", "at": [0, 480], "direction": [1, 0]}},
            "path": {"stop": {"gauges": {"drift": 4}, "steps": 3}},
        }
        run = self.run_(wall)
        self.assertTrue(any("interface 'joints' locks" in notice for notice in run.summary["notices"]), run.summary)
        if run.summary["status"] == "stopped_early":
            self.assertIn("locks", run.summary["reason"])

    def refusal(self, **changes):
        with self.assertRaises(ddapath.InputError) as caught:
            self.run_(BEAM, **changes)
        return str(caught.exception)

    def test_what_would_do_nothing_is_refused(self):
        for control, key, path in (("event", "path.branch", {"branch": "switch"}),
                                   ("event", "path.peak_tolerance", {"peak_tolerance": 1e-3}),
                                   ("load_increments", "path.step.accuracy", {"step": {"accuracy": 0.01}})):
            said = self.refusal(path={"control": control, **path},
                                interfaces={"j": {"between": ["c", "c"],
                                                  "law": {"type": "mohr_coulomb", "tensile_strength": 3, "cohesion": 5, "friction_angle": 30}}})
            self.assertIn(f"{key}: control '{control}' does not heed it", said)
        with self.assertRaisesRegex(ddapath.InputError, "joints that only touch have none"):
            self.run_(BLOCKS, path={"control": "load_increments"})
        self.assertIn("unknown control 'dispalcement'; did you mean 'displacement'?",
                      self.refusal(path={"expected_to_stop": ["dispalcement"]}))
        self.assertIn("'defl' is to reach 0, where the path starts", self.refusal(path={"stop": {"gauges": {"defl": 0}}}))

    def test_a_material_that_leaves_no_digits_is_refused(self):
        said = self.refusal(materials={"c": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.4999999999}}, plane_="strain")
        self.assertIn("materials.c: so near to its limit", said)

    def test_messages_that_cannot_be_written_change_nothing(self):
        program = str(ddapath.find_program())
        with open("/dev/full", "w", encoding="utf-8") as full:
            self.assertEqual(subprocess.run([program, "run", "/nowhere.yaml"], stderr=full).returncode, 2)
            folder = self.run_(BEAM).folder
            self.assertEqual(subprocess.run([program, "verify", str(folder)], stdout=full, stderr=subprocess.DEVNULL).returncode, 4)


if __name__ == "__main__":
    unittest.main()
