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

import ddapath

DECK = ddapath.read_deck(Path(__file__).resolve().parents[2] / "studies" / "falling-beam" / "deck.yaml")
LIGAMENT, TOUGHNESS = 100 * 100, 0.05


def deck_with(**motion):
    deck = copy.deepcopy(DECK)
    deck["motion"].update(motion)
    return deck


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
        self.assertTrue(summary["is_pushed"])
        spent = self.run_.summary["dissipated_energy"] + summary["fracture"]
        self.assertAlmostEqual(spent / (TOUGHNESS * LIGAMENT), 1, delta=1e-4)

    def test_books_close(self):
        """What is external is kinetic, stored, spent or damped; the error of solving is next to nothing."""
        released = self.curve["kinetic_energy"].max()
        self.assertLess(self.curve["energy_error"].abs().max(), 1e-5 * released)
        self.assertGreater(self.curve["friction"].diff().min(), -1e-9 * released)
        self.assertGreater(self.curve["fracture"].diff().min(), -1e-12 * released)
        self.assertLess(self.curve["kinetic_energy"].iloc[-1], 1e-6 * released)

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
        with tempfile.TemporaryDirectory() as scratch, self.assertRaises(ddapath.InputError) as refused:
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
        stressed = deck_with()
        stressed["stages"].insert(0, {"name": "prestress", "loads": [{"type": "initial_stress", "xx": -1}]})
        self.assertIn("initial stress", self.refusal(stressed))


if __name__ == "__main__":
    unittest.main()
