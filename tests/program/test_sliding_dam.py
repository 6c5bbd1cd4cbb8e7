"""A dam that slides by half a metre hardly opens: curve, summary, fields, figures and report tell both apart.

So does one whose foundation has to break first, and whose broken joints carry on by friction alone.

    test_sliding_dam.py        with PYTHONPATH=python, and DDA naming the program
"""

import base64
import json
import math
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np

import ddapath
import ddapath.verify

DECK = Path(__file__).resolve().parent / "sliding_dam.yaml"
FAR = DECK.with_name("dam_that_slides_far.yaml")
WEIGHT = 0.024 * 50 * (40 + 5) / 2  # [MN], of a metre of the dam
THRUST = 0.1 * 50  # [MN], of the water under a load factor of 1
SLIDING = 0.55  # [m], where the run ends
LITTLE = 1e-3  # [m], more than any joint of it opens
COARSE = 5e-5  # [m], by which openings at Gauss points and jumps in the middle of the pieces that they stand for differ


def scale_of(figure):
    """The numbers beside the colours of a figure, in their unit, and what they are of."""
    texts = [(text.get("font-size"), text.text) for text in xml.parse(figure).iter("{http://www.w3.org/2000/svg}text")]
    labels = [text for size, text in texts if size == "11.5" and "[m]" in text]
    numbers = [text for size, text in texts if size == "10"]
    power = next((text for text in numbers if text.startswith("×10")), "×10⁰")
    digits = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
    return [float(text) * 10 ** int(power[3:].translate(digits)) for text in numbers if text != power], labels


def last_cracks(page):
    """What the last stored step of a report's page has of its cracks."""
    data = re.search(r'<script type="application/json" id="report-data">(.*?)</script>', page.read_text(encoding="utf-8"), re.S)
    return json.loads(data.group(1))["blocks"]["steps"][-1]["cracks"]


class SlidingDam(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name) / "dam"
        cls.run_ = ddapath.run(DECK, folder=cls.folder)
        cls.last = cls.run_.curve.iloc[-1]

    def test_it_slides_under_the_thrust_that_friction_bears(self):
        self.assertEqual(self.run_.status, "goal_reached")
        self.assertAlmostEqual(self.last["load_factor"], WEIGHT * math.tan(math.radians(30)) / THRUST, places=6)

    def test_curve(self):
        self.assertAlmostEqual(self.last["heel_slides"], SLIDING, places=7)
        self.assertAlmostEqual(self.last["toe_slides"], SLIDING, delta=LITTLE)
        self.assertGreater(self.last["heel_opens"], 0)
        self.assertLess(self.last["heel_opens"], LITTLE)
        self.assertLess(self.last["toe_opens"], 0)  # pressed; its face gives way

    def jumps(self):
        """Of every point of the joint, from the displacements of the corners of the blocks: normal and tangential."""
        fields = self.run_.fields()
        corners = fields.vertices.reset_index()
        corners["above"] = corners["block"].map(fields.blocks["y"]) > 0
        base = corners[np.abs(corners["y"]) < 1e-9]
        at = {}
        for above, side in base.groupby("above"):
            order = side.sort_values("x")
            at[above] = [np.interp(fields.points["x"], order["x"], order[f"displacement_{axis}"]) for axis in "yx"]
        return [over - under for over, under in zip(at[True], at[False])]

    def test_fields_are_what_the_blocks_do(self):
        points = self.run_.fields().points
        normal, tangential = self.jumps()
        opened = normal > COARSE
        self.assertGreater(opened.sum(), 0)
        self.assertGreater((~opened).sum(), 0)
        np.testing.assert_allclose(points["opening_n"][opened], normal[opened], atol=COARSE)
        np.testing.assert_allclose(np.abs(points["opening_s"]), np.abs(tangential), atol=COARSE)

    def test_summary(self):
        foundation = self.run_.summary["interfaces"]["foundation"]
        points = self.run_.fields().points
        self.assertAlmostEqual(foundation["farthest"]["sliding"], points["opening_s"].abs().max(), places=12)
        self.assertAlmostEqual(foundation["farthest"]["sliding"], SLIDING, delta=1e-4)
        self.assertAlmostEqual(foundation["widest"]["opening"], points["opening_n"].max(), places=12)
        self.assertAlmostEqual(foundation["widest"]["opening"], self.last["heel_opens"], delta=0.2 * self.last["heel_opens"])

    def test_figures(self):
        openings, labels = scale_of(self.folder / "deformed.svg")
        self.assertEqual(labels, ["opening [m]"])
        self.assertGreater(max(openings), 0)
        self.assertLess(max(openings), LITTLE)
        slidings, labels = scale_of(self.folder / "deformed-sliding.svg")
        self.assertEqual(labels, ["sliding [m]"])
        step = slidings[1] - slidings[0]
        self.assertEqual(math.floor((SLIDING + LITTLE) / step), round(max(slidings) / step))  # the last number below it

    def test_report(self):
        subprocess.run([ddapath.find_program(), "report", self.folder], check=True, capture_output=True)
        cracks = last_cracks(self.folder / "report.html")
        opening, sliding = (np.frombuffer(base64.b64decode(cracks[name]), "<f4") for name in ("opening", "sliding"))
        foundation = self.run_.summary["interfaces"]["foundation"]
        self.assertAlmostEqual(opening.max(), foundation["widest"]["opening"], places=9)
        self.assertAlmostEqual(sliding.max(), foundation["farthest"]["sliding"], places=6)
        self.assertAlmostEqual(sliding.min(), SLIDING, delta=LITTLE)


class DamThatSlidesFar(unittest.TestCase):
    """Whichever control leads it, it slides on under the thrust that friction bears until it is where it was wanted."""

    WEIGHT = 23.5 * (24 * 25 + 5 * 30 + 5 * 5) / 2  # [kN], of a metre of the dam: shoelace formula
    THRUST = 9.81 * 30**2 / 2  # [kN], of the water under a load factor of 1

    def test_it_slides_on(self):
        for control in "staged", "arc_length":
            with self.subTest(control), tempfile.TemporaryDirectory() as scratch:
                run = ddapath.run(FAR, {"path.control": control}, folder=Path(scratch) / "dam")
                last = run.curve.iloc[-1]
                self.assertEqual((run.status, run.summary["reason"]), ("goal_reached", "crest reached 0.2"))
                self.assertAlmostEqual(last["crest"], 0.2, places=9)
                self.assertAlmostEqual(last["load_factor"] * self.THRUST / (self.WEIGHT * math.tan(math.radians(35))), 1, delta=1e-7)
                self.assertEqual([finding for finding in ddapath.verify.verify(run.folder) if not finding.holds], [])


class BrittleFoundation(unittest.TestCase):
    """What is released at once and leaves friction: once all is broken the dam slides under the same thrust."""

    def slides(self, strength, angle=30, bond=None, **foundation):
        """Its peak in units of the load that friction bears; `bond` are parameters of the law beside these."""
        law = {"type": "mohr_coulomb", "tensile_strength": strength, "cohesion": strength, "friction_angle": angle, **(bond or {})}
        settings = {f"interfaces.foundation.{key}": value for key, value in {"law": law, **foundation}.items()}
        with tempfile.TemporaryDirectory() as scratch:
            run = ddapath.run(DECK, settings, folder=Path(scratch) / "dam")
            last, peak = run.curve.iloc[-1], run.curve["load_factor"].max()
            refused = [finding for finding in ddapath.verify.verify(run.folder) if not finding.holds]
            thrust = WEIGHT * math.tan(math.radians(law.get("residual_friction_angle", angle)))
            self.assertEqual(run.status, "goal_reached")
            self.assertAlmostEqual(last["load_factor"] * THRUST / thrust, 1, delta=1e-7)
            self.assertAlmostEqual(last["heel_slides"], SLIDING, places=7)
            self.assertAlmostEqual(last["external_work"] / (thrust * SLIDING), 1, delta=0.05)
            self.assertLess(run.summary["energy_balance_error"], 1e-3)
            self.assertEqual(refused, [])
            return peak / last["load_factor"]

    def test_weak_bond(self):
        self.assertGreater(self.slides(0.5), 1.2)

    def test_strong_bond(self):
        self.assertGreater(self.slides(3), 1.5)

    def test_little_friction(self):
        self.slides(1.5, angle=20)

    def test_springs(self):
        self.slides(1.5, treatment={"type": "penalty"})

    def test_points_at_vertices(self):
        self.slides(1.5, points="vertices")

    def test_joints_that_close_while_they_are_released(self):
        bond = {"tensile_strength": 0.168, "residual_friction_angle": 25}
        self.slides(0.56, 35, bond, treatment={"type": "penalty", "factor": 10})


class TurningDam(unittest.TestCase):
    """With more friction it turns once its bonds are lost, about the last point that is pressed: a Gauss point of the toe's side."""

    def turns(self, **foundation):
        law = {"type": "mohr_coulomb", "tensile_strength": 0.3, "cohesion": 0.5, "friction_angle": 50}
        settings = {f"interfaces.foundation.{key}": value for key, value in {"law": law, **foundation}.items()}
        settings["path.stop"] = {"load_below": 0}
        with tempfile.TemporaryDirectory() as scratch:
            run = ddapath.run(DECK, settings, folder=Path(scratch) / "dam")
            refused = [finding for finding in ddapath.verify.verify(run.folder) if not finding.holds]
            self.assertEqual(run.status, "goal_reached")
            self.assertRegex(run.summary["reason"], "^turns as a mechanism")
            self.assertEqual(refused, [])
            self.assertGreaterEqual(run.curve["dissipated_energy"].diff().min(), 0)
            return run.curve["load_factor"].iloc[-1]

    def test_it_turns_under_the_thrust_that_its_weight_bears(self):
        centroid = (40**2 + 40 * 5 + 5**2) / (3 * (40 + 5))
        pivot = 40 - 5 * (1 - 3**-0.5) / 2
        factor = WEIGHT * (pivot - centroid) / (THRUST * 50 / 2)
        for foundation in ({}, {"treatment": {"type": "penalty"}}):
            self.assertAlmostEqual(self.turns(**foundation) / factor, 1, delta=1e-7)


if __name__ == "__main__":
    unittest.main()
