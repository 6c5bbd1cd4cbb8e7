"""Where a path ends, and why: what its goal says is true of the last row, and nothing that is wanted is passed over.

    test_ends.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import subprocess
import tempfile
import unittest
from pathlib import Path

import ddapath

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


class Ends(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)

    def run_(self, deck, **changes):
        deck = copy.deepcopy(deck)
        for section, entries in changes.items():
            deck.setdefault(section, {}).update(entries)
        return ddapath.run(deck, folder=Path(self.scratch.name) / "run", check=False)

    def test_a_gauge_is_led_to_its_goal_where_nothing_can_crack(self):
        run = self.run_(BEAM, interfaces={"j": {"between": ["c", "c"], "law": "bonded"}}, path={"stop": {"gauges": {"defl": 1}}})
        self.assertEqual(run.summary["status"], "goal_reached")
        self.assertAlmostEqual(run.curve["defl"].iloc[-1], 1, delta=1e-9)

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

    def test_messages_that_cannot_be_written_change_nothing(self):
        program = str(ddapath.find_program())
        with open("/dev/full", "w", encoding="utf-8") as full:
            self.assertEqual(subprocess.run([program, "run", "/nowhere.yaml"], stderr=full).returncode, 2)
            folder = self.run_(BEAM).folder
            self.assertEqual(subprocess.run([program, "verify", str(folder)], stdout=full, stderr=subprocess.DEVNULL).returncode, 4)


if __name__ == "__main__":
    unittest.main()
