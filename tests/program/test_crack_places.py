"""Where cracks begin by themselves, at the tip of a notch, whatever its shape and the blocks, and never along the boundary; and where they end.

    test_crack_places.py        with PYTHONPATH=python, and DDA naming the program
"""

import math
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


def slit(x, depth, subdivision):
    """The beam with a slit elsewhere, cut in few blocks: what it leaves bears more than twice the stress of the lower edge."""
    deck = beam("slit", 100)
    deck["scene"] |= {"slits": {"notch": [[x, 0], [x, depth]]}, "subdivision": subdivision}
    return deck


def plate(loads, blocks=150):
    """100 × 100 mm with slits of 30 mm on either side: what they leave bears 40 · 10 · 3 = 1200 N, and the section 3000 N."""
    scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [100, 0], [100, 100], [0, 100]]}],
             "slits": {"left": [[0, 50], [30, 50]], "right": [[100, 50], [70, 50]]},
             "boundaries": {"foot": [[0, 0], [100, 0]], "head": [[0, 100], [100, 100]]},
             "subdivision": {"type": "voronoi", "blocks": blocks, "seed": 1}}
    return deck_of(scene, {"supports": {"foot": {"boundary": "foot", "fix": "xy"}}, "stages": [{"loads": [loads]}]}) | {"thickness": 10}


def holed(subdivision):
    """200 × 200 mm with a hole of 60 mm, pulled between guided ends: both sides of the hole crack, 140 · 10 · 3 = 4200 N at most."""
    rim = [[100 + 30 * math.cos(math.pi * i / 12), 100 + 30 * math.sin(math.pi * i / 12)] for i in range(24)]
    scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [200, 0], [200, 200], [0, 200]]}],
             "holes": {"hole": rim}, "boundaries": {"foot": [[0, 0], [200, 0]], "head": [[0, 200], [200, 200]]}, "subdivision": subdivision}
    deck = deck_of(scene, {
        "supports": {"foot": {"boundary": "foot", "fix": "y"}, "middle": {"at": [100, 0], "fix": "x"}},
        "stages": [{"loads": [{"type": "prescribed_displacement", "boundary": "head", "direction": [0, 1]}]}],
        "cracks": [{"through_blocks": ["beam"], "begin": "automatic", "most": 2}]}) | {"thickness": 10}
    deck["interfaces"]["joints"]["law"]["fracture_energy"] = 0.1
    return deck


def panel(subdivision):
    """An L-shaped panel of 500 mm whose free leg is lifted: tension has no bound at the corner."""
    outline = [[0, 0], [250, 0], [250, 250], [500, 250], [500, 500], [0, 500]]
    scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": outline}], "boundaries": {"base": outline[:2]}, "subdivision": subdivision}
    return deck_of(scene, {
        "supports": {"base": {"boundary": "base", "fix": "xy"}},
        "stages": [{"loads": [{"type": "point_load", "over": [[455, 250], [485, 250]], "force": [0, 1]}]}]})


def opposed():
    """Two cracks that come from either side and end in one block."""
    scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [100, 0], [100, 100], [0, 100]]}],
             "boundaries": {"foot": [[0, 0], [100, 0]], "head": [[0, 100], [100, 100]]},
             "subdivision": {"type": "grid", "columns": 8, "rows": 5}}
    return deck_of(scene, {
        "supports": {"foot": {"boundary": "foot", "fix": "xy"}},
        "stages": [{"loads": [{"type": "prescribed_displacement", "boundary": "head", "direction": [0, 1]}]}],
        "cracks": [{"through_blocks": ["beam"], "begin": [{"at": [0, 52.5], "direction": [1, 0]}, {"at": [100, 47.5], "direction": [-1, 0]}]}],
        "path": {"stop": {"load_below": 0.1}}}) | {"thickness": 10}


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


def two_spans(until):
    """Two spans of 1 m, the left one loaded by 1 kN in a stage of its own, then the right one until it breaks."""
    scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [2000, 0], [2000, 200], [0, 200]]}],
             "subdivision": {"type": "voronoi", "size": 40, "seed": 1}}
    spans = [{"name": name, "loads": [{"type": "point_load", "over": [[x - 50, 200], [x + 50, 200]], "force": [0, -1000]}]}
             for name, x in (("left span", 500), ("right span", 1500))]
    spans[0] |= until
    held = {name: {"over": [[x - 50, 0], [x + 50, 0]], "fix": fix} for name, x, fix in (("left", 50, "xy"), ("prop", 1000, "y"), ("right", 1950, "y"))}
    return deck_of(scene, {"supports": held, "stages": spans})


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

    def test_a_corner_cracks_before_a_smooth_edge_however_large_the_blocks(self):
        """A notch aside of the middle before the lower face; the corner of a panel before the edge below it."""
        for deck, corner in ((beam("slit", 160), [-40, NOTCH]), (beam("slit", 1200), [-40, NOTCH]),
                             (panel({"type": "voronoi", "size": 30}), [250, 250]), (panel({"type": "voronoi", "size": 18}), [250, 250]),
                             (panel({"type": "quads", "size": 25}), [250, 250]), (panel({"type": "triangles", "size": 20}), [250, 250]),
                             (slit(-40, 40, {"type": "voronoi", "size": 25, "seed": 1}), [-40, 40]), (slit(-40, 40, {"type": "voronoi", "size": 20, "seed": 2}), [-40, 40]),
                             (slit(-80, 40, {"type": "voronoi", "size": 25, "seed": 2}), [-80, 40]), (slit(-80, 40, {"type": "quads", "size": 20}), [-80, 40])):
            with self.subTest(deck["scene"]["subdivision"]):
                self.assertLess(math.dist(self.run_(deck | {"path": {"stop": {"after_steps": 5}}}).crack_path()[0], corner), 0.5)

    def test_none_begins_on_the_face_of_a_slit(self):
        """Two blocks ahead of the tip are too few, which is told, and the crack begins below the load: no more than without a slit."""
        run = self.run_(slit(-40, 60, {"type": "voronoi", "size": 20, "seed": 1}))
        self.assertTrue(any("blocks deep ahead of the corner at (-40, 60)" in notice for notice in run.summary["notices"]), run.summary["notices"])
        self.assertLess(run.summary["peak"]["load"], 12000)
        self.assertLess(run.crack_path()[0][1], 1e-9)

    def test_slits_that_are_sheared_first_crack_at_their_tips(self):
        """They bear hardly more than their ligament at full strength, 22.5 kN."""
        outline = [[0, 0], [200, 0], [200, 200], [0, 200]]
        scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": outline}], "slits": {"left": [[0, 100], [25, 100]], "right": [[175, 100], [200, 100]]},
                 "boundaries": {"foot": outline[:2], "head": outline[2:], "side": [[0, 100], [0, 200]]}, "subdivision": {"type": "voronoi", "size": 7, "seed": 4}}
        deck = deck_of(scene, {
            "supports": {"foot": {"boundary": "foot", "fix": "xy"}},
            "stages": [{"name": "shear", "loads": [{"type": "edge_traction", "boundary": "side", "traction": [1, 0]}], "until": {"load_factor": 1}},
                       {"name": "pull", "loads": [{"type": "prescribed_displacement", "boundary": "head", "direction": [0, 1]}]}],
            "gauges": {"u": {"type": "displacement", "over": outline[2:], "direction": [0, 1]}},
            "path": {"stop": {"load_below": 0.8}}}) | {"thickness": 50}
        deck["interfaces"]["joints"]["law"]["fracture_energy"] = 0.11
        deck["cracks"][0]["most"] = 2
        self.assertLess(self.run_(deck).summary["peak"]["load"], 1.05 * 22500)

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

    def test_a_crack_that_waits_goes_where_the_stages_ask_for_it(self):
        """Two spans, of which the left one is loaded a little before the right one: as if that little were a dead load, and not a
        thirtieth of what the crack would bear that has waited in the left span."""
        dead, first = (self.run_(two_spans(until)).summary["peak"] for until in ({}, {"until": {"load_factor": 1}}))
        self.assertAlmostEqual(first["load"] / dead["load"], 1, delta=0.02)

    def test_the_first_stage_may_ask_for_none(self):
        """A bar that is pressed by 1 MPa and then pulled: its middle cracks when the pull has undone that, at ft + 1 MPa."""
        bar = {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [200, 0], [200, 40], [0, 40]]}],
               "boundaries": {"left": [[0, 0], [0, 40]], "right": [[200, 0], [200, 40]]},
               "subdivision": {"type": "voronoi", "blocks": 120, "seed": 1}}
        pressed, pulled = ({"name": name, "loads": [{"type": "edge_traction", "boundary": "right", "traction": [sign, 0]}]}
                           for name, sign in (("pressed", -1), ("pulled", 1)))
        run = self.run_(deck_of(bar, {"supports": {"left": {"boundary": "left", "fix": "x"}, "foot": {"at": [0, 0], "fix": "y"}},
                                      "stages": [pressed | {"until": {"load_factor": 1}}, pulled]}))
        self.assertAlmostEqual(run.summary["peak"]["load_factor"], 4, delta=0.02)

    def test_none_begins_on_an_edge_that_is_held_along_itself(self):
        """A beam between clamps that cools evenly, E α T = 6 MPa: it cracks at half of that, and does not wait on a clamp."""
        scene = {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [600, 0], [600, 100], [0, 100]]}],
                 "boundaries": {"left": [[0, 0], [0, 100]], "right": [[600, 0], [600, 100]]},
                 "subdivision": {"type": "voronoi", "size": 14, "seed": 1}}
        for fix in ("x", "xy"):
            deck = deck_of(scene, {"supports": {"left": {"boundary": "left", "fix": fix}, "right": {"boundary": "right", "fix": fix}},
                                   "stages": [{"loads": [{"type": "initial_strain", "expansion": 1e-5, "temperature": -20}]}],
                                   "gauges": {"s": {"type": "stress", "at": [300.3, 97], "component": "xx"}}})
            if fix == "x":
                deck["supports"]["foot"] = {"at": [0, 0], "fix": "y"}
            deck["plane"], deck["path"] = "stress", {"stop": {"load_factor_above": 3}}
            deck["materials"]["concrete"]["poisson_ratio"] = 0
            run = self.run_(deck)
            self.assertLess(run.curve.s.max(), 3.1, fix)
            self.assertLess(run.curve.s.iloc[-1], 0.1, fix)

    def test_one_may_begin_at_an_interface_where_cracks_end(self):
        """A soft skin below, glued on: with it under `end_at` or not, the crack begins where beam and skin meet."""
        scene = {"regions": [{"name": "skin", "material": "rubber", "vertices": [[0, -10], [400, -10], [400, 0], [0, 0]]},
                             {"name": "beam", "material": "concrete", "vertices": [[0, 0], [400, 0], [400, 100], [0, 100]]}],
                 "subdivision": {"type": "voronoi", "size": 12, "seed": 4}}
        deck = deck_of(scene, {"supports": {"left": {"over": [[0, 0], [0, 100]], "fix": "xy"}, "right": {"over": [[400, 0], [400, 100]], "fix": "y"}},
                               "stages": [{"loads": [{"type": "point_load", "over": [[190, 100], [210, 100]], "force": [0, -1000]}]}]})
        deck["materials"]["rubber"] = {"type": "linear_elastic", "young_modulus": 10, "poisson_ratio": 0.2}
        deck["interfaces"]["glue"] = {"between": ["rubber", "concrete"], "law": {"type": "bonded"}}
        deck["cracks"][0]["end_at"] = ["glue"]
        there = self.run_(deck)
        del deck["cracks"][0]["end_at"]
        self.assertAlmostEqual(there.summary["peak"]["load"] / self.run_(deck).summary["peak"]["load"], 1, delta=1e-9)
        self.assertLess(there.crack_path()[:, 1].min(), 1e-9)

    def test_a_crack_relieves_nothing_across_a_hole(self):
        """The other side of the hole cracks as soon as it is asked, whatever the blocks (it bore up to 12 times as much)."""
        peaks = [self.run_(holed(subdivision)).summary["peak"]["load"]
                 for subdivision in ({"type": "voronoi", "size": 8, "seed": 2}, {"type": "voronoi", "size": 8, "seed": 1})]
        for peak in peaks:
            self.assertLess(abs(peak / 3915 - 1), 0.01)

    def test_tension_that_no_crack_may_take_is_told(self):
        """A crack begun where a beam is pressed; below it is pulled."""
        deck = beam("none", 150)
        deck["scene"]["regions"][0]["vertices"] = [[-205, 0], [205, 0], [205, 100], [-205, 100]]
        deck["cracks"][0]["begin"] = [{"at": [60, 100], "direction": [0, -1]}]
        notices = self.run_(deck).summary["notices"]
        self.assertTrue(any("times the strength" in notice and "`begin: automatic`" in notice for notice in notices), notices)

    def test_what_two_cracks_leave_of_a_block_is_verified(self):
        self.assertEqual(self.run_(opposed()).summary["status"], "goal_reached")

    def test_a_law_without_strength_is_refused(self):
        for law in ({"type": "bonded"}, {"type": "elastic", "normal_stiffness": 1e5, "shear_stiffness": 1e5}, {"type": "friction", "friction_angle": 35}):
            deck = beam("slit", 200)
            deck["interfaces"]["joints"]["law"] = law
            with self.assertRaisesRegex(Exception, "need a law with a tensile strength"):
                ddapath.run(deck, folder=self.folder / "run", overwrite=True)


if __name__ == "__main__":
    unittest.main()
