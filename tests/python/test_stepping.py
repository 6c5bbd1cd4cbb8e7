"""Paths followed point by point: the numbers of `dda run`, arrays that look at them, steering, errors, Ctrl-C."""

import os
import signal
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

import ddapath

DECK = Path(__file__).resolve().parents[1] / "program" / "beam.yaml"
SHORT = {"path.stop.load_below": 0.7}
SAME = ("load_factor", "load", "dissipated_energy", "stored_energy", "external_work")


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)


def numbers(point):
    return [point.step, point.control, point.load_factor, point.load, point.gauges["deflection"], point.gauges["cmod"],
            point.dissipated_energy, point.stored_energy, point.external_work, point.negative_eigenvalues]


class Following(Scratch):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.run_of_program = ddapath.run(DECK, SHORT, folder=Path(scratch.name) / "run")

    def test_the_points_are_those_of_the_program(self):
        curve = self.run_of_program.curve.iloc[1:]
        for _ in range(2):  # one after another in one process
            points = list(ddapath.follow(DECK, SHORT))
            self.assertEqual([point.step for point in points], curve["step"].tolist())
            self.assertEqual([point.control for point in points], curve["control"].tolist())
            self.assertEqual([point.iterations for point in points], curve["newton_iterations"].tolist())
            self.assertEqual([point.gauges["cmod"] for point in points], curve["cmod"].tolist())
            for name in SAME:
                self.assertEqual([getattr(point, name) for point in points], curve[name].tolist(), name)

    def test_points_know_their_stage(self):
        deck = ddapath.read_deck(DECK)
        one = deck["stages"][-1]
        deck["stages"] = [{**one, "name": "half", "until": {"load_factor": 100}}, {**one, "name": "on"}]
        settings = {"path.stop.after_steps": 4}
        theirs = ddapath.run(deck, settings, folder=self.folder / "run").curve
        points = list(ddapath.follow(deck, settings))
        self.assertEqual([point.stage for point in points], theirs["stage"].tolist()[1:])
        self.assertEqual({point.stage for point in points}, {1, 2})
        self.assertEqual({point.stage for point in ddapath.follow(DECK, settings)}, {len(ddapath.read_deck(DECK)["stages"])})

    def test_loads_may_change_on_the_way(self):
        """As a deck that has the same stages: the first is held where the loop has changed the loads."""
        deck, settings = ddapath.read_deck(DECK), {"path.stop.after_steps": 4}
        first = deck["stages"][-1]
        more = [load | {"force": [1000, -500]} for load in first["loads"]]
        path, before = ddapath.follow(deck, {"path.stop.steps": 50}), None
        for point in path:
            if point.step == 1:
                before = point
                path.load(*more, name="more")
            if point.step == 5:
                break
        deck["stages"] = deck["stages"][:-1] + [first | {"until": {"load_factor": before.load_factor}},
                                               {"name": "more", "loads": more}]
        theirs = list(ddapath.follow(deck, {"path.stop.steps": 5}))
        self.assertEqual([point.stage for point in theirs][-1], point.stage)
        for name in SAME:
            self.assertAlmostEqual(getattr(theirs[-1], name), getattr(point, name), delta=1e-9 * abs(getattr(point, name)), msg=name)
        with self.assertRaisesRegex(ddapath.InputError, "did you mean 'point_load'"):
            path.load({"type": "pointload", "at": [0, 0], "force": [1, 0]})
        with self.assertRaisesRegex(ddapath.InputError, "drives what an earlier stage has driven"):
            path.load({"type": "prescribed_displacement", "at": more[0].get("at", [0, 100]), "direction": [0, 1]})

    def test_loads_may_change_again_and_again(self):
        path = ddapath.follow(DECK, {"path.stop.steps": 50})
        next(path)
        load = ddapath.read_deck(DECK)["stages"][-1]["loads"][0]
        stages = []
        for push in (10, 20, 30):
            path.load(load | {"force": [push, 0]})
            stages.append(next(path).stage)
        self.assertEqual(stages, [stages[0], stages[0] + 1, stages[0] + 2])
        with self.assertRaisesRegex(ddapath.InputError, "applies no load"):
            path.load(load | {"force": [0, 0]})
        self.assertEqual(next(path).stage, stages[-1])

    def test_a_path_is_one_thread_s_at_a_time(self):
        """Another thread that asks for a point meanwhile is refused, and nothing is lost."""
        path, found, refused = ddapath.follow(DECK, SHORT), [], []

        def take():
            while True:
                try:
                    found.append(next(path).step)
                except StopIteration:
                    return
                except RuntimeError as error:
                    refused.append(str(error))

        threads = [threading.Thread(target=take) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(sorted(found), [point.step for point in ddapath.follow(DECK, SHORT)])
        self.assertLessEqual(set(refused), {"another thread follows this path at the moment: a path is for one at a time"})

    def test_a_folder_is_that_of_the_program(self):
        path = ddapath.follow(DECK, SHORT, folder=self.folder / "run")
        count = sum(1 for _ in path)
        self.assertEqual((path.status, path.run.status), ("goal_reached", "goal_reached"))
        theirs = self.run_of_program
        for name in ("curve.csv", "curve.units.json", "effective_deck.yaml", "deck.yaml", "curve.svg"):
            self.assertEqual((path.run.folder / name).read_bytes(), (theirs.folder / name).read_bytes(), name)
        self.assertEqual(path.run.steps, theirs.steps)
        self.assertEqual(path.run.summary["peak"], theirs.summary["peak"])
        self.assertEqual(count, theirs.summary["steps"])
        with self.assertRaisesRegex(ddapath.InputError, "is not empty"):
            ddapath.follow(DECK, SHORT, folder=self.folder / "run")
        ddapath.follow(DECK, SHORT, folder=self.folder / "run", overwrite=True).close()

    def test_nothing_is_written_without_a_folder(self):
        before = sorted(Path.cwd().iterdir())
        path = ddapath.follow(DECK, {"path.stop.after_steps": 3})
        self.assertEqual(len(list(path)), 3)
        self.assertEqual(sorted(Path.cwd().iterdir()), before)
        with self.assertRaisesRegex(ValueError, "no run folder"):
            path.run  # noqa: B018

    def test_a_dictionary_and_threads(self):
        deck = ddapath.read_deck(DECK)
        deck["path"]["stop"]["load_below"] = np.float64(0.7)
        one, two = ([numbers(point) for point in ddapath.follow(deck, threads=count)] for count in (1, 2))
        self.assertEqual(one, two)
        self.assertEqual([row[2] for row in one], self.run_of_program.curve["load_factor"].tolist()[1:])

    def test_fields_are_those_that_the_program_stores(self):
        theirs = self.run_of_program
        kept = {point.step: point for point in ddapath.follow(DECK, SHORT)}
        self.assertGreater(len(theirs.steps), 2)
        for step in set(theirs.steps) & set(kept):
            table, point = theirs.fields(step).points, kept[step]
            np.testing.assert_array_equal(point.openings, table[["opening_n", "opening_s"]])
            np.testing.assert_array_equal(point.tractions, table[["traction_n", "traction_s"]])
            np.testing.assert_array_equal(point.jumps, table[["jump_n", "jump_s"]])
            np.testing.assert_array_equal(point.damage, table["damage"])
            moved = theirs.fields(step).vertices[["displacement_x", "displacement_y"]]
            np.testing.assert_array_equal(point.outlines["displacements"], moved)
            strains = theirs.fields(step).blocks[["strain_xx", "strain_yy", "strain_2xy"]]
            np.testing.assert_array_equal(point.displacements[:, 3:], strains)
        self.assertGreater(max(kept[step].damage.max() for step in kept), 0.5)

    def test_arrays_look_at_numbers_that_stay(self):
        path = ddapath.follow(DECK, SHORT)
        first = next(path)
        values, copy, damage = first.displacements, first.displacements.copy(), first.damage.copy()
        self.assertTrue(np.shares_memory(values, first.unknowns))
        self.assertTrue(np.shares_memory(first.openings, first.openings))
        self.assertFalse(values.flags.owndata)
        for array in (values, first.openings, first.tractions, first.damage):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[0] = 1
        for last in path:
            pass
        np.testing.assert_array_equal(values, copy)
        np.testing.assert_array_equal(first.damage, damage)
        self.assertFalse(np.array_equal(last.displacements, copy))
        del path, first, last
        np.testing.assert_array_equal(values, copy)


class Steering(Scratch):
    def test_stop(self):
        path = ddapath.follow(DECK, folder=self.folder / "run")
        for point in path:
            if point.step == 4:
                path.stop("far enough")
        self.assertEqual((path.status, path.reason), ("goal_reached", "far enough"))
        self.assertEqual(path.run.curve["step"].tolist(), [0, 1, 2, 3, 4])
        self.assertEqual(list(path), [])

    def test_a_loop_that_is_left_is_gone_on_with(self):
        whole = ddapath.run(DECK, SHORT, folder=self.folder / "whole")
        with ddapath.follow(DECK, SHORT, folder=self.folder / "part") as path:
            for point in path:
                if point.step == 6:
                    break
        self.assertEqual(path.run.status, "interrupted")
        again = ddapath.resume(path.run.folder)
        self.assertEqual(again.status, "goal_reached")
        self.assertEqual((again.folder / "curve.csv").read_bytes(), (whole.folder / "curve.csv").read_bytes())

    def test_the_next_step(self):
        path = ddapath.follow(DECK, {"path.control": {"type": "opening", "gauge": "cmod"}})
        self.assertEqual(path.next_step, 0)
        with self.assertRaisesRegex(ValueError, "path.step.first"):
            path.next_step = 1e-3
        opened, steps = [0.0], []
        for point in path:
            opened.append(point.gauges["cmod"])
            if point.step == 8:
                path.next_step = path.next_step / 50
            steps.append(path.next_step)
            if point.step == 10:
                break
        before, first, second = np.diff(opened)[-3:]
        self.assertLess(first, before / 20)
        self.assertAlmostEqual(second / first, steps[-2] / steps[-3], delta=0.01)  # both along the same tangent, nearly
        with self.assertRaisesRegex(ValueError, "larger than 0"):
            path.next_step = 0

    def test_another_control(self):
        path = ddapath.follow(DECK, {"path.control": {"type": "opening", "gauge": "cmod"}, **SHORT})
        controls = []
        for point in path:
            controls.append(point.control)
            if point.step == 5:
                path.control = "arc_length"
        self.assertEqual(path.status, "goal_reached", path.reason)
        self.assertIn("opening", controls[:5])
        self.assertIn("arc_length", controls[5:])
        self.assertNotIn("opening", controls[5:])
        self.assertEqual(path.control, "arc_length")

    def test_another_control_is_kept_by_a_restart(self):
        settings = {"path.control": {"type": "opening", "gauge": "cmod"}, **SHORT}
        with ddapath.follow(DECK, settings, folder=self.folder / "run") as path:
            for point in path:
                if point.step == 3:
                    path.control = "arc_length"
                if point.step == 5:
                    break
        run = ddapath.resume(self.folder / "run")
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertIn("opening", run.curve["control"][:4].tolist())
        self.assertIn("arc_length", run.curve["control"][5:].tolist())
        self.assertNotIn("opening", run.curve["control"][4:].tolist())
        self.assertIn("arc_length", str(run.deck["path"]["control"]))

    def test_a_control_that_there_is_not(self):
        path = ddapath.follow(DECK, {"path.stop.after_steps": 3})
        before = path.control
        with self.assertRaisesRegex(ddapath.InputError, "did you mean 'arc_length'"):
            path.control = "arc_lenght"
        with self.assertRaisesRegex(ddapath.InputError, "cmodd"):
            path.control = {"type": "opening", "gauge": "cmodd"}
        self.assertEqual(path.control, before)
        self.assertEqual(len(list(path)), 3)


class Matrices(Scratch):
    def test_stiffness_load_and_residual(self):
        path = ddapath.follow(DECK, SHORT)
        intact = path.stiffness()
        self.assertLess(abs(intact - intact.T).max(), 1e-13 * abs(intact).max())
        first = next(path)
        load = path.load_vector()
        np.testing.assert_allclose(intact @ first.unknowns, load, atol=1e-9 * abs(load).max())
        np.testing.assert_allclose(load, first.load_factor * path.reference_load(), rtol=1e-14)
        for point in path:
            self.assertLess(abs(path.residual()).max(), 1e-6 * abs(path.load_vector()).max(), point)
        self.assertGreater(abs(path.stiffness() - intact).max(), 1)

    def test_modes(self):
        for point in (path := ddapath.follow(DECK, SHORT)):
            pass
        values, shapes = path.modes(4, "none")
        self.assertEqual(shapes.shape, (4, len(point.unknowns)))
        np.testing.assert_allclose(shapes @ shapes.T, np.eye(4), atol=1e-6)
        self.assertEqual(int((values < 0).sum()), point.negative_eigenvalues)
        stiffness = path.stiffness()
        for value, shape in zip(values, shapes):
            self.assertLess(abs(stiffness @ shape - value * shape).max(), 1e-6 * abs(stiffness).max())
        with self.assertRaisesRegex(ValueError, "'none', 'unit' or 'density'"):
            path.modes(4, "nothing")
        with self.assertRaisesRegex(ddapath.InputError, "modes: material 'concrete' needs a `density`"):
            path.modes(4, "density")


class Errors(Scratch):
    def test_of_a_file(self):
        deck = self.folder / "deck.yaml"
        deck.write_text(DECK.read_text(encoding="utf-8").replace("tensile_strength: 3", "tensile_strengt: 3"), encoding="utf-8")
        with self.assertRaisesRegex(ddapath.InputError, "deck.yaml:14:.*did you mean 'tensile_strength'") as caught:
            ddapath.follow(deck)
        place, what = caught.exception.findings[0]
        self.assertTrue(place.startswith(f"{deck}:14:"), place)
        self.assertIn("tensile_strengt", what)
        with self.assertRaisesRegex(ddapath.NotFound, "nowhere.yaml"):
            ddapath.follow("nowhere.yaml")

    def test_of_a_dictionary(self):
        deck = ddapath.read_deck(DECK)
        deck["interfaces"]["any"]["law"]["tensile_strength"] = -3
        deck["supports"]["left"]["fixx"] = "x"
        with self.assertRaises(ddapath.InputError) as caught:
            ddapath.follow(deck)
        self.assertEqual({place for place, _ in caught.exception.findings},
                         {"deck: interfaces.any.law.tensile_strength", "deck: supports.left.fixx"})

    def test_a_deck_without_a_path(self):
        deck = ddapath.read_deck(DECK)
        del deck["stages"], deck["path"], deck["record"]
        deck["motion"] = {"time": 1}
        with self.assertRaisesRegex(ddapath.InputError, "no `stages`"):
            ddapath.follow(deck)


class Interrupted(Scratch):
    def test_ctrl_c(self):
        whole = [numbers(point) for point in ddapath.follow(DECK, SHORT)]
        path = ddapath.follow(DECK, folder=self.folder / "run")
        points = [next(path) for _ in range(3)]
        timer = threading.Timer(0.02, os.kill, (os.getpid(), signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            while True:
                points.append(next(path))
        self.assertTrue(path.has_ended)
        path.close()
        self.assertEqual(path.run.status, "interrupted")
        self.assertEqual([numbers(point) for point in points], whole[:len(points)])
        self.assertEqual([numbers(point) for point in ddapath.follow(DECK, SHORT)], whole)
        self.assertEqual(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        again = ddapath.resume(path.run.folder, SHORT)
        self.assertEqual(again.curve["load"].tolist()[1:], [row[3] for row in whole])


if __name__ == "__main__":
    unittest.main()
