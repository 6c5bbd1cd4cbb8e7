"""Bodies that only touch, on inclined joints: a slab slides off a slope at the load of Coulomb whatever holds the joints, a flat arch
bears any load, and an arch that does not bear its weight about Gauss points says so.

    test_wedges.py        with PYTHONPATH=python, and DDA naming the program
"""

import json
import math
import unittest

import ddapath
from program_case import ProgramCase

STONE = {"stone": {"type": "linear_elastic", "young_modulus": 20000, "poisson_ratio": 0.2}}
WEIGHT, DEPTH = 2.354e-5, 100  # N/mm³, mm
TREATMENTS = ("consistent", "penalty", "lagrange", "augmented_lagrangian")


def block(name, *vertices):
    return {"name": name, "material": "stone", "undivided": True, "vertices": [list(v) for v in vertices]}


def deck(blocks, boundaries, push, friction, gauges=None, **joint):
    return {
        "units": {"length": "mm", "force": "N"}, "thickness": DEPTH, "plane": "stress", "materials": STONE,
        "scene": {"regions": blocks, "boundaries": boundaries},
        "interfaces": {"joints": {"between": ["stone", "stone"], "law": {"type": "friction", "friction_angle": friction}} | joint},
        "supports": {name: {"boundary": name, "fix": "xy"} for name in boundaries},
        "stages": [{"name": "weight", "loads": [{"type": "body_force", "force": [0, -WEIGHT]}]}, {"name": "push"} | push],
        "gauges": gauges or {},
    }


def slope(treatment, angle=20, friction=30):
    """Three slabs on a slope, the upper one pushed downhill; and the load at which it slides, W tan(φ − α)."""
    down = math.radians(-angle)
    turned = lambda x, y: [x * math.cos(down) - y * math.sin(down), x * math.sin(down) + y * math.cos(down)]
    layer = lambda name, left, right, low, high: block(name, *(turned(*p) for p in ((left, low), (right, low), (right, high), (left, high))))
    ground = block("ground", *(turned(*p) for p in ((-200, -200), (1500, -200), (1500, 0), (1200, 0), (0, 0), (-200, 0))))
    slabs = [layer(f"slab {i}", 100 * i, 1200 - 100 * i, 100 * i, 100 * (i + 1)) for i in range(3)]
    end = [turned(200, 200), turned(200, 300)]
    push = {"loads": [{"type": "point_load", "over": end, "force": [100, 0]}], "until": {"slip": 3}}
    weight = 800 * 100 * DEPTH * WEIGHT
    return (deck([ground, *slabs], {"bottom": [turned(-200, -200), turned(1500, -200)]}, push, friction,
                 {"slip": {"type": "displacement", "over": end, "direction": [1, 0]}}, treatment=treatment),
            weight * math.tan(math.radians(friction - angle)))


def flat_arch(treatment):
    wide = lambda x: 1.15 * x
    stones = [block(f"stone {i}", (x, 0), (x + 200, 0), (wide(x + 200), 250), (wide(x), 250)) for i, x in enumerate(range(-700, 700, 200))]
    piers = [block("left", (-1200, -600), (-700, -600), (-700, 0), (wide(-700), 250), (-1200, 250)),
             block("right", (700, -600), (1200, -600), (1200, 250), (wide(700), 250), (700, 0))]
    push = {"loads": [{"type": "point_load", "over": [[wide(-100), 250], [wide(100), 250]], "force": [0, -1000]}]}
    return deck(stones + piers, {"bottom": [[-1200, -600], [-700, -600]], "foot": [[700, -600], [1200, -600]]}, push, 30, treatment=treatment)


def round_arch(count=15, inner=950, outer=1100, **joint):
    at = lambda r, i: (r * math.cos(math.pi * (1 - i / count)), r * math.sin(math.pi * (1 - i / count)))
    stones = [block(f"stone {i}", at(inner, i), at(outer, i), at(outer, i + 1), at(inner, i + 1)) for i in range(count)]
    foot = lambda name, sign: block(name, *((sign * x, y) for x, y in ((800, -100), (1300, -100), (1300, 0), (outer, 0), (inner, 0), (800, 0))))
    push = {"loads": [{"type": "point_load", "over": [list(at(outer, 4)), list(at(outer, 5))], "force": [0, -1000]}]}
    return deck(stones + [foot("left", -1), foot("right", 1)], {"bottom": [[-1300, -100], [-800, -100]], "foot": [[800, -100], [1300, -100]]},
                push, 35, **joint)


def rocking(kinematics="first_order", **joint):
    """A block 1 × 2 of 40 kN that turns about its corner at 10 kN, on a bed."""
    region = lambda name, *vertices: {"name": name, "material": "stone", "vertices": [list(v) for v in vertices]}
    return {
        "units": {"length": "m", "force": "kN"}, "thickness": 1, "kinematics": kinematics,
        "scene": {"regions": [region("bed", (-1, -0.5), (2, -0.5), (2, 0), (1, 0), (0, 0), (-1, 0)), region("body", (0, 0), (1, 0), (1, 2), (0, 2))],
                  "boundaries": {"bottom": [[-1, -0.5], [2, -0.5]]}, "curves": {"joint": [[0, 0], [1, 0]]}},
        "materials": {"stone": {"type": "linear_elastic", "young_modulus": 1e7, "poisson_ratio": 0.2}},
        "interfaces": {"joint": {"law": {"type": "friction", "friction_angle": 60}} | joint},
        "supports": {"bottom": {"boundary": "bottom", "fix": "xy"}},
        "stages": [{"name": "weight", "loads": [{"type": "body_force", "regions": ["body"], "force": [0, -20]}]},
                   {"name": "push", "loads": [{"type": "point_load", "at": [0, 2], "force": [1, 0]}]}],
        "gauges": {"moved": {"type": "displacement", "at": [0, 2], "direction": [1, 0]}},
    }


class Wedges(ProgramCase):
    def run_(self, case):
        return ddapath.run(case, folder=self.folder / "run", overwrite=True, check=False)

    def test_a_slab_slides_off_a_slope(self):
        for treatment in TREATMENTS:
            case, slides = slope(treatment)
            run = self.run_(case)
            self.assertEqual(run.summary["status"], "goal_reached", f"{treatment}: {run.summary['reason']}")
            self.assertAlmostEqual(run.curve["load"].iloc[-1] / slides, 1, delta=1e-7, msg=treatment)
            self.assertLess(len(run.curve), 150, treatment)

    def test_a_flat_arch_bears_any_load(self):
        for treatment in TREATMENTS:
            run = self.run_(flat_arch(treatment))
            self.assertEqual(run.summary["status"], "goal_reached", f"{treatment}: {run.summary['reason']}")
            self.assertRegex(run.summary["reason"], "slides?, opens? or closes?")
            self.assertAlmostEqual(run.curve["load_factor"].iloc[-1], 1, delta=1e-9, msg=treatment)

    def test_what_turns_far_is_told(self):
        for moved, is_told in ((0.1, False), (0.6, True)):
            run = self.run_(rocking(points="vertices") | {"path": {"stop": {"load_below": 0, "gauges": {"moved": moved}}}})
            self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
            self.assertEqual(any("is turned by 0.3 at the end" in note for note in run.summary["notices"]), is_told, run.summary["notices"])

    def test_what_rocks_on_gauss_points_says_where_it_turns(self):
        """About points 0.21 or 0.11 of the side inside the corner: 1/√3 or √0.6 of 10 kN, and what helps is accepted."""
        turns = {2: ("closed at the other", "0.21 of its length", "down to 0.58", 10 / math.sqrt(3)),
                 3: ("closed at another", "0.11 of its length", "down to 0.77", 10 * math.sqrt(0.6))}
        for kinematics, joint, points in (("first_order", {"points": "gauss_2"}, 2), ("first_order", {}, 2), ("second_order", {}, 3),
                                          ("second_order", {"treatment": "lagrange"}, 2),
                                          ("second_order", {"treatment": "augmented_lagrangian", "points": "gauss"}, 3)):
            with self.subTest(f"{kinematics} {joint}"):
                run = self.run_(rocking(kinematics, **joint))
                *told, load = turns[points]
                self.assertAlmostEqual(run.curve["load"].max() / load, 1, delta=2e-3)
                notice = [text for text in run.summary["notices"] if "Gauss points" in text]
                self.assertEqual(len(notice), 1)
                for words in (f"{points} Gauss points", *told, "blocks of first order" if kinematics == "second_order" else "`points: vertices` has"):
                    self.assertIn(words, notice[0])
        run = self.run_(rocking(points="vertices"))
        self.assertAlmostEqual(run.curve["load"].max() / 10, 1, delta=2e-3)
        self.assertFalse([text for text in run.summary["notices"] if "Gauss" in text])

    def test_points_at_ends_beside_second_order_are_refused_with_the_reason(self):
        for points in ("vertices", "midpoint"):
            (self.folder / "deck.yaml").write_text(json.dumps(rocking("second_order", points=points)), encoding="utf-8")
            self.assertRegex(self.dda("check", "deck.yaml", code=2), "stress is linear along a side.*first order on both sides")

    def test_an_arch_says_that_its_sides_turn_inside_their_corners(self):
        """15 stones of 0.146 of the mean radius: more than the least thickness 0.1075 of Milankovitch, less of its Gauss points."""
        run = self.run_(round_arch())
        self.assertEqual(run.summary["status"], "stopped_early")
        self.assertRegex(run.summary["reason"], "stage 'weight' cannot be carried.*'joints' turn about Gauss points.*`points: vertices`")
        run = self.run_(round_arch(points="vertices"))
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertIn("turns as a mechanism", run.summary["reason"])


if __name__ == "__main__":
    unittest.main()
