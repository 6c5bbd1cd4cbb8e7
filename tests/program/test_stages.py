"""Stages whose loads are followed one after another, those before being held: against closed forms and superposition.

    test_stages.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import json
import math
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

import h5py
import numpy as np

import ddapath
from ddapath.run_folder import sealed
from ddapath.verify import verify
from program_case import ProgramCase

STUDIES = Path(__file__).resolve().parents[2] / "studies"
WIDTH, THICKNESS = 100.0, 10.0
PHI = math.radians(30)

# A cantilever of blocks that cannot part: displacements are linear in the loads.
PLATE = {
    "units": {"length": "mm", "force": "N"},
    "scene": {"regions": [{"name": "plate", "material": "c", "vertices": [[0, 0], [300, 0], [300, 100], [0, 100]]}],
              "boundaries": {"wall": [[0, 100], [0, 0]], "end": [[300, 0], [300, 100]], "top": [[300, 100], [0, 100]]},
              "subdivision": {"type": "voronoi", "blocks": 40}},
    "thickness": THICKNESS, "plane": "stress",
    "materials": {"c": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
    "interfaces": {"j": {"between": ["c", "c"], "law": "bonded"}},
    "supports": {"wall": {"boundary": "wall", "fix": "xy"}},
    "gauges": {"x": {"type": "displacement", "at": [300, 50], "direction": [1, 0]},
               "y": {"type": "displacement", "at": [300, 50], "direction": [0, 1]},
               "top": {"type": "displacement", "at": [150, 100], "direction": [0, 1]},
               "side": {"type": "displacement", "over": [[300, 0], [300, 100]], "direction": [0, 1]}},
    "record": {"fields_every": 1},
}
PULL = [{"type": "edge_traction", "boundary": "end", "traction": [1, 0.1]}]
PRESS = [{"type": "edge_traction", "boundary": "top", "traction": [0.2, -0.5]}]
WARM = [{"type": "initial_strain", "expansion": 1e-5, "temperature": "20 + x/10"}]
MOVE = [{"type": "prescribed_displacement", "over": [[300, 0], [300, 100]], "direction": [0, 1], "displacement": 0.2}]

# A block of stone on a bed; what presses it and what pushes it are stages.
BLOCK = {
    "units": {"length": "mm", "force": "N"},
    "scene": {"regions": [{"name": "base", "material": "s", "vertices": [[0, 0], [200, 0], [200, 50], [0, 50]]},
                          {"name": "block", "material": "s", "vertices": [[50, 50], [150, 50], [150, 100], [50, 100]]}],
              "curves": {"bed": [[50, 50], [150, 50]]},
              "boundaries": {"floor": [[0, 0], [200, 0]], "top": [[150, 100], [50, 100]]},
              "subdivision": {"type": "grid", "columns": 4, "rows": 2}},
    "thickness": THICKNESS, "plane": "stress",
    "materials": {"s": {"type": "linear_elastic", "young_modulus": 10000, "poisson_ratio": 0.2, "density": 2e-9}},
    "interfaces": {"bed": {"law": {"type": "friction", "friction_angle": 30}}},
    "supports": {"floor": {"boundary": "floor", "fix": "xy"}},
    "gauges": {"push": {"type": "displacement", "over": [[50, 50], [50, 100]], "direction": [1, 0]}},
    "record": {"fields_every": 1},
}
PRESSURE = [{"type": "edge_traction", "boundary": "top", "traction": [0, -1]}]
PUSH = [{"type": "point_load", "over": [[50, 50], [50, 100]], "force": [1, 0]}]
NORMAL = WIDTH * THICKNESS  # of one pressure [N]
SLIDES = NORMAL * math.tan(PHI)


def stage(name, loads, until=None, **more):
    out = {"name": name, **more}
    return out | ({"loads": loads} if loads else {}) | ({"until": until} if until else {})


def with_stages(deck, *stages, **settings):
    out = copy.deepcopy(deck) | {"stages": list(stages)}
    for section, entries in settings.items():
        out.setdefault(section, {}).update(entries)
    return out


class StageCase(ProgramCase):
    def followed(self, deck, name="run", **options):
        run = ddapath.run(deck, folder=self.folder / name, check=False, **options)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        return run

    def assert_verified(self, run):
        findings = verify(run.folder)
        self.assertEqual([f"{found.check}: {found.worst} at {found.place}" for found in findings if not found.holds], [])
        self.assertIn("loads of earlier stages are held", [found.check for found in findings])

    def last_fields(self, run):
        return run.fields(run.steps[-1])

    def assert_energies_balance(self, run, error=1e-8):
        self.assertLess(run.summary["energy_balance_error"], error)


class ElasticStructures(StageCase):
    """Displacements are the sum of those of each load alone, in whatever order; so is the work that is stored."""

    def alone(self, loads, factor):
        deck = with_stages(PLATE, stage("alone", loads, {"load_factor": factor}))
        return self.last_fields(self.followed(deck, f"alone-{len(list(self.folder.iterdir()))}"))

    def moved(self, fields):
        return fields.vertices[["displacement_x", "displacement_y"]].to_numpy()

    def compare(self, stages):
        """Of (loads, load factor): followed in this order and the other one, against the sum."""
        expected = sum(self.moved(self.alone(loads, factor)) for loads, factor in stages)
        energies = []
        for name, order in (("forth", stages), ("back", stages[::-1])):
            listed = [stage(f"stage {i}", loads, {"load_factor": factor}) for i, (loads, factor) in enumerate(order, start=1)]
            run = self.followed(with_stages(PLATE, *listed), name)
            np.testing.assert_allclose(self.moved(self.last_fields(run)), expected, atol=1e-10 * np.abs(expected).max())
            self.assert_energies_balance(run)
            self.assert_verified(run)
            energies.append(run.summary["stored_energy"])
            self.assertEqual([entry["load_factor"] for entry in run.summary["stages"]], [factor for _, factor in order])
        self.assertAlmostEqual(energies[0], energies[1], delta=1e-9 * energies[0])

    def test_two_loads(self):
        self.compare([(PULL, 3), (PRESS, 2)])

    def test_three_loads_of_which_one_is_of_strain(self):
        self.compare([(WARM, 1.5), (PULL, 3), (PRESS, 0.5)])

    def test_a_load_beyond_its_full_value_is_as_good_as_dead(self):
        dead = with_stages(PLATE, stage("dead", [PULL[0] | {"traction": [3, 0.3]}]), stage("live", PRESS, {"load_factor": 2}))
        held = with_stages(PLATE, stage("first", PULL, {"load_factor": 3}), stage("live", PRESS, {"load_factor": 2}))
        ends = [self.followed(deck, name).curve.iloc[-1] for name, deck in (("dead", dead), ("held", held))]
        for column in ("load", "load_factor", "x", "y", "top", "stored_energy"):
            self.assertAlmostEqual(ends[0][column], ends[1][column], delta=1e-11 * abs(ends[0][column]))

    def test_a_displacement_is_held_where_it_has_got(self):
        """Driven to 0.6 of 0.2 mm, then loaded: what it takes to hold it there is what bears the load."""
        goal = 0.6 * MOVE[0]["displacement"]
        run = self.followed(with_stages(PLATE, stage("drive", MOVE, {"load_factor": 0.6}), stage("press", PRESS, {"load_factor": 2})))
        first, last = (run.curve[run.curve.stage == number].iloc[-1] for number in (1, 2))
        self.assertAlmostEqual(first.side, goal, delta=2e-3 * goal, msg="but for the spring by which it is driven")
        ratio = last.driven / first.driven
        self.assertAlmostEqual((goal - last.side) / (goal - first.side), ratio, delta=2e-9 * ratio)  # equilibria are good to 1e-9
        pressed = 2 * PRESS[0]["traction"][1] * 300 * THICKNESS
        self.assertAlmostEqual(last["wall.y"] + last.driven, -pressed, delta=1e-8 * abs(pressed))
        self.assert_energies_balance(run)
        self.assert_verified(run)


class SlidingBlock(StageCase):
    """σ A = N on a bed of friction angle φ: it slides at N tan φ, whatever has led there."""
    stages = (stage("press", PRESSURE, {"load_factor": 1}),
              stage("push", PUSH, {"push": 0.05}),
              stage("press more", PRESSURE, {"load_factor": 1}),
              stage("push on", PUSH, {"push": 0.2}),
              stage("push back", None, {"push": -0.1}, unload=True))

    def test_it_slides_by_what_presses_it(self):
        run = self.followed(with_stages(BLOCK, *self.stages))
        curve = run.curve
        exact = 1e-9 * SLIDES
        of = {number: curve[curve.stage == number] for number in (1, 2, 3, 4)}
        self.assertEqual(sorted(curve.stage.unique()), [1, 2, 3, 4])
        self.assertAlmostEqual(of[2].load.max(), SLIDES, delta=exact)
        self.assertAlmostEqual(of[2].load.iloc[-1], SLIDES, delta=exact)
        self.assertAlmostEqual(of[2].push.iloc[-1], 0.05, delta=1e-9)
        self.assertAlmostEqual(of[3].load_factor.iloc[-1], 1, delta=1e-12)
        self.assertAlmostEqual(of[4].load.max(), SLIDES, delta=exact, msg="2 N tan φ, of which the first stage bears half")
        self.assertAlmostEqual(of[4].load.min(), -3 * SLIDES, delta=3 * exact, msg="back at −2 N tan φ")
        self.assertAlmostEqual(curve.push.iloc[-1], -0.1, delta=1e-9)
        self.assertAlmostEqual(curve["floor.y"].iloc[-1], 2 * NORMAL, delta=1e-9 * NORMAL)
        self.assertLess((curve.external_work - curve.stored_energy - curve.dissipated_energy).abs().max(),
                        2e-2 * curve.external_work.max())
        self.assert_verified(run)

    def test_the_summary_lists_the_stages(self):
        summary = self.followed(with_stages(BLOCK, *self.stages)).summary
        self.assertEqual([entry["number"] for entry in summary["stages"]], [1, 2, 3, 4])
        self.assertEqual([entry["name"] for entry in summary["stages"]], ["press", "push", "press more", "push on"])
        self.assertEqual([entry.get("reason") for entry in summary["stages"]],
                         ["load_factor reached 1", "push reached 0.05", "load_factor reached 1", None])
        self.assertAlmostEqual(summary["stages"][1]["load_factor"], SLIDES, delta=1e-9 * SLIDES)
        self.assertAlmostEqual(summary["stages"][1]["peak"]["load"], SLIDES, delta=1e-9 * SLIDES)
        self.assertAlmostEqual(summary["peak"]["load"], SLIDES, delta=1e-9 * SLIDES)

    def test_less_pressure_lets_it_slide(self):
        """Held at half of N tan φ it slides when half of the pressure is taken off."""
        half = 0.5 * SLIDES
        run = self.followed(with_stages(
            BLOCK, stage("press", PRESSURE, {"load_factor": 1}), stage("push", PUSH, {"load": half}),
            stage("lift", [PRESSURE[0] | {"traction": [0, 1]}], {"push": 0.05})))
        last = run.curve[run.curve.stage == 3]
        self.assertAlmostEqual(last.load_factor.max(), 0.5, delta=1e-9)
        self.assert_verified(run)

    def test_it_slides_back_against_what_pushes_it_still(self):
        """Nothing opens, and friction spends half of what the load does: the held push takes the other half."""
        run = self.followed(with_stages(BLOCK, stage("press", PRESSURE), stage("push", PUSH, {"push": 0.05}),
                                        stage("pull", [PUSH[0] | {"force": [-1, 0]}])))
        self.assertAlmostEqual(run.curve.load.iloc[-1] / SLIDES, 2, delta=1e-9)
        self.assertRegex(run.summary["reason"], "^slides as a mechanism .*, 0 are open")

    def test_motion_goes_on_with_what_is_held(self):
        """Let go as a mechanism, it moves as after dead loads of the same size."""
        sections = {"motion": {"time": 0.01, "held": ["base"], "stop_at_rest": False, "push": 0.2},
                    "path": {"stop": {"gauges": {"push": 0.05}}, "then": "motion"}}
        ways = []
        for name, first in (("dead", stage("press", PRESSURE)), ("held", stage("press", PRESSURE, {"load_factor": 1}))):
            run = self.followed(with_stages(BLOCK, first, stage("push", PUSH), **sections), name)
            ways.append(run.motion.curve.push.iloc[-1] - run.curve.push.iloc[-1])
        self.assertGreater(ways[0], 0)
        self.assertAlmostEqual(ways[0], ways[1], delta=1e-6 * ways[0])


class CrackedBeam(StageCase):
    """The beam of legs.yaml: past its peak, unloaded, and then loaded by a stage of its own with the same loads."""

    def beam(self):
        deck = ddapath.read_deck(Path(__file__).resolve().parent / "legs.yaml")
        deck["stages"] = deck["stages"][:2]
        deck["record"] = {"fields_every": 1}
        return deck

    def test_the_same_load_again_is_a_reloading_leg(self):
        deck = self.beam()
        loads = deck["stages"][0]["loads"]
        legs, stages = copy.deepcopy(deck), copy.deepcopy(deck)
        legs["stages"].append({"name": "again", "until": {"cmod": 0.06}})
        stages["stages"].append({"name": "again", "loads": loads, "until": {"cmod": 0.06}})
        one, other = self.followed(legs, "legs"), self.followed(stages, "stages")
        peak = one.curve.load.max()
        for column, scale in (("load", peak), ("deflection", 0.1), ("dissipated_energy", one.curve.dissipated_energy.max())):
            self.assertAlmostEqual(one.curve[column].iloc[-1], other.curve[column].iloc[-1], delta=1e-6 * scale)
        again = other.curve[other.curve.stage == 3]
        self.assertAlmostEqual(again.load.max(), one.curve.load[len(one.curve) - len(again):].max(), delta=2e-3 * peak)
        self.assert_verified(other)

    def test_another_load_after_unloading(self):
        """Pulled along its axis it is torn at less than the whole section bears."""
        deck = self.beam()
        deck["scene"]["boundaries"] = {"end": [[300, 0], [300, 100]]}
        deck["stages"].append({"name": "pull", "loads": [{"type": "edge_traction", "boundary": "end", "traction": [0.01, 0]}]})
        run = self.followed(deck)
        pull = run.curve[run.curve.stage == 3]
        self.assertGreater(pull.load.max(), 0)
        self.assertLess(pull.load.max(), 3 * 70 * 100, "ft times the ligament and the thickness")
        self.assertAlmostEqual(pull.load.iloc[-1], 0.1 * pull.load.max(), delta=1e-6 * pull.load.max())
        self.assertLess(run.summary["energy_balance_error"], 0.02)
        self.assert_verified(run)


class ResumedCase(StageCase):
    """`begin` follows a deck to its end; parts of it may then be compared with that."""

    def begin(self, deck):
        (self.folder / "deck.yaml").write_text(json.dumps(deck))
        self.dda("run", "deck.yaml", "--folder", "whole", "--quiet")
        self.whole = (self.folder / "whole" / "curve.csv").read_text()

    def ends_of_stages(self):
        summary = json.loads((self.folder / "whole" / "summary.json").read_text())
        return [entry["end"] for entry in summary["stages"]]

    def resume_after(self, steps):
        """A run that has been stopped after so many steps, and gone on with."""
        name = f"part{steps}"
        self.dda("run", "deck.yaml", "--folder", name, "--quiet", "--overwrite", "--set", f"path.stop.after_steps={steps}")
        self.dda("resume", name, "--quiet", "--set", "path.stop.after_steps=0")
        self.assertEqual((self.folder / name / "curve.csv").read_text(), self.whole, name)
        return name

    def resume_killed_after(self, rows):
        """The same of one that is killed some rows later."""
        name = f"killed{rows}"
        self.dda("run", "deck.yaml", "--folder", name, "--quiet", "--set", f"path.stop.after_steps={rows}")
        run = subprocess.Popen([str(ddapath.find_program()), "resume", name, "--quiet", "--set", "path.stop.after_steps=0"],
                               cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        curve = self.folder / name / "curve.csv"
        for _ in range(400):
            if len(curve.read_text().splitlines()) > rows + 3 or run.poll() is not None:
                break
            time.sleep(0.005)
        run.send_signal(signal.SIGKILL)
        run.wait()
        self.dda("resume", name, "--quiet", "--set", "path.stop.after_steps=0")
        self.assertEqual(curve.read_text(), self.whole, name)
        self.assertEqual(verify_failures(self.folder / name), [])

    def assert_same_fields(self, name):
        for file in sorted((self.folder / "whole" / "fields").glob("[0-9]*.h5")):
            with h5py.File(file) as one, h5py.File(self.folder / name / "fields" / file.name) as other:
                self.assertEqual({key: value for key, value in one.attrs.items()}, {key: value for key, value in other.attrs.items()})
                for key in (key for key in one if isinstance(one[key], h5py.Dataset)):
                    np.testing.assert_array_equal(one[key][()], other[key][()], err_msg=f"{file.name}: {key}")


class GoingOn(ResumedCase):
    """A run that is stopped or killed anywhere, and resumed, is the run that was left alone, to the last bit."""

    def test_a_block_around_the_ends_of_its_stages(self):
        self.begin(with_stages(BLOCK, *SlidingBlock.stages))
        refused = self.dda("resume", "whole", "--quiet", "--set", f"stages=[{json.dumps(stage('press', PRESSURE))}]", code=2)
        self.assertIn("the run has gone through more stages than there are now", refused)
        for end in self.ends_of_stages()[:-1]:
            for steps in (end - 1, end, end + 1, end + 3):
                self.assert_same_fields(self.resume_after(steps))

    def test_a_block_killed_in_its_second_stage_and_later(self):
        self.begin(with_stages(BLOCK, *SlidingBlock.stages))
        first, second, third, _ = self.ends_of_stages()
        for rows in (first + 3, second + 2, third + 4):
            self.resume_killed_after(rows)

    def test_a_mortar_wall_pressed_sheared_pressed_more_and_sheared_back(self):
        deck = {"extends": str(STUDIES / "held-loads" / "mortar.yaml"), "record": {"fields_every": 10}}
        self.begin(deck)
        run = ddapath.read_run(self.folder / "whole")
        curve = run.curve
        self.assertEqual(run.summary["status"], "goal_reached")
        self.assert_verified(run)
        self.assert_energies_balance(run, 0.01)
        self.assertLess((curve.external_work - curve.stored_energy - curve.dissipated_energy).abs().max(), 0.01 * curve.external_work.max())
        pushed, more, _ = self.ends_of_stages()
        self.resume_killed_after(pushed + 10)
        self.resume_killed_after(more + 5)

    def test_cracks_through_blocks(self):
        """Under a load, unloaded, under another one, and then warmed: the crack runs on in each of them."""
        deck = ddapath.read_deck(Path(__file__).resolve().parent / "cracked_beam.yaml")
        beside = [{"type": "point_load", "over": [[190, 100], [210, 100]], "force": [0, -1]}]
        warm = [{"type": "initial_strain", "expansion": 1e-5, "temperature": "-y/10"}]
        deck["stages"] = [deck["stages"][0] | {"until": {"cmod": 0.008}}, stage("unloading", None, {"load": 2500}, unload=True),
                          stage("beside", beside, {"cmod": 0.014}), stage("warmed", warm)]
        deck["record"], deck["path"] = {"fields_every": 2}, {"stop": {"gauges": {"cmod": 0.016}, "load_below": 0}}
        self.begin(deck)
        run = ddapath.read_run(self.folder / "whole")
        self.assertEqual(run.summary["reason"], "cmod reached 0.016")
        self.assert_verified(run)
        self.assertEqual(sorted(run.curve.stage.unique()), [1, 3, 4])
        spent = [run.curve[run.curve.stage == number].dissipated_energy.iloc[-1] for number in (1, 3, 4)]
        self.assertEqual(spent, sorted(set(spent)), "each stage spends something")
        first, second, _ = self.ends_of_stages()
        for steps in (first, first + 2, second, second + 2):
            self.resume_after(steps)


def verify_failures(folder):
    return [found.check for found in verify(folder) if not found.holds]


class Doctored(StageCase):
    """`dda verify` refuses a run whose held loads are others than those that were reached."""

    def setUp(self):
        super().setUp()
        self.run_ = self.followed(with_stages(BLOCK, *SlidingBlock.stages))

    def doctored(self):
        shutil.rmtree(self.folder / "copy", ignore_errors=True)
        shutil.copytree(self.run_.folder, self.folder / "copy")
        return self.folder / "copy"

    def test_a_load_factor_that_was_not_held(self):
        copied = self.doctored()
        file = sorted((copied / "fields").glob("[0-9]*.h5"))[-1]
        with h5py.File(file, "a") as stored:
            stored.attrs["load_factor_2"] *= 1.01
        file.write_bytes(sealed(file.read_bytes()))
        refused = verify_failures(copied)
        self.assertIn("loads of earlier stages are held", refused)
        self.assertIn("block equilibrium", refused)
        self.dda("verify", "copy", code=3)

    def test_a_summary_with_another_load_factor(self):
        copied = self.doctored()
        summary = json.loads((copied / "summary.json").read_text())
        summary["stages"][1]["load_factor"] *= 1.001
        (copied / "summary.json").write_text(json.dumps(summary))
        self.assertEqual(verify_failures(copied), ["loads of earlier stages are held"])

    def test_rows_of_another_stage(self):
        copied = self.doctored()
        file = copied / "curve.csv"
        rows = [line.split(",") for line in file.read_text().splitlines()]
        at = rows[0].index("stage")
        last = max(i for i, row in enumerate(rows) if row[at] == "1")
        rows[last][at] = "2"
        file.write_text("\n".join(",".join(cells) for cells in rows) + "\n")
        self.assertIn("loads of earlier stages are held", verify_failures(copied))


if __name__ == "__main__":
    unittest.main()
