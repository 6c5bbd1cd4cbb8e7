"""From the end of a path to motion and rest, from the deck to what a user sees: a beam that cracks, breaks and falls.

    test_motion.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

import ddapath
from ddapath.verify import motion_checks, verify

STUDY = Path(__file__).resolve().parents[2] / "studies" / "falling-beam"
DECK = ddapath.read_deck(STUDY / "deck.yaml")
LIGAMENT, TOUGHNESS = 100 * 100, 0.05


def deck_with(**motion):
    deck = copy.deepcopy(DECK)
    deck["motion"].update(motion)
    return deck


SHAKEN = {
    "units": {"length": "m", "force": "kN"},
    "scene": {"regions": [{"name": "ground", "material": "stone", "undivided": True,
                           "vertices": [[-3, -0.5], [4, -0.5], [4, 0], [1, 0], [0, 0], [-3, 0]]},
                          {"name": "tower", "material": "stone", "vertices": [[0, 0], [1, 0], [1, 1.8], [0, 1.8]]}],
              "boundaries": {"bottom": [[-3, -0.5], [4, -0.5]]}, "subdivision": {"type": "bricks", "length": 0.5, "height": 0.3}},
    "thickness": 1, "plane": "stress",
    "materials": {"stone": {"type": "linear_elastic", "young_modulus": 10e6, "poisson_ratio": 0.2, "density": 2.3}},
    "interfaces": {"joints": {"between": ["stone", "stone"], "law": {"type": "friction", "friction_angle": 35}}},
    "stages": [{"name": "weight", "loads": [{"type": "body_force", "regions": ["tower"], "force": [0, -22.6]}]}],
    "supports": {"ground": {"boundary": "bottom", "fix": "xy"}},
    "motion": {"time": 0.5, "held": ["ground"],
               "driven": [{"regions": ["ground"], "direction": [1, 0],
                           "displacement": {"type": "harmonic", "amplitude": 0.15, "frequency": 1.5}}]},
}


class Shaken(unittest.TestCase):
    def test_a_ground_that_is_driven_is_not_held_by_the_supports_of_the_path(self):
        with tempfile.TemporaryDirectory() as scratch:
            curves = []
            for supports in (True, False):
                deck = copy.deepcopy(SHAKEN)
                deck["motion"]["supports"] = supports
                curves.append(ddapath.run(deck, folder=Path(scratch) / str(supports)).motion.curve)
        np.testing.assert_array_equal(curves[0]["kinetic_energy"], curves[1]["kinetic_energy"])
        weight = 22.6 * 1.8
        self.assertLess(curves[0]["external_work"].abs().max(), weight * 0.5)


class Falling(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        cls.run_ = ddapath.run(DECK, folder=cls.folder / "whole")
        cls.curve = cls.run_.motion.curve

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_tears_and_comes_to_rest(self):
        summary = self.run_.summary["motion"]
        self.assertTrue(summary["is_at_rest"], summary["reason"])
        self.assertTrue(summary["handover"]["is_pushed"])
        spent = self.run_.summary["dissipated_energy"] + summary["fracture"]
        self.assertAlmostEqual(spent / (TOUGHNESS * LIGAMENT), 1, delta=1e-4)

    def test_books_close(self):
        """What is external is kinetic, stored, spent or damped; the error of solving is next to nothing."""
        released = self.curve["kinetic_energy"].max()
        self.assertLess(self.curve["energy_error"].abs().max(), 1e-5 * released)
        self.assertGreater(self.curve["friction"].diff().min(), -1e-9 * released)
        self.assertGreater(self.curve["fracture"].diff().min(), -1e-12 * released)
        self.assertLess(self.curve["kinetic_energy"].iloc[-1], 1e-6 * released)
        self.assertGreater(self.curve["impact"].diff().min(), -1e-12 * released)

    def test_what_the_first_equilibrium_opens_is_spent_before_the_first_step(self):
        first = self.curve.iloc[0]
        self.assertGreater(first["fracture"], 0)
        self.assertLess(abs(first["numerical_damping"]), 1e-4 * first["fracture"])

    def test_lies_on_the_ground(self):
        vertices = self.run_.motion.fields().vertices
        of_beam = vertices[vertices["y"] >= 0]
        self.assertAlmostEqual((of_beam["y"] + of_beam["displacement_y"]).min(), -30, delta=0.1)

    def test_frames_tell_their_time(self):
        steps = self.run_.motion.steps
        self.assertGreater(len(steps), 10)
        self.assertTrue((self.run_.folder / "motion" / "run.xdmf").read_text().count("<Time") == len(steps))
        for name in ("end.svg", "energies.svg"):
            self.assertIn("</svg>", (self.run_.folder / "motion" / name).read_text())

    def test_resumed_bit_for_bit(self):
        """A run whose motion was killed does it once more, from the end of the path."""
        again = self.folder / "again"
        shutil.copytree(self.run_.folder, again)
        (again / "summary.json").unlink()
        subprocess.run([str(ddapath.find_program()), "resume", str(again), "--quiet"], check=True, capture_output=True)
        for name in ("curve.csv", "motion/motion.csv"):
            self.assertEqual((again / name).read_bytes(), (self.run_.folder / name).read_bytes(), name)

    def test_interrupted(self):
        folder = self.folder / "interrupted"
        run = subprocess.Popen([str(ddapath.find_program()), "run", str(self.run_.folder / "effective_deck.yaml"), "--folder",
                                str(folder), "--quiet", "--set", "motion.time=100", "--set", "motion.stop_at_rest=false"])
        deadline = time.monotonic() + 100
        while not (folder / "motion" / "motion.csv").exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(timeout=100), 130)
        self.assertEqual(ddapath.read_run(folder).status, "interrupted")

    def test_threads_make_no_difference(self):
        for threads in ("1", "2"):
            subprocess.run([str(ddapath.find_program()), "run", str(self.run_.folder / "effective_deck.yaml"), "--folder",
                            str(self.folder / threads), "--threads", threads, "--quiet", "--set", "motion.time=0.05"],
                           check=True, capture_output=True)
        one, two = (self.folder / threads / "motion" / "motion.csv" for threads in ("1", "2"))
        self.assertEqual(one.read_bytes(), two.read_bytes())


class Exponential(unittest.TestCase):
    """A law whose traction never vanishes: its faces part once next to nothing of it is left."""

    def test_tears_and_comes_to_rest(self):
        deck = deck_with()
        deck["interfaces"]["ligament"]["law"]["type"] = "exponential_softening"
        with tempfile.TemporaryDirectory() as scratch:
            run = ddapath.run(deck, folder=Path(scratch) / "run")
            summary = run.summary["motion"]
            self.assertTrue(summary["is_at_rest"], summary["reason"])
            spent = run.summary["dissipated_energy"] + summary["fracture"]
            self.assertAlmostEqual(spent / (TOUGHNESS * LIGAMENT), 1, delta=1e-3)


class ThroughBlocks(unittest.TestCase):
    """Parts of blocks that a crack has cut are bodies of their own."""

    def test_breaks_along_the_crack_and_rests(self):
        deck = ddapath.read_deck(STUDY / "through-blocks.yaml")
        deck["scene"]["subdivision"]["size"] = 28
        with tempfile.TemporaryDirectory() as scratch:
            run = ddapath.run(deck, folder=Path(scratch) / "run")
            pieces, motion = run.cracks(), run.summary["motion"]
            self.assertTrue(motion["is_at_rest"], motion["reason"])
            length = np.hypot(pieces.end_x - pieces.start_x, pieces.end_y - pieces.start_y).groupby(pieces.cut).sum().sum()
            self.assertAlmostEqual((run.summary["dissipated_energy"] + motion["fracture"]) / (TOUGHNESS * 100 * length), 1,
                                   delta=1e-4)
            self.assertLess(abs(motion["energy_error"]), 1e-6 * motion["external_work"])
            self.assertEqual([str(finding) for finding in verify(run.folder) if not finding.holds], [])
            whole, parts = (some.fields(some.steps[0]).mesh.areas.min() for some in (run, run.motion))
            self.assertLess(parts, whole)
            self.assertAlmostEqual(motion_checks.offset_of(run), run.deck["motion"]["contact"]["offset"] * whole**0.5)
            blocks = run.motion.fields().blocks
            self.assertGreater(len(blocks), run.summary["blocks"])
            moved = blocks[blocks.region == blocks.region.iloc[-1]]
            self.assertLess(moved.displacement_y.max(), 0)


def alone(**motion):
    """A block thrown from 5 m, and ground to fall on."""
    stone = {"type": "linear_elastic", "young_modulus": 1e10, "density": 2500}
    return {"units": {"length": "m", "force": "N"}, "thickness": 1, "materials": {"stone": dict(stone), "rock": dict(stone)},
            "scene": {"type": "polygons", "regions": [
                {"name": "ground", "material": "rock", "vertices": [[-20, -1], [20, -1], [20, 0], [-20, 0]]},
                {"name": "block", "material": "stone", "vertices": [[0, 5], [1, 5], [1, 6], [0, 6]]}]},
            "gauges": {"x": {"type": "displacement", "at": [0.5, 5.5], "direction": [1, 0]},
                       "y": {"type": "displacement", "at": [0.5, 5.5], "direction": [0, 1]}},
            "motion": {"time": 0.5, "gravity": [0, -9.81], "held": ["ground"], "contact": {"friction": 0.5},
                       "velocities": [{"regions": ["block"], "velocity": [2, 0], "spin": 1}]} | motion}


class Driven(unittest.TestCase):
    def test_by_an_expression_as_by_the_same_sine(self):
        curves = []
        for displacement, variables in (({"type": "harmonic", "amplitude": 0.15, "frequency": 1.5}, {}),
                                        ({"type": "expression", "value": "A*sin(2*pi*1.5*t)"}, {"A": 0.15})):
            deck = copy.deepcopy(SHAKEN) | {"variables": variables}
            deck["motion"]["driven"][0]["displacement"] = displacement
            with tempfile.TemporaryDirectory() as scratch:
                curves.append(ddapath.run(deck, folder=Path(scratch) / "run").motion.curve)
        np.testing.assert_allclose(curves[0]["external_work"], curves[1]["external_work"], rtol=1e-9, atol=1e-9)

    def test_steps_end_where_the_velocity_jumps(self):
        """A block on ground that sets off at v for T = 0.1 s: it is rubbed along by μ g, and slides on as far as it is fast by then.

        Its way, (μ g T)²/(2 μ g) on either side of the ground's stop, hangs on when that sets off and stops; μ g T < v.
        """
        ground = {"type": "table", "times": [0, 0.3, 0.4], "values": [0, 0, 0.05]}
        deck = alone(driven=[{"regions": ["ground"], "direction": [1, 0], "displacement": ground}], time=1, step=0.05, velocities=[])
        deck["scene"]["regions"][1]["vertices"] = [[0, 0], [1, 0], [1, 1], [0, 1]]
        deck["gauges"] = {"x": {"type": "displacement", "at": [0.5, 0.5], "direction": [1, 0]}}
        with tempfile.TemporaryDirectory() as scratch:
            curve = ddapath.run(deck, folder=Path(scratch) / "run").motion.curve
        for kink in (0.3, 0.4):
            self.assertLess(np.abs(curve["time"] - kink).min(), 1e-9)
        self.assertAlmostEqual(curve["x"].iloc[-1] / 0.04905, 1, delta=0.02)

    def test_begins_where_it_is(self):
        deck = copy.deepcopy(SHAKEN)
        deck["motion"]["driven"][0]["displacement"] = {"type": "expression", "value": "0.1*cos(t)"}
        with tempfile.TemporaryDirectory() as scratch, self.assertRaisesRegex(ddapath.InputError, "is 0 at the time 0"):
            ddapath.run(deck, folder=Path(scratch) / "run")


class Alone(unittest.TestCase):
    """Decks without stages."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def test_flies_and_records_its_gauges(self):
        run = ddapath.run(alone(), folder=self.folder)
        last = run.motion.curve.iloc[-1]
        self.assertAlmostEqual(last.x, 1, delta=1e-9)
        self.assertAlmostEqual(last.y, -9.81 / 8, delta=1e-9)
        self.assertEqual(run.motion.curve.attrs["units"]["x"], "m")
        self.assertEqual(run.summary["status"], "goal_reached")
        self.assertFalse((self.folder / "curve.csv").exists())
        self.assertAlmostEqual(run.motion.fields().blocks["rotation"].iloc[1], 0.5, delta=1e-9)

    def test_comes_to_rest_and_is_verified(self):
        run = ddapath.run(alone(time=20), folder=self.folder)
        self.assertTrue(run.summary["motion"]["is_at_rest"], run.summary["reason"])
        findings = verify(self.folder)
        self.assertGreater(len(findings), 5)
        self.assertEqual([str(finding) for finding in findings if not finding.holds], [])

    def test_restitution_by_pair_of_materials(self):
        contact = {"friction": 0, "pairs": [{"between": ["stone", "rock"], "restitution": 0.8}]}
        run = ddapath.run(alone(time=1.8, velocities=[], contact=contact, stop_at_rest=False), folder=self.folder)
        curve = run.motion.curve
        after = curve.y[curve.time > 1.1]
        self.assertAlmostEqual((after.max() + 5) / 5, 0.8**2, delta=0.02)

    def test_every_integrator(self):
        for integrator in ("free_flight", "implicit_euler", "trapezoidal", "settle", "classic"):
            settings = {"motion.integrator": integrator} | ({"motion.velocities": []} if integrator == "settle" else {})
            run = ddapath.run(alone(), settings, folder=self.folder, overwrite=True)
            self.assertLess(run.motion.curve.y.iloc[-1], -1 if integrator != "settle" else -0.05, integrator)

    def test_resumed_bit_for_bit(self):
        ddapath.run(alone(time=3), folder=self.folder)
        whole = (self.folder / "motion" / "motion.csv").read_bytes()
        (self.folder / "summary.json").unlink()
        subprocess.run([str(ddapath.find_program()), "resume", str(self.folder), "--quiet"], check=True, capture_output=True)
        self.assertEqual((self.folder / "motion" / "motion.csv").read_bytes(), whole)

    def test_checked(self):
        file = self.folder.with_suffix(".yaml")
        ddapath.write_deck(alone(), file)
        said = subprocess.run([str(ddapath.find_program()), "check", str(file)], check=True, capture_output=True,
                              text=True).stdout
        self.assertIn("1 of 2 blocks, from the undeformed structure on", said)
        self.assertNotIn("support", said)


class Classic(unittest.TestCase):
    """Discontinuous deformation analysis as it was published."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def test_falls_and_its_overlaps_are_measured(self):
        run = ddapath.run(alone(time=1.5, integrator={"type": "classic", "rotation": "first_order"}), folder=self.folder)
        self.assertEqual(run.summary["status"], "goal_reached")
        findings = {finding.check: finding for finding in verify(self.folder)}
        self.assertEqual([str(finding) for finding in findings.values() if not finding.holds], [])
        self.assertNotIn("motion: nothing crosses", findings)
        overlap = findings["motion: overlap by penalties, not bounded"]
        self.assertGreater(overlap.worst, 0)
        self.assertLess(overlap.worst, 0.01)
        self.assertEqual(overlap.bound, np.inf)

    def test_resumed_bit_for_bit(self):
        """Interrupted somewhere, growths of its blocks included."""
        whole = ddapath.run(alone(time=20, stop_at_rest=False, integrator={"type": "classic", "rotation": "first_order"}),
                            folder=self.folder)
        parts = self.folder.with_name("parts")
        table = parts / "motion" / "motion.csv"
        run = subprocess.Popen([str(ddapath.find_program()), "run", str(whole.folder / "effective_deck.yaml"), "--folder",
                                str(parts), "--quiet"])
        deadline = time.monotonic() + 100
        while not (table.exists() and table.stat().st_size > 20000) and time.monotonic() < deadline:
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(timeout=100), 130)
        subprocess.run([str(ddapath.find_program()), "resume", str(parts), "--quiet"], check=True, capture_output=True)
        self.assertEqual(table.read_bytes(), (whole.folder / "motion" / "motion.csv").read_bytes())

    def test_tears_as_its_toughness_says(self):
        """Joints and supports of the path go on in it."""
        run = ddapath.run(deck_with(time=0.03, integrator="classic"), folder=self.folder)
        spent = run.summary["dissipated_energy"] + run.summary["motion"]["fracture"]
        self.assertAlmostEqual(spent / (TOUGHNESS * LIGAMENT), 1, delta=1e-4)
        self.assertEqual([str(finding) for finding in verify(self.folder) if not finding.holds], [])


class Units(unittest.TestCase):
    def test_in_metres_and_meganewtons(self):
        """The same motion, before it is chaotic, in units of its own."""
        plain = deck_with(time=0.02)
        plain["scene"]["subdivision"] = {"type": "squares", "size": 50}
        deck = copy.deepcopy(plain)
        deck["motion"]["frame_every"] = 0
        metre, mega = 1e-3, 1e-6
        deck["units"] = {"length": "m", "force": "MN"}
        for region in deck["scene"]["regions"]:
            region["vertices"] = [[metre * x for x in vertex] for vertex in region["vertices"]]
        deck["scene"]["subdivision"]["size"] *= metre
        deck["thickness"] *= metre
        stress = mega / metre**2
        for material in deck["materials"].values():
            material["young_modulus"] *= stress
            if "density" in material:
                material["density"] *= mega / metre**4
        law = deck["interfaces"]["ligament"]["law"]
        law["tensile_strength"] *= stress
        law["fracture_energy"] *= mega / metre
        for support in deck["supports"].values():
            support["at"] = [metre * x for x in support["at"]]
        weight, bending = deck["stages"]
        weight["loads"][0]["force"][1] *= mega / metre**3
        bending["loads"][0]["at"] = [metre * x for x in bending["loads"][0]["at"]]
        bending["loads"][0]["force"][1] *= mega
        deck["gauges"]["deflection"]["at"] = [metre * x for x in deck["gauges"]["deflection"]["at"]]
        with tempfile.TemporaryDirectory() as scratch:
            one = ddapath.run(plain, folder=Path(scratch) / "one").summary["motion"]
            other = ddapath.run(deck, folder=Path(scratch) / "other").summary["motion"]
        self.assertEqual(one["steps"], other["steps"])
        for name in ("external_work", "kinetic_energy", "fracture"):
            self.assertAlmostEqual(other[name] / (one[name] * mega * metre), 1, delta=1e-6, msg=name)


class Refused(unittest.TestCase):
    def refusal(self, deck):
        with tempfile.TemporaryDirectory() as scratch:
            with self.assertRaises(ddapath.InputError) as refused:
                ddapath.run(deck, folder=Path(scratch) / "run")
            self.assertFalse((Path(scratch) / "run").exists())
        return str(refused.exception)

    def test_before_the_path_begins(self):
        without = deck_with()
        del without["materials"]["left"]["density"]
        self.assertIn("material 'left' needs a `density`", self.refusal(without))
        self.assertIn("did you mean 'ground'", self.refusal(deck_with(held=["grund"])))
        self.assertIn("nothing is left that could move", self.refusal(deck_with(held=["ground", "left", "right"])))
        self.assertIn("unknown parameter 'tim'", self.refusal(deck_with(tim=3)))
        self.assertIn("for blocks that nothing joins",
                      self.refusal(deck_with(integrator={"type": "classic", "rotation": "first_order"})))

    def test_without_a_path(self):
        self.assertIn("`path` needs `stages`", self.refusal(alone() | {"path": {"control": "load"}}))
        self.assertIn("`record` needs `stages`", self.refusal(alone() | {"record": {"fields_every": 3}}))
        self.assertIn("a deck needs `stages`", self.refusal({k: v for k, v in alone().items() if k != "motion"}))
        self.assertIn("second column of that name",
                      self.refusal(alone() | {"gauges": {"time": {"type": "displacement", "at": [0, 5], "direction": [1, 0]}}}))
        self.assertIn("no velocities", self.refusal(alone(integrator="settle")))
        self.assertIn("did you mean 'block'", self.refusal(alone(velocities=[{"regions": ["blok"], "spin": 1}])))
        self.assertIn("is held", self.refusal(alone(velocities=[{"regions": ["ground"], "spin": 1}])))
        rebounds = alone(integrator="classic", contact={"friction": 0, "restitution": 0.5})
        self.assertIn("how bodies rebound hangs on its penalty and step", self.refusal(rebounds))
        late = {"type": "table", "times": [1, 2], "values": [0, 1]}
        self.assertIn("begins with 0",
                      self.refusal(alone(driven=[{"regions": ["ground"], "direction": [1, 0], "displacement": late}])))
        self.assertIn("nothing pulls at what moves", self.refusal(alone(gravity=[0, 0], time=0)))
        root = {"type": "expression", "value": "sqrt(-t)"}
        self.assertIn("is no finite number at",
                      self.refusal(alone(driven=[{"regions": ["ground"], "direction": [1, 0], "displacement": root}])))
        self.assertIn("no region is of material 'ston'",
                      self.refusal(alone(contact={"friction": 0, "pairs": [{"between": ["ston", "rock"], "friction": 1}]})))


if __name__ == "__main__":
    unittest.main()
