"""What a path hands over to a motion, and what a motion is damped by: from the deck to what a user sees.

    test_handover.py      with PYTHONPATH=python, and DDA naming the program
"""

import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
from scipy.signal import find_peaks

import ddapath
from ddapath.verify import verify

ROCK = {"type": "linear_elastic", "young_modulus": 1e10, "density": 2500}


def box(left, low, right, high):
    return [[left, low], [right, low], [right, high], [left, high]]


def pushed_block(**deck):
    """A block of 1 m on the ground, pushed until it slides at N tan φ = 24 525 N · 0.5."""
    return {"units": {"length": "m", "force": "N"}, "thickness": 1, "materials": {"rock": dict(ROCK), "stone": dict(ROCK)},
            "scene": {"type": "polygons", "regions": [
                {"name": "ground", "material": "rock", "vertices": box(-1, -1, 4, 0)},
                {"name": "block", "material": "stone", "vertices": box(0, 0, 1, 1)}]},
            "interfaces": {"bed": {"between": ["rock", "stone"], "law": {"type": "friction", "friction_angle": 26.56505117707799},
                                   "points": "vertices"}},
            "supports": {"left": {"at": [-1, -1], "fix": "xy"}, "right": {"at": [4, -1], "fix": "y"}},
            "stages": [{"name": "weight", "loads": [{"type": "body_force", "materials": ["stone"], "force": [0, -24525]}]},
                       {"name": "push", "loads": [{"type": "point_load", "at": [0, 0.25], "force": [1, 0]}]}],
            "gauges": {"x": {"type": "displacement", "at": [0.5, 0.5], "direction": [1, 0]}},
            "path": {"stop": {"gauges": {"x": 0.01}}}} | deck


def pushed_wall(way, law, **interface):
    """A wall of 0.25 m · 1.2 m that its weight holds and a load turns about its foot, until its top has gone so far; then it is let go."""
    return {"units": {"length": "m", "force": "N"}, "thickness": 1,
            "scene": {"regions": [{"name": "ground", "material": "rock", "vertices": box(-1, -0.3, 1.5, 0)},
                                  {"name": "wall", "material": "brick", "vertices": box(0, 0, 0.25, 1.2)}],
                      "boundaries": {"base": [[-1, -0.3], [1.5, -0.3]]}},
            "materials": {name: {"type": "linear_elastic", "young_modulus": 1e9, "poisson_ratio": 0.2, "density": 2500}
                          for name in ("rock", "brick")},
            "interfaces": {"foot": {"between": ["rock", "brick"], "law": law, **interface}},
            "supports": {"ground": {"boundary": "base", "fix": "xy"}},
            "stages": [{"name": "weight", "loads": [{"type": "body_force", "materials": ["brick"], "force": [0, -24525]}]},
                       {"name": "push", "loads": [{"type": "body_force", "materials": ["brick"], "force": [10000, 0]}]}],
            "gauges": {"x": {"type": "displacement", "at": [0.25, 1.2], "direction": [1, 0]}},
            "path": {"stop": {"gauges": {"x": way}}, "then": "motion"},
            "motion": {"held": ["ground"], "contact": {"friction": 0.6}, "time": 2, "loads": "drop"}}


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "run"

    def refused(self, folder):
        return [str(finding) for finding in verify(folder) if not finding.holds]


class Resumed(Scratch):
    def resume(self, *options):
        said = subprocess.run([str(ddapath.find_program()), "resume", str(self.folder), "--quiet", *options],
                              capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        return {name: (self.folder / name).read_bytes() for name in ("curve.csv", "motion/motion.csv") if (self.folder / name).exists()}

    def test_a_path_that_has_ended_gets_no_more_rows(self):
        """One that has ended as a mechanism, as one that has reached a goal; what follows it is taken up where it was."""
        for motion in ({}, {"motion": {"held": ["ground"], "time": 0.5}, "path": {"stop": {"gauges": {"x": 1}}, "then": "motion"}}):
            ddapath.run(pushed_block(**motion), folder=self.folder, overwrite=True)
            before = {name: (self.folder / name).read_bytes() for name in ("curve.csv", *(["motion/motion.csv"] if motion else []))}
            reason = ddapath.read_run(self.folder).summary["reason"]
            self.assertEqual(self.resume(), before)
            self.assertEqual(ddapath.read_run(self.folder).summary["reason"], reason)

    def test_another_goal_is_followed(self):
        ddapath.run(pushed_block(path={"stop": {"steps": 2}}), folder=self.folder, check=False)
        rows = len(ddapath.read_run(self.folder).curve)
        self.resume("--set", "path.stop.steps=1000", "--set", "path.stop.gauges={x: 0.01}")
        self.assertGreater(len(ddapath.read_run(self.folder).curve), rows)


class Joints(Scratch):
    """What joints do in motion that have cracked on the path."""

    def test_friction_of_joints_with_a_long_tail(self):
        """A beam of Voronoi blocks, let go where a crack has run through them: its joints close and rub while it springs back.

        Friction follows the pressure of joints as that of contacts does, so that a step has a minimum to be found; what vibrates
        is damped, and nothing is given back but for what energies of the middle of a step and of its end differ by.
        """
        for law in ("exponential_softening", "bilinear_softening"):
            with self.subTest(law=law):
                run = ddapath.run(self.beam(law), folder=self.folder, overwrite=True)
                self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
                self.assertIn("at rest", run.summary["motion"]["reason"])
                self.assertEqual(self.refused(self.folder), [])
                curve = run.motion.curve
                self.assertGreater(curve["fracture"].iloc[-1], 0)  # joints have worked
                falls = -np.diff(curve["impact"] + curve["numerical_damping"]) - np.abs(np.diff(curve["stored_energy"] - curve["impact_energy"])) / 2
                self.assertLess(falls.max(), 1e-9 * curve["kinetic_energy"].max())

    def test_what_has_cracked_bears_where_another_point_holds(self):
        """A block that was pushed until one corner of its joint had torn rocks back onto that corner, which bears as before."""
        deck = pushed_wall(0.02, {"type": "linear_softening", "tensile_strength": 1e5, "fracture_energy": 10}, points="vertices")
        run = ddapath.run(deck, folder=self.folder)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertLess(run.motion.curve.x.abs().max(), 0.021)
        self.assertEqual(self.refused(self.folder), [])

    def test_turning_is_handed_over_with_what_is_stored(self):
        """A turn r moves what is far from a centroid by r²/2 of that way, and the corner of a side that turns about a point inside it
        into what it stands on: neither strains anything."""
        softens = {"type": "linear_softening", "tensile_strength": 1e5, "fracture_energy": 10}
        slides = {"type": "friction", "friction_angle": 40}
        for law, ways in ((softens, (0.002, 0.1)), (slides, (0.002, 0.02, 0.1))):
            for way in ways:
                with self.subTest(law=law["type"], way=way):
                    run = ddapath.run(pushed_wall(way, law), folder=self.folder, overwrite=True)
                    stored = run.summary["stored_energy"]
                    self.assertAlmostEqual(run.motion.curve.stored_energy.iloc[0] / stored, 1, delta=0.05)
                    self.assertAlmostEqual(run.summary["motion"]["handover"]["released_energy"] / stored, 0, delta=0.05)
                    self.assertEqual(self.refused(self.folder), [])

    def test_what_is_joined_falls_as_one_whatever_the_steps(self):
        """A step that is cut shows the velocity of its own middle, and loads have worked up to there."""
        stones = [{"name": "low", "material": "rock", "vertices": box(0, 0, 1, 1)},
                  {"name": "high", "material": "stone", "vertices": box(0, 1, 1, 2)}]
        deck = pushed_block(
            scene={"type": "polygons", "regions": stones}, supports={}, stages=[], path={}, gauges={},
            interfaces={"bed": {"between": ["rock", "stone"], "law": {"type": "elastic", "normal_stiffness": 1e11, "shear_stiffness": 1e11}}},
            motion={"gravity": [0, -9.81], "time": 0.065, "stop_at_rest": False, "contact": {"friction": 0.5}})
        for key in ("supports", "stages", "path", "gauges"):
            del deck[key]
        last = ddapath.run(deck, folder=self.folder).motion.curve.iloc[-1]
        exact = 2500 * (9.81 * (last.time - last.time_step / 2)) ** 2  # ½ of two blocks
        self.assertLess(last.time_step, 0.9 * 0.01 / 9.81 ** 0.5)
        self.assertAlmostEqual(last.kinetic_energy / exact, 1, delta=1e-9)
        self.assertAlmostEqual(last.external_work / exact, 1, delta=1e-9)

    def test_a_driven_ground_works_by_the_forces_of_the_whole_step(self):
        """A wall bonded to a ground that sets out: mean accelerations lose nothing, and their book says so."""
        deck = pushed_block(
            supports={}, stages=[], path={}, scene={"type": "polygons", "regions": [
                {"name": "ground", "material": "rock", "vertices": box(-2, -0.3, 3, 0)},
                {"name": "wall", "material": "stone", "vertices": box(0, 0, 0.25, 1.2)}]},
            interfaces={"foot": {"between": ["rock", "stone"], "law": {"type": "elastic", "normal_stiffness": 1e10, "shear_stiffness": 1e10}}},
            gauges={"x": {"type": "displacement", "at": [0.25, 1.2], "direction": [1, 0]}},
            motion={"gravity": [0, -9.81], "time": 0.5, "integrator": "trapezoidal", "contact": {"friction": 0.6},
                    "driven": [{"regions": ["ground"], "direction": [1, 0], "displacement": {"type": "expression", "value": "0.1*t*t"}}]})
        for key in ("supports", "stages", "path"):
            del deck[key]
        curve = ddapath.run(deck, folder=self.folder).motion.curve
        self.assertLess(abs(curve.impact + curve.numerical_damping).max(), 1e-5 * curve.kinetic_energy.max())
        self.assertFalse(self.refused(self.folder))

    def beam(self, law):
        return {"units": {"length": "mm", "force": "N"}, "thickness": 100, "plane": "stress",
                "scene": {"regions": [{"name": "beam", "material": "concrete", "vertices": box(-220, 0, 220, 100)}],
                          "subdivision": {"type": "voronoi", "size": 30}},
                "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2, "density": 2.4e-9}},
                "interfaces": {"joints": {"between": ["concrete", "concrete"],
                                          "law": {"type": law, "tensile_strength": 3, "fracture_energy": 0.1, "friction_angle": 35}}},
                "cracks": [{"through_blocks": ["beam"], "begin": "automatic"}],
                "supports": {"left": {"over": [[-205, 0], [-195, 0]], "fix": "xy"},
                             "right": {"over": [[195, 0], [205, 0]], "fix": "y"}},
                "stages": [{"name": "bending", "loads": [
                    {"type": "point_load", "over": [[-75, 100], [-55, 100]], "force": [0, -1]},
                    {"type": "point_load", "over": [[55, 100], [75, 100]], "force": [0, -1]}]}],
                "gauges": {"deflection": {"type": "displacement", "over": [[-75, 100], [-55, 100]], "direction": [0, -1]}},
                "path": {"stop": {"load_below": 0.1}},
                "motion": {"time": 0.4, "contact": {"friction": 0.5}, "loads": "drop"}}


class Then(Scratch):
    """`path.then`: what comes after a path."""

    def test_offers_to_let_a_mechanism_go_and_does_so(self):
        run = ddapath.run(pushed_block(), folder=self.folder)
        self.assertAlmostEqual(run.summary["peak"]["load"] / (0.5 * 24525), 1, delta=1e-6)
        self.assertTrue(any("path.then: motion" in notice for notice in run.summary["notices"]), run.summary["notices"])
        self.assertNotIn("motion", run.summary)
        said = subprocess.run([str(ddapath.find_program()), "resume", str(self.folder), "--set", "path.then=motion", "--set",
                               "motion.held=[ground]", "--set", "motion.time=0.5", "--set", "motion.push=0.2", "--quiet"],
                              capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        run = ddapath.read_run(self.folder)
        motion = run.summary["motion"]
        self.assertTrue(motion["handover"]["is_pushed"])
        # A push of a fifth of μ m g: x = ½ 0.2 μ g t².
        way = run.motion.curve.x.iloc[-1] - run.curve.x.iloc[-1]
        self.assertAlmostEqual(way / (0.5 * 0.2 * 0.5 * 9.81 * 0.5**2), 1, delta=0.01)
        self.assertEqual(self.refused(self.folder), [])

    def test_a_weight_that_acts_twice_is_told(self):
        """As a load of the path, which is kept, and as gravity."""
        for gravity in (0, -9.81):
            deck = pushed_block(motion={"held": ["ground"], "gravity": [0, gravity], "time": 0.01})
            notices = ddapath.run(deck, folder=self.folder, overwrite=True).summary["notices"]
            self.assertEqual(any("with 1 times its weight already" in notice for notice in notices), gravity != 0, notices)

    def test_needs_no_section_and_may_leave_one(self):
        path = {"stop": {"gauges": {"x": 0.01}}, "then": "motion"}
        run = ddapath.run(pushed_block(path=path), {"motion.held": ["ground"], "motion.loads": "drop"}, folder=self.folder)
        self.assertTrue(run.summary["motion"]["is_at_rest"], run.summary["reason"])
        left = ddapath.run(pushed_block(path=path | {"then": "end"}, motion={"held": ["ground"]}), folder=self.folder,
                           overwrite=True)
        self.assertNotIn("motion", left.summary)

    def test_needs_a_friction_where_interfaces_tell_none(self):
        deck = pushed_block(motion={"held": ["ground"]})
        deck["interfaces"]["bed"]["law"] = {"type": "linear_softening", "tensile_strength": 1e6, "fracture_energy": 100}
        with self.assertRaises(ddapath.InputError) as refused:
            ddapath.run(deck, folder=self.folder)
        self.assertIn("motion.contact.friction", str(refused.exception))


class Prestressed(Scratch):
    """A stress without strain is in equilibrium before and after, and turns with its block."""

    def test_a_bonded_wall_stands_as_on_the_path(self):
        for treatment in ("consistent", "penalty"):
            deck = {"units": {"length": "m", "force": "N"}, "thickness": 1, "materials": {"rock": dict(ROCK)},
                    "scene": {"type": "polygons", "regions": [{"material": "rock", "vertices": box(0, 0, 4, 1)}],
                              "subdivision": {"type": "voronoi", "size": 0.4}},
                    "interfaces": {"joint": {"between": ["rock", "rock"], "law": "bonded", "treatment": treatment}},
                    "supports": {"low": {"at": [0, 0], "fix": "xy"}, "high": {"at": [0, 1], "fix": "xy"}},
                    "stages": [{"name": "stress", "loads": [{"type": "initial_stress", "xx": 3e6, "xy": 1e6}]},
                               {"name": "weight", "loads": [{"type": "body_force", "force": [0, -24525]}]}],
                    "gauges": {"tip": {"type": "displacement", "at": [4, 0.5], "direction": [1, 0]},
                               "drop": {"type": "displacement", "at": [4, 0.5], "direction": [0, 1]}},
                    "path": {"control": "load", "stop": {"load_factor_above": 1}},
                    "motion": {"time": 0.02, "stop_at_rest": False, "contact": {"friction": 0.5}}}
            run = ddapath.run(deck, folder=self.folder, overwrite=True)
            for gauge in ("tip", "drop"):
                end, moved = run.curve[gauge].iloc[-1], run.motion.curve[gauge]
                self.assertLess(abs(moved / end - 1).max(), 5e-3, (treatment, gauge))
            # What a first-order state misses in finite rotation is of second order in it.
            self.assertLess(abs(run.summary["motion"]["handover"]["released_energy"]), 1e-3 * run.curve.stored_energy.iloc[-1])


def cantilever(**damping):
    """A console of 10 × 1 m, let go under its weight: it swings about where that would leave it."""
    return {"units": {"length": "m", "force": "N"}, "thickness": 1, "materials": {"rock": dict(ROCK)},
            "scene": {"type": "polygons", "regions": [{"material": "rock", "vertices": box(0, 0, 10, 1)}],
                      "subdivision": {"type": "grid", "columns": 20, "rows": 2}},
            "supports": {"low": {"at": [0, 0], "fix": "xy"}, "high": {"at": [0, 1], "fix": "xy"}},
            "gauges": {"tip": {"type": "displacement", "at": [10, 0.5], "direction": [0, 1]}},
            "motion": {"time": 1.5, "stop_at_rest": False, "integrator": "trapezoidal", "step": 0.005, "gravity": [0, -9.81],
                       "contact": {"friction": 0}, "damping": damping}}


class Damped(Scratch):
    """The first vibration of a console, ω ≈ 36/s, loses what its damping ratio (a/ω + b ω)/2 says."""

    def ratio(self, **damping):
        run = ddapath.run(cantilever(**damping), folder=self.folder, overwrite=True)
        curve = run.motion.curve
        tip = curve.tip.to_numpy()
        (high, _), (low, _) = (find_peaks(sign * tip, prominence=np.ptp(tip) / 20) for sign in (1, -1))
        spans = [tip[h] - tip[l] for l, h in zip(low, high)]
        period = np.mean(np.diff(curve.time[low]))
        decrement = np.polyfit(range(len(spans)), np.log(spans), 1)[0]
        balance = curve[["kinetic_energy", "stored_energy", "viscous_damping", "friction", "fracture", "impact", "numerical_damping",
                         "energy_error"]].sum(axis=1) - curve.external_work
        self.assertLess(abs(balance - balance.iloc[0]).max(), 1e-6 * curve.kinetic_energy.max())
        return -decrement / (2 * np.pi), 2 * np.pi / period

    def test_by_mass_and_by_stiffness(self):
        free, omega = self.ratio()
        self.assertAlmostEqual(free, 0, delta=1e-3)
        for damping in ({"mass": 0.06 * omega}, {"stiffness": 0.06 / omega}):
            ratio, _ = self.ratio(**damping)
            self.assertAlmostEqual(ratio / 0.03, 1, delta=0.03, msg=str(damping))

    def test_refused_where_nothing_has_a_velocity(self):
        with self.assertRaises(ddapath.InputError) as refused:
            ddapath.run(cantilever(mass=1), {"motion.integrator": "settle"}, folder=self.folder)
        self.assertIn("motion.damping", str(refused.exception))


class ByInterface(Scratch):
    def test_fracture_adds_up(self):
        deck = ddapath.read_deck(Path(__file__).resolve().parents[2] / "studies" / "falling-beam" / "deck.yaml")
        run = ddapath.run(deck, {"scene.subdivision.size": 50, "motion.time": 0.06}, folder=self.folder)
        curve = run.motion.curve
        self.assertGreater(curve.fracture.iloc[-1], 0)
        self.assertLess(abs(curve.fracture - curve.fracture_ligament).max(), 1e-12 * curve.fracture.iloc[-1])
        handover = run.summary["motion"]["handover"]
        self.assertLess(abs(handover["released_energy"]), 1e-2 * run.curve.stored_energy.max())

    def test_a_beam_of_second_order_stays_under_the_load_it_has_borne(self):
        """Its bodies bend less easily: they begin in an equilibrium of their own, and swing at a frequency of their own when let go."""
        deck = {"units": {"length": "mm", "force": "N"}, "thickness": 10, "kinematics": {"type": "second_order"},
                "scene": {"regions": [{"name": "beam", "material": "steel", "vertices": box(0, 0, 1000, 100)}],
                          "boundaries": {"left": [[0, 0], [0, 100]], "right": [[1000, 0], [1000, 100]]},
                          "subdivision": {"type": "grid", "columns": 10, "rows": 1}},
                "materials": {"steel": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0, "density": 2.4e-9}},
                "supports": {"clamp": {"boundary": "left", "fix": "xy"}},
                "stages": [{"name": "bend", "loads": [{"type": "edge_traction", "boundary": "right", "traction": [0, -0.01]}]}],
                "gauges": {"tip": {"type": "displacement", "at": [1000, 0], "direction": [0, 1]}},
                "path": {"then": "motion"},
                "motion": {"time": 0.0351, "loads": "keep", "integrator": "trapezoidal", "stop_at_rest": False, "step": 0.005,
                           "contact": {"friction": 0.5}}}
        kept = ddapath.run(deck, folder=self.folder, overwrite=True)
        self.assertTrue(any("second order" in notice for notice in kept.summary["notices"]))
        tip = kept.motion.curve.tip
        self.assertLess((tip.max() - tip.min()) / abs(tip.iloc[0]), 1e-3)
        exact = 10 * 1000**3 / (3 * 30000 * 10 * 100**3 / 12)
        self.assertTrue(0.6 * exact < -tip.iloc[0] < exact)
        let_go = ddapath.run(deck, {"motion.loads": "drop"}, folder=self.folder, overwrite=True).motion.curve
        self.assertAlmostEqual(let_go.tip.min() / tip.iloc[0], 1, delta=1e-2)
        self.assertLess(let_go.tip.max(), abs(tip.iloc[0]))
        times = let_go.time[let_go.tip.abs() > 0].to_numpy()
        spectrum = np.abs(np.fft.rfft(np.interp(np.linspace(0, times[-1], 4096), let_go.time, let_go.tip)))
        frequency = np.argmax(spectrum[1:]) + 1  # cycles in the time
        self.assertIn(frequency, (2, 3))  # 69 Hz of bodies of constant strain, 57 Hz of the beam: 2.4 and 2.0

    def test_what_is_driven_stays_where_it_was_driven(self):
        """Stiff springs hold it there, and store what they bear, not what moving back would take."""
        deck = pushed_wall(0.01, {"type": "friction", "friction_angle": 40}, points="vertices")
        deck["stages"][1]["loads"] = [{"type": "prescribed_displacement", "at": [0, 1.2], "direction": [1, 0]}]
        deck["motion"] |= {"loads": "keep", "time": 0.2}
        run = ddapath.run(deck, folder=self.folder)
        motion = run.motion.curve
        self.assertLess(motion.stored_energy.max(), run.curve.stored_energy.iloc[-1])
        self.assertLess(abs(motion.x - 0.01).max(), 1e-4)
        self.assertLess(motion.kinetic_energy.max(), 1e-3)
        self.assertEqual(self.refused(self.folder), [])

    def test_a_run_that_overwrites_leaves_no_motion_behind(self):
        deck = pushed_wall(0.002, {"type": "friction", "friction_angle": 40})
        ddapath.run(deck, folder=self.folder)
        self.assertTrue((self.folder / "motion").is_dir())
        ddapath.run(deck, {"path.then": "end"}, folder=self.folder, overwrite=True)
        self.assertFalse((self.folder / "motion").exists())
        self.assertEqual(self.refused(self.folder), [])

    def test_a_dry_wall_of_second_order_stays_where_friction_holds_it(self):
        deck = pushed_wall(1, {"type": "friction", "friction_angle": 40}) | {"kinematics": {"type": "second_order", "regions": ["wall"]}}
        deck["path"]["stop"] = {"load_factor_above": 0.1}
        deck["motion"]["loads"] = "keep"
        run = ddapath.run(deck, folder=self.folder)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertLess(run.motion.curve.x.abs().max(), 1e-3)

    def test_blocks_of_second_order_go_on_with_first(self):
        """What tears takes Gf times the ligament all the same; what the strain gradients held is told."""
        deck = ddapath.read_deck(Path(__file__).resolve().parents[2] / "studies" / "falling-beam" / "deck.yaml")
        run = ddapath.run(deck, {"kinematics": {"type": "second_order", "regions": ["left", "right"]},
                                 "scene.subdivision.size": 50, "interfaces.ligament.points": "gauss"}, folder=self.folder)
        motion = run.summary["motion"]
        self.assertTrue(motion["is_at_rest"])
        self.assertAlmostEqual((run.summary["dissipated_energy"] + motion["fracture"]) / (0.05 * 100 * 100), 1, delta=1e-4)
        self.assertNotIn("released_energy", motion["handover"])
        self.assertGreater(motion["handover"]["gradient_energy"], 0)
        self.assertLess(motion["handover"]["gradient_energy"], run.curve.stored_energy.iloc[-1])
        self.assertEqual([str(finding) for finding in verify(self.folder) if not finding.holds], [])


if __name__ == "__main__":
    unittest.main()
