"""Starting the program: results, and its messages as errors."""

import os
import stat
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import ddapath

DECK = Path(__file__).resolve().parents[1] / "program" / "beam.yaml"


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def stand_in(self, script):
        """DDA is a script instead of the program."""
        file = self.folder / "stand-in"
        file.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        file.chmod(file.stat().st_mode | stat.S_IXUSR)
        environment = mock.patch.dict(os.environ, {"DDA": str(file)})
        environment.start()
        self.addCleanup(environment.stop)


class Finding(Scratch):
    def test_what_the_environment_names(self):
        self.stand_in("exit 0")
        self.assertEqual(ddapath.find_program(), str(self.folder / "stand-in"))

    def test_what_the_environment_names_wrongly(self):
        with mock.patch.dict(os.environ, {"DDA": "/no/such/dda"}):
            with self.assertRaisesRegex(ddapath.ProgramNotFound, "DDA is '/no/such/dda', which is no program"):
                ddapath.find_program()

    def test_none_at_all(self):
        with mock.patch.dict(os.environ, {"DDA": "", "PATH": ""}), \
                mock.patch("ddapath.program.CHECKOUT", self.folder):
            with self.assertRaisesRegex(ddapath.ProgramNotFound, "install it, put it on the PATH, or set DDA to its path"):
                ddapath.find_program()
            (self.folder / "bootstrap").touch()
            with self.assertRaisesRegex(ddapath.ProgramNotFound, "build it with .*/bootstrap build, put it"):
                ddapath.find_program()

    def test_what_came_with_the_package(self):
        for package, program in (("lib/site-packages/ddapath", "lib/site-packages/ddapath/installation/bin/dda"),
                                 ("usr/share/ddapath/python/ddapath", "usr/bin/dda"),
                                 ("checkout/python/ddapath", "checkout/build/release/bin/dda")):
            file = self.folder / program
            file.parent.mkdir(parents=True)
            file.write_text("#!/bin/sh\n", encoding="utf-8")
            file.chmod(0o755)
            here = self.folder / package
            with mock.patch.dict(os.environ, {"DDA": ""}), mock.patch("ddapath.program.PACKAGE", here), \
                    mock.patch("ddapath.program.CHECKOUT", here.parents[1]):
                self.assertEqual(ddapath.find_program(), str(file))


class Running(Scratch):
    def test_plugins_are_handed_on(self):
        self.stand_in('echo "$@"; exit 2')
        for start in (ddapath.run, ddapath.sweep):
            with self.assertRaisesRegex(ddapath.InputError, "--plugin=a.so --plugin=b.so"):
                start(DECK, folder=self.folder / "run", plugins=["a.so", Path("b.so")])

    def test_a_file_with_settings(self):
        run = ddapath.run(DECK, {"path.stop.load_below": 0.8, "supports.left.at": np.array([1.0, 0])},
                          folder=self.folder / "run")
        self.assertEqual((run.status, run.folder), ("goal_reached", self.folder / "run"))
        self.assertEqual(run.deck["supports"]["left"]["at"], [1, 0])

    def test_a_dictionary(self):
        deck = ddapath.read_deck(DECK) | {"title": "on: 1e5"}
        deck["path"]["stop"]["load_below"] = np.float64(0.8)
        run = ddapath.run(deck, folder=self.folder / "run")
        self.assertEqual(run.deck["title"], "on: 1e5")
        with self.assertRaisesRegex(ValueError, "give a folder"):
            ddapath.run(deck)

    def test_wrong_input_has_the_message_and_leaves_nothing(self):
        with self.assertRaisesRegex(ddapath.InputError, "did you mean 'tensile_strength'") as caught:
            ddapath.run(DECK, {"interfaces.any.law.tensile_strengt": 3}, folder=self.folder / "run")
        self.assertEqual(caught.exception.exit_code, 2)
        self.assertFalse((self.folder / "run").exists())

    def test_a_folder_that_is_taken(self):
        settings = {"path.stop.load_below": 0.8}
        ddapath.run(DECK, settings, folder=self.folder / "run")
        with self.assertRaisesRegex(ddapath.InputError, "is not empty"):
            ddapath.run(DECK, settings, folder=self.folder / "run")
        ddapath.run(DECK, settings, folder=self.folder / "run", overwrite=True)

    def test_stopped_early(self):
        settings = {"path.control": "load"}  # which ends at the limit point
        with self.assertRaises(ddapath.StoppedEarly) as caught:
            ddapath.run(DECK, settings, folder=self.folder / "run")
        self.assertIn("stopped early", str(caught.exception).replace("_", " "))
        self.assertEqual(caught.exception.results.status, "stopped_early")
        unchecked = ddapath.run(DECK, settings, folder=self.folder / "again", check=False)
        self.assertEqual(unchecked.summary["peak"], caught.exception.results.summary["peak"])

    def test_a_deck_that_is_not_there(self):
        with self.assertRaisesRegex(ddapath.NotFound, "nowhere.yaml: there is no such deck"):
            ddapath.run("nowhere.yaml")

    def test_a_number_that_is_none(self):
        with self.assertRaises(ValueError):
            ddapath.run(DECK, {"thickness": float("nan")}, folder=self.folder / "run")

    def test_other_ends(self):
        for script, error, message in (("echo no room >&2; exit 4", ddapath.OutputError, "no room"),
                                       ("exit 130", ddapath.Interrupted, "exit code 130"),
                                       ("kill -9 $$", ddapath.ProgramFailed, "exit code -9")):
            self.stand_in(script)
            with self.assertRaisesRegex(error, message):
                ddapath.run(DECK, folder=self.folder / "run")


class Going(Scratch):
    def test_resume(self):
        run = ddapath.run(DECK, {"path.stop.after_steps": 4}, folder=self.folder / "run")
        self.assertEqual(len(run.curve), 5)
        longer = ddapath.resume(run.folder, {"path.stop.after_steps": 7}, into=self.folder / "longer")
        self.assertEqual((len(run.curve), len(longer.curve)), (5, 8))
        self.assertEqual(longer.folder, self.folder / "longer")
        self.assertEqual(len(ddapath.resume(run.folder, {"path.stop.after_steps": 6}).curve), 7)
        with self.assertRaisesRegex(ddapath.NotFound, "there is no such folder"):
            ddapath.resume(self.folder / "nowhere")

    def test_check(self):
        said = ddapath.check(ddapath.read_deck(DECK))
        self.assertRegex(said, r"interface points +\d+, of which \d+ can crack")
        with self.assertRaisesRegex(ddapath.InputError, "did you mean 'tensile_strength'"):
            ddapath.check(DECK, {"interfaces.any.law.tensile_strengt": 3})

    def test_report(self):
        run = ddapath.run(DECK, {"path.stop.after_steps": 4}, folder=self.folder / "run")
        self.assertEqual(ddapath.report(run), run.folder / "report.html")
        page = ddapath.report(run.folder, self.folder / "page.html")
        self.assertIn("<html", page.read_text(encoding="utf-8"))
        with self.assertRaisesRegex(ddapath.InputError, "nowhere"):
            ddapath.report(self.folder / "nowhere")


class Sweeping(Scratch):
    def test_what_is_asked_of_the_program(self):
        self.stand_in(f'echo "$@" > {self.folder}/asked; cp "$2" {self.folder}/asked.yaml; echo enough >&2; exit 2')
        with self.assertRaisesRegex(ddapath.InputError, "enough"):
            ddapath.sweep(DECK, {"thickness": np.array([50, 100]), "seed": "1..3"}, self.folder / "sweep", jobs=2)
        asked = (self.folder / "asked").read_text(encoding="utf-8").split()
        self.assertEqual(asked[0], "sweep")
        self.assertEqual(asked[2:], ["--folder", str(self.folder / "sweep"), "--quiet", "--jobs", "2"])
        self.assertEqual(ddapath.read_deck(self.folder / "asked.yaml"),
                         {"sweep": {"deck": str(DECK), "thickness": [50, 100], "seed": "1..3"}})

    def test_a_sweep(self):
        axes = {"interfaces.any.law.fracture_energy": np.array([0.05, 0.1]), "path.stop.load_below": [0.8]}
        table = ddapath.sweep(DECK, axes, self.folder / "sweep")
        self.assertEqual(table.index.tolist(), [1, 2])
        self.assertEqual(table["interfaces.any.law.fracture_energy"].tolist(), [0.05, 0.1])
        self.assertGreater(table["peak.load"][2], table["peak.load"][1])
        self.assertEqual(table["run"][2].curve["load"].max(), table["peak.load"][2])
        self.assertEqual(table["run"][2].deck["interfaces"]["any"]["law"]["fracture_energy"], 0.1)
        self.assertEqual(table.attrs["units"]["peak.load"], "N")
        self.assertEqual(ddapath.read_sweep(self.folder / "sweep")["steps"].tolist(), table["steps"].tolist())

    def test_a_sweep_with_a_case_that_stops_early(self):
        axes = {"path.control": ["load", "staged"], "path.stop.load_below": [0.8]}
        with self.assertRaises(ddapath.StoppedEarly) as caught:
            ddapath.sweep(DECK, axes, self.folder / "sweep")
        self.assertEqual(caught.exception.results["status"].tolist(), ["stopped_early", "goal_reached"])

    def test_the_axes_of_a_dictionary_are_a_section_of_it(self):
        self.assertEqual(ddapath.program.with_axes({"title": "a"}, {"seed": [1]}), {"title": "a", "sweep": {"seed": [1]}})


if __name__ == "__main__":
    unittest.main()
