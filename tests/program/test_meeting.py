"""Bodies that meet in motion, from the deck to what a user sees: impacts, friction, what is told and what is refused.

    test_meeting.py        with PYTHONPATH=python, and DDA naming the program
"""

import json
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import motion_checks, verify

from test_motion import DECK, STUDY, alone


class Meeting(unittest.TestCase):
    """Decks without stages."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def rebound(self, modulus, outline, share, step):
        """Speed of parting over that of approach of a stone that falls by 0.7 m."""
        deck = alone(time=0.7, velocities=[], contact={"friction": 0.5, "restitution": share}, stop_at_rest=False, step=step)
        deck["scene"]["regions"][1]["vertices"] = outline
        deck["gauges"] = {"y": {"type": "displacement", "at": [0.5, 1.1], "direction": [0, 1]}}
        for material in deck["materials"].values():
            material["young_modulus"] = modulus
        run = ddapath.run(deck, folder=self.folder, overwrite=True)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        curve, hit = run.motion.curve, (2 * 0.7 / 9.81) ** 0.5
        scale = curve[["external_work", "kinetic_energy", "impact", "numerical_damping"]].abs().to_numpy().max()
        self.assertLess(curve.energy_error.abs().max() / scale, 1e-6)
        after = curve[curve.time > hit + 0.02]
        highest = after.y.idxmax()
        height, late = after.y[highest] + 0.7, after.time[highest] - hit
        is_in_flight = highest == after.index[-1]
        return ((height + 9.81 / 2 * late**2) / late if is_in_flight else (2 * 9.81 * max(height, 0)) ** 0.5) / (9.81 * hit)

    def heights(self, restitution, step, blocks):
        """To which a stone of 0.5 m, or of blocks that are joined, comes back that falls by 1 m, as often as it hits the ground in 2 s."""
        deck = alone(time=2, velocities=[], contact={"friction": 0.5, "restitution": restitution}, step=step)
        deck["scene"]["regions"][0]["undivided"] = True
        deck["scene"]["regions"][1]["vertices"] = [[0.25, 1], [0.75, 1], [0.75, 1.5], [0.25, 1.5]]
        if blocks > 1:
            deck["scene"]["subdivision"] = {"type": "grid", "columns": blocks, "rows": blocks}
        deck["gauges"] = {"y": {"type": "displacement", "at": [0.5, 1.25], "inside": [0.501, 1.251], "direction": [0, 1]}}
        for material in deck["materials"].values():
            material["young_modulus"] = 1e10
        y = ddapath.run(deck, folder=self.folder, overwrite=True).motion.curve.y.to_numpy()
        return [1 + y[i] for i in range(1, len(y) - 1) if y[i] >= y[i - 1] and y[i] > y[i + 1]]

    def test_impacts_of_several_steps_give_as_much_back(self):
        for step in (0.01, 0.0025, 0.001):
            for height in self.heights(1, step, 1):
                self.assertAlmostEqual(height, 1, delta=0.005)

    def test_corners_that_touch_at_the_end_of_a_step_are_hit_alike(self):
        """A square flies for a tenth of a second, which is twenty steps, against a wall that it meets flat: rounding turns it not."""
        for share in (0.5, 1):
            deck = alone(time=0.3, gravity=[0, 0], velocities=[{"regions": ["block"], "velocity": [0, -2]}], contact={"friction": 0.5, "restitution": share}, step=0.01)
            deck["scene"]["regions"][1]["vertices"] = [[0, 0.2], [1, 0.2], [1, 1.2], [0, 1.2]]
            deck["gauges"] = {"spin": {"type": "rotation", "at": [0.5, 0.7]}}
            curve = ddapath.run(deck, folder=self.folder, overwrite=True).motion.curve
            self.assertLess(curve.spin.abs().max(), 1e-9)
            self.assertAlmostEqual(curve.kinetic_energy.iloc[-1] / 5000, share**2, delta=1e-3)

    def test_what_joints_hold_together_rebounds_as_one_body(self):
        self.assertAlmostEqual(self.heights(1, 0.01, 2)[0], 1, delta=0.02)
        self.assertAlmostEqual(self.heights(0.5, 0.01, 2)[0], 0.25, delta=0.01)

    def test_restitution_whatever_the_step(self):
        flat, corner = [[0, 0.7], [1, 0.7], [1, 1.7], [0, 1.7]], [[0, 1], [0.5, 0.7], [1, 1], [0.5, 1.5]]
        for modulus, outline, share, step in ((1e9, flat, 0, 0.002), (1e9, flat, 0, 0.0005), (1e7, flat, 0, 0.002),
                                              (1e9, corner, 0, 0.002), (1e10, corner, 0, 0.0005), (1e9, corner, 0.5, 0.002),
                                              (1e9, flat, 1, 0.002)):
            with self.subTest(modulus=modulus, corner=outline is corner, share=share, step=step):
                self.assertAlmostEqual(self.rebound(modulus, outline, share, step), share, delta=0.05)

    def resting(self, **motion):
        """The block of `alone` on its ground, where no interface lies."""
        deck = alone(velocities=[]) | {"gauges": {}}
        deck["motion"] |= motion
        for material in deck["materials"].values():
            material["young_modulus"] = 1e9
        deck["scene"]["regions"][1]["vertices"] = [[0, 0], [1, 0], [1, 1], [0, 1]]
        return deck

    def test_weight_that_comes_at_once_is_verified(self):
        """Energies of the middle of a step and of its end are no energy that an impact gives back; what is forged is."""
        ddapath.run(self.resting(gravity=[3.3552, -9.2184]), folder=self.folder)
        self.assertEqual([str(finding) for finding in verify(self.folder) if not finding.holds], [])
        curve = ddapath.read_run(self.folder).motion.curve.copy()
        later = curve.index >= len(curve) // 2
        curve.loc[later, "impact"] -= 0.03 * motion_checks.scale_of(curve)
        self.assertFalse(motion_checks.nothing_is_given_back(curve, False).holds)
        self.assertFalse(motion_checks.nothing_is_given_back(curve, False, swings=True).holds)

    def test_what_is_drawn_a_little_inside_each_other_begins_side_by_side(self):
        """Up to a millionth of a block, what drawings are rounded by: no energy is stored that nothing has given, nor given back."""
        deck = self.resting(time=0.2)
        for material in deck["materials"].values():
            material["young_modulus"] = 1e11
        for depth in (1e-6, 1e-8):
            deck["scene"]["regions"][1]["vertices"] = [[0, -depth], [1, -depth], [1, 1], [0, 1]]
            curve = ddapath.run(deck, folder=self.folder, overwrite=True).motion.curve
            self.assertLess(curve["stored_energy"].iloc[0], 0.1)
            self.assertEqual([str(finding) for finding in verify(self.folder) if not finding.holds], [])

    def test_regions_bonded_without_an_interface_are_told(self):
        run = ddapath.run(self.resting(time=0.01), folder=self.folder)
        self.assertIn("'ground' and 'block' touch and no interface lies between them", run.summary["notices"][0])
        self.assertIn("between: [rock, stone]", run.summary["notices"][0])
        with_interface = self.resting(time=0.01, contact={}) | {
            "interfaces": {"joint": {"between": ["rock", "stone"], "law": {"type": "friction", "friction_angle": 10}}}}
        run = ddapath.run(with_interface, folder=self.folder, overwrite=True)
        self.assertEqual(run.summary["notices"], [])

    def test_trapezoidal_where_bodies_meet_is_told(self):
        run = ddapath.run(alone(integrator="trapezoidal"), folder=self.folder)
        self.assertIn("take 'free_flight' where bodies meet", run.summary["notices"][0])
        bonded = self.resting(time=0.01, integrator="trapezoidal")
        notices = ddapath.run(bonded, folder=self.folder, overwrite=True).summary["notices"]
        self.assertFalse([notice for notice in notices if "trapezoidal" in notice])

    def test_friction_of_an_interface_before_that_of_pairs(self):
        joint = {"joint": {"between": ["rock", "stone"], "law": {"type": "friction", "friction_angle": 10}}}
        contact = {"pairs": [{"between": ["stone", "rock"], "friction": 0.5}]}
        run = ddapath.run(self.resting(time=0.01, contact=contact) | {"interfaces": joint}, folder=self.folder)
        self.assertIn("interface 'joint' have the friction 0.1763 of its law, not the 0.5", run.summary["notices"][0])

    def test_friction_of_the_only_pair_that_can_meet(self):
        run = ddapath.run(alone(contact={"pairs": [{"between": ["stone", "rock"], "friction": 0.5}]}), folder=self.folder)
        self.assertEqual(run.summary["status"], "goal_reached")

    def test_a_hundred_frames_of_what_was_short(self):
        """A motion that is at rest long before it has to be has as many frames as another."""
        frames = {}
        for name, motion in (("early", {"time": 60}), ("whole", {"time": 1, "stop_at_rest": False})):
            deck = alone(velocities=[], **motion) | {"gauges": {}}
            deck["scene"]["regions"][1]["vertices"] = [[0, 0.2], [1, 0.2], [1, 1.2], [0, 1.2]]
            run = ddapath.run(deck, folder=self.folder, overwrite=True)
            frames[name] = len(run.motion.steps)
            stored = {int(file.stem) for file in (self.folder / "motion" / "fields").glob("0*.h5")}
            self.assertEqual(stored, set(run.motion.steps))
        self.assertGreater(frames["early"], 75)  # next to all of its steps
        self.assertLess(frames["early"], 210)
        self.assertAlmostEqual(frames["whole"], 101, delta=2)

    def test_has_a_log(self):
        ddapath.run(alone(), folder=self.folder)
        (self.folder / "summary.json").unlink()
        subprocess.run([str(ddapath.find_program()), "resume", str(self.folder), "--quiet"], check=True, capture_output=True)
        events = [json.loads(line)["event"] for line in (self.folder / "log.jsonl").read_text().splitlines()]
        self.assertEqual(events, ["started", "motion", "ended", "resumed", "motion", "ended"])

    def test_killed_at_its_beginning(self):
        """From where the motion begins there is a restart file."""
        whole = ddapath.run(DECK, folder=self.folder.parent / "whole")
        folder = self.folder.parent / "killed"
        run = subprocess.Popen([str(ddapath.find_program()), "run", str(STUDY / "deck.yaml"), "--folder",
                                str(folder), "--quiet"])
        deadline = time.monotonic() + 100
        while not (folder / "motion" / "motion.csv").exists() and time.monotonic() < deadline:
            time.sleep(0.005)
        run.kill()
        run.wait(timeout=100)
        self.assertTrue((folder / "restart.h5").exists())
        subprocess.run([str(ddapath.find_program()), "resume", str(folder), "--quiet"], check=True, capture_output=True)
        for name in ("curve.csv", "motion/motion.csv"):
            self.assertEqual((folder / name).read_bytes(), (whole.folder / name).read_bytes(), name)

    def test_steps_by_the_error_of_places(self):
        """Flight asks for no short step, an impact does, the more the less error is allowed."""
        shortest, counts = [], []
        for accuracy in (1e-3, 1e-4, 1e-5):
            deck = alone(time=1.5, velocities=[], contact={"friction": 0.5, "restitution": 0}, step=0.05, accuracy=accuracy, stop_at_rest=False)
            deck["scene"]["regions"][1]["vertices"] = [[0, 0.5], [1, 0.5], [1, 1.5], [0, 1.5]]
            for material in deck["materials"].values():
                material["young_modulus"] = 1e9
            deck["gauges"] = {"y": {"type": "displacement", "at": [0.5, 1], "direction": [0, 1]}}
            curve = ddapath.run(deck, folder=self.folder, overwrite=True).motion.curve
            self.assertEqual([str(finding) for finding in verify(self.folder) if not finding.holds], [])
            fallen = (2 * 0.5 / 9.81) ** 0.5
            flight = curve[curve.time < 0.9 * fallen]
            self.assertLess(abs(flight.y + 9.81 / 2 * flight.time**2).max(), 1e-9)
            shortest.append(curve.time_step.min())
            counts.append(len(curve))
        self.assertGreater(shortest[0], 5 * shortest[2])
        self.assertGreater(counts[2], counts[0])
        for integrator in ("classic", "settle"):
            self.assertIn(f"motion.accuracy: '{integrator}'", self.refusal(alone(accuracy=1e-3, velocities=[], integrator=integrator)))

    def test_a_region_has_one_velocity(self):
        self.assertIn("region 'block' has a velocity by another entry", self.refusal(alone(velocities=2 * [{"regions": ["block"], "velocity": [2, 0]}])))

    def test_a_record_has_numbers(self):
        record = self.folder.parent / "quake.csv"
        record.write_text("time,acceleration\n0,0\n0.1,nan\n0.2,1\n", encoding="utf-8")
        deck = alone(velocities=[], held=[], driven=[{"regions": ["ground"], "direction": [1, 0], "displacement": {"type": "record", "file": str(record)}}])
        self.assertIn(f"{record}:3:1: the acceleration of a record is no finite number", self.refusal(deck))

    def refusal(self, deck):
        with self.assertRaises(ddapath.InputError) as refused:
            ddapath.run(deck, folder=self.folder)
        return str(refused.exception)

    def test_what_is_drawn_inside_each_other_is_refused_where_it_is(self):
        deck = alone(velocities=[]) | {"gauges": {}}
        for depth, refused in ((3e-4, True), (3e-7, False)):
            deck["scene"]["regions"][1]["vertices"] = [[0.5, -depth], [1, 0.5], [0.5, 1], [0, 0.5]]
            if refused:
                said = self.refusal(deck)
                self.assertIn("region 'ground' and block 1 of region 'block' overlap by 0.0003 at (0.5, -0.0003)", said)
                self.assertIn("deck.yaml", said)
            else:
                ddapath.run(deck, folder=self.folder)

    def test_friction_where_nothing_can_meet(self):
        """A cantilever in one piece meets nothing; one around a slot may close it, one that cracks meets itself."""
        beam = alone(held=[], velocities=[], contact={}, time=0.01)
        beam["scene"]["regions"] = [{"name": "beam", "material": "stone", "vertices": [[0, 0], [2, 0], [2, 0.2], [0, 0.2]]}]
        beam["scene"] |= {"subdivision": {"type": "grid", "columns": 4, "rows": 1}, "boundaries": {"root": [[0, 0], [0, 0.2]]}}
        beam |= {"gauges": {"y": {"type": "displacement", "at": [2, 0.2], "direction": [0, 1]}}, "supports": {"root": {"boundary": "root", "fix": "xy"}}}
        self.assertEqual(ddapath.run(beam, folder=self.folder).summary["status"], "goal_reached")
        cracks = beam | {"interfaces": {"mid": {"law": {"type": "linear_softening", "tensile_strength": 1e6, "fracture_energy": 100}}}}
        cracks["scene"] = cracks["scene"] | {"curves": {"mid": [[1, 0], [1, 0.2]]}}
        self.assertIn("no interface tells", self.refusal(cracks))
        beam["scene"]["regions"][0]["vertices"] = [[0, 0], [2, 0], [2, 0.2], [1, 0.2], [1, 0.1], [0.9, 0.1], [0.9, 0.2], [0, 0.2]]
        beam["scene"]["subdivision"] = {"type": "voronoi", "size": 0.1}
        self.assertIn("no interface tells", self.refusal(beam))

    def test_friction_of_a_pair_that_stands_twice(self):
        twice = [{"between": ["stone", "rock"], "friction": 1}, {"between": ["rock", "stone"], "friction": 0.2}]
        self.assertIn("stands here a second time", self.refusal(alone(contact={"friction": 0, "pairs": twice})))
        self.assertIn("no interface tells",
                      self.refusal(alone(contact={"pairs": [{"between": ["rock", "rock"], "friction": 1}]})))

    def test_marks_what_is_wrong(self):
        without = alone()
        del without["materials"]["stone"]["density"]
        with tempfile.TemporaryDirectory() as scratch:
            file = Path(scratch) / "deck.yaml"
            for deck, mark in ((alone(held=["grund"]), "grund"), (alone(held=["ground", "block"]), "held"), (without, "stone:")):
                ddapath.write_deck(deck, file)
                checked = subprocess.run([str(ddapath.find_program()), "check", str(file)], capture_output=True, text=True)
                self.assertEqual(checked.returncode, 2, checked.stderr)
                line = int(checked.stderr.split("deck.yaml:")[1].split(":")[0])
                lines = file.read_text().splitlines()
                self.assertIn(mark, " ".join(lines[max(0, line - 2):line]), checked.stderr)


if __name__ == "__main__":
    unittest.main()
