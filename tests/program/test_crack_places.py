"""Where cracks begin by themselves, at the tip of a notch, whatever its shape and the blocks, and never along the boundary; and where they end.

    test_crack_places.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

NOTCH = 40  # depth in a beam of 100 × 410 mm


def beam(notch, blocks, seed=1):
    outline = [[-205, 0], [205, 0], [205, 100], [-205, 100]]
    scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": outline}],
             "subdivision": {"type": "voronoi", "blocks": blocks, "seed": seed}}
    if notch == "slit":
        scene["slits"] = {"notch": [[-40, 0], [-40, NOTCH]]}
    else:
        outline[1:1] = [[-41, 0], [-41, NOTCH], [-39, NOTCH], [-39, 0]]
    return deck_of(scene, {
        "supports": {"left": {"at": [-200, 0], "fix": "xy"}, "right": {"at": [200, 0], "fix": "y"}},
        "stages": [{"loads": [{"type": "point_load", "over": [[-5, 100], [5, 100]], "force": [0, -1000]}]}],
    })


def plate(loads, blocks=150):
    """100 × 100 mm with slits of 30 mm on either side: what they leave bears 40 · 10 · 3 = 1200 N, and the section 3000 N."""
    scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [100, 0], [100, 100], [0, 100]]}],
             "slits": {"left": [[0, 50], [30, 50]], "right": [[100, 50], [70, 50]]},
             "boundaries": {"foot": [[0, 0], [100, 0]], "head": [[0, 100], [100, 100]]},
             "subdivision": {"type": "voronoi", "blocks": blocks, "seed": 1}}
    return deck_of(scene, {"supports": {"foot": {"boundary": "foot", "fix": "xy"}}, "stages": [{"loads": [loads]}]}) | {"thickness": 10}


def deck_of(scene, held):
    return {
        "units": {"length": "mm", "force": "N"}, "scene": scene, "thickness": 100,
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"joints": {"between": ["concrete", "concrete"],
                                  "law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.05}}},
        "cracks": [{"through_blocks": ["beam"], "begin": "automatic"}],
        "path": {"stop": {"load_below": 0.3}}, **held,
    }


def bent(seed, begin):
    """A beam of 100 × 400 mm whose moment is the same over 110 mm and falls off beside them, of a strength that varies by 30 %."""
    outline = [[-220, 0], [220, 0], [220, 100], [-220, 100]]
    deck = deck_of({"regions": [{"name": "beam", "material": "concrete", "vertices": outline}], "subdivision": {"type": "voronoi", "size": 8}}, {
        "supports": {"left": {"at": [-200, 0], "fix": "xy"}, "right": {"at": [200, 0], "fix": "y"}},
        "stages": [{"loads": [{"type": "point_load", "over": [[x - 10, 100], [x + 10, 100]], "force": [0, -1]} for x in (-65, 65)]}],
        "cracks": [{"through_blocks": ["beam"], "begin": begin}], "path": {"stop": {"after_steps": 1}}})
    deck["interfaces"]["joints"]["field"] = {"coefficient_of_variation": 0.3, "correlation_length": 20, "seed": seed}
    return deck


class Places(ProgramCase):
    def run_(self, deck):
        run = ddapath.run(deck, folder=self.folder / "run", overwrite=True)
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        return run

    def test_a_crack_begins_at_the_tip_of_a_notch(self):
        """As one that is begun there by hand: the peaks are the same within 3 %, and the crack does not turn down along the notch."""
        by_hand = beam("slit", 400)
        by_hand["cracks"][0]["begin"] = [{"at": [-40, NOTCH], "direction": [0.2, 1]}]
        wanted = self.run_(by_hand).summary["peak"]["load"]
        for notch, blocks in (("slit", 200), ("slit", 400), ("slit", 800), ("polygon", 400)):
            with self.subTest(notch, blocks=blocks):
                run = self.run_(beam(notch, blocks))
                self.assertAlmostEqual(run.summary["peak"]["load"] / wanted, 1, delta=0.03)
                self.assertGreater(run.crack_path()[:, 1].min(), NOTCH - 1)

    def test_a_crack_begins_where_the_field_lets_it_first(self):
        """No crack that is begun by hand cracks under less load, but for what lies between the edge and its first point, under a tenth."""
        for seed in (2, 3):
            by_hand = [self.run_(bent(seed, [{"at": [x, 0], "direction": [0, 1]}])).summary["peak"]["load"] for x in range(-100, 101, 20)]
            self.assertLess(self.run_(bent(seed, "automatic")).summary["peak"]["load"], 1.1 * min(by_hand), f"seed {seed}")

    def test_no_crack_runs_along_what_is_loaded_or_driven(self):
        for loads in ({"type": "edge_traction", "boundary": "head", "traction": [0, 1]},
                      {"type": "prescribed_displacement", "boundary": "head", "direction": [0, 1]}):
            with self.subTest(loads["type"]):
                run = self.run_(plate(loads))
                self.assertLess(run.summary["peak"]["load"], 1.25 * 1200)
                self.assertLess(abs(run.crack_path()[:, 1] - 50).max(), 20)

    def test_what_is_spent_ahead_of_a_crack_is_not_lost(self):
        """A crack grows by steps that pass the strength of what lies ahead of another one, which is not aimed anew later."""
        run = self.run_(ddapath.read_deck(Path(__file__).resolve().parent / "cracked_panel.yaml"))
        self.assertEqual(run.status, "goal_reached")

    def test_a_crack_ends_at_the_interface_between_two_materials(self):
        """Under `end_at`, the layer between core and cover is not crossed; else a crack from below goes on beyond it."""
        deck = beam("slit", 300)
        deck["scene"]["regions"].append({"name": "top", "material": "cover", "vertices": [[-205, 70], [205, 70], [205, 100], [-205, 100]]})
        deck["scene"]["regions"][0]["vertices"] = [[-205, 0], [205, 0], [205, 70], [-205, 70]]
        deck["materials"]["cover"] = deck["materials"]["concrete"]
        law = deck["interfaces"]["joints"]["law"]
        deck["interfaces"] |= {"layer": {"between": ["concrete", "cover"], "law": law}, "tops": {"between": ["cover", "cover"], "law": law}}
        crack = {"through_blocks": ["beam", "top"], "begin": [{"at": [-40, NOTCH], "direction": [0.2, 1]}]}
        for more, is_beyond in (({}, True), ({"end_at": ["layer"]}, False)):
            deck["cracks"], deck["path"] = [crack | more], {"stop": {"after_steps": 60}}
            self.assertEqual(self.run_(deck).crack_path()[:, 1].max() > 71, is_beyond)



if __name__ == "__main__":
    unittest.main()
