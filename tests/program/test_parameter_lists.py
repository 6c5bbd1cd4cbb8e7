"""Parameter lists of NOX and LOCA: every parameter that is accepted changes what is done, everything else is refused
with its place.

    test_parameter_lists.py        with DDA naming the program
"""

import itertools
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

DDA = os.environ["DDA"]
DECK = Path(__file__).resolve().parents[2] / "studies" / "notched-beam" / "deck.yaml"
COARSE = ("scene.parameters.ligament_size=8", "scene.parameters.far_size=64")
SHORT = (*COARSE, "path.stop.load_below=0.5", "record.fields_every=0")

# Of each parameter a value that is not its default, what must be set beside it, and the settings of the deck under
# which it is tried.
ADAPTIVE = {"LOCA/Step Size/Method": "Adaptive"}
BY_DISPLACEMENT = ("path.control=opening",)
WHOLE = ("path.update=refactorise", "path.stop.after_steps=8")
LONG_STEPS = ("path.stop.after_steps=14", "path.step.accuracy=0.5", "path.step.largest=1")
CHANGES = {
    "NOX/Line Search/Method": ("Polynomial", {"NOX/Printing/Output Information": 4}, ()),
    "NOX/Line Search/Backtrack/Reduction Factor": (0.3, {"NOX/Line Search/Method": "Backtrack",
                                                         "NOX/Printing/Output Information": 8}, ()),
    "NOX/Printing/Output Information": (2, {}, ()),
    "NOX/Status Tests/NormF/Tolerance": (1e-12, {}, WHOLE),
    "NOX/Status Tests/MaxIters/Maximum Iterations": (2, {}, LONG_STEPS),
    "LOCA/Stepper/Continuation Method": ("Arc Length", {}, ()),
    "LOCA/Stepper/Max Value": (500.0, {}, ()),
    "LOCA/Stepper/Min Value": (1500.0, {}, ()),
    "LOCA/Stepper/Max Steps": (7, {}, ()),
    "LOCA/Stepper/Max Nonlinear Iterations": (2, {}, LONG_STEPS),
    "LOCA/Step Size/Method": ("Constant", {}, ()),
    "LOCA/Step Size/Initial Step Size": (1e-4, {}, BY_DISPLACEMENT),
    "LOCA/Step Size/Min Step Size": (1.0, {}, BY_DISPLACEMENT),
    "LOCA/Step Size/Max Step Size": (5e-4, {}, BY_DISPLACEMENT),
    "LOCA/Step Size/Aggressiveness": (0.1, ADAPTIVE, BY_DISPLACEMENT),
    "LOCA/Step Size/Failed Step Reduction Factor": (0.6, {}, ("path.control=load",)),
    "LOCA/Predictor/Method": ("Constant", {}, ()),
}
FIXED = {"NOX/Nonlinear Solver": "Line Search Based", "NOX/Direction/Method": "Newton",
         "LOCA/Stepper/Continuation Parameter": "lambda", "LOCA/Stepper/Bordered Solver Method": "Bordering"}
TYPES = {bool: "bool", int: "int", float: "double", str: "string"}


def nested(parameters):
    """A tree of lists from full names; status tests stand in a sublist with their type."""
    root = {}
    for name, value in parameters.items():
        *lists, last = name.split("/")
        if "Status Tests" in lists:
            root.setdefault("NOX", {}).setdefault("Status Tests", {})["Test Type"] = lists.pop()
        at = root
        for each in lists:
            at = at.setdefault(each, {})
        at[last] = value
    return root


def as_xml(name, node, indent=""):
    lines = [f'{indent}<ParameterList name="{name}">']
    for key, value in node.items():
        if isinstance(value, dict):
            lines += as_xml(key, value, indent + "  ")
        else:
            lines.append(f'{indent}  <Parameter name="{key}" type="{TYPES[type(value)]}" value="{value}"/>')
    return [*lines, f"{indent}</ParameterList>"]


class Lists(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def write(self, parameters, name="list.xml"):
        file = self.folder / name
        if name.endswith(".xml"):
            file.write_text("\n".join(as_xml("any name", nested(parameters))) + "\n", encoding="utf-8")
        else:
            file.write_text(json.dumps({"any name": nested(parameters)}), encoding="utf-8")
        return file

    def run_deck(self, folder, *arguments, settings=()):
        command = [DDA, "run", DECK, "--quiet", "--overwrite", "--folder", self.folder / folder, *arguments]
        for setting in (*SHORT, *settings):
            command += ["--set", setting]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def outcome(self, folder):
        """What a run has done, its time and place left out."""
        run = self.folder / folder
        log = run / "nox.log"
        summary = json.loads((run / "summary.json").read_text(encoding="utf-8"))
        return ((run / "curve.csv").read_text(encoding="utf-8"), summary["status"], summary["reason"],
                summary["newton_iterations"], summary["rejected_steps"],
                log.read_text(encoding="utf-8") if log.exists() else "")

    def test_the_manual_has_every_parameter(self):
        manual = subprocess.run([DDA, "explain", "parameters"], capture_output=True, text=True, check=True).stdout
        names = {match.group(1).strip() for match in re.finditer(r"^  (\S.*?)  ", manual, re.MULTILINE)}
        self.assertEqual(names, CHANGES.keys() | FIXED.keys())

    def test_every_parameter_changes_what_is_done(self):
        for name, (value, beside, settings) in CHANGES.items():
            with self.subTest(name):
                before = self.run_deck("before", "--parameters", self.write(beside), settings=settings)
                self.assertIn(before.returncode, (0, 3), before.stderr)
                after = self.run_deck("after", "--parameters", self.write({**beside, name: value}), settings=settings)
                self.assertIn(after.returncode, (0, 3), after.stderr)
                self.assertNotEqual(self.outcome("before"), self.outcome("after"))

    def test_no_iteration_is_longer_than_allowed(self):
        for settings, most in ((LONG_STEPS, 2), ((*LONG_STEPS, "path.update=refactorise", "path.stop.after_steps=30"), 3)):
            for given in ((), (f"path.newton.max_iterations={most}",)):
                self.run_deck("run", settings=(*settings, "path.newton.output=2", *given))
                log = (self.folder / "run" / "nox.log").read_text(encoding="utf-8")
                longest = max(int(number) for number in re.findall(r"Nonlinear Solver Step (\d+)", log))
                (self.assertEqual if given else self.assertGreater)(longest, most)

    def test_each_kind_of_output_is_what_the_manual_says(self):
        words = {2: "Nonlinear Solver Step", 8: "Parameters Passed to Nonlinear Solver", 16: "FORCING TERM", 32: "Status Test Results",
                 256: "Step Converged in", 512: "Calling Predictor with method",
                 1024: "Write Only Converged Solution"}
        for bit, said in words.items():
            self.run_deck("run", settings=("path.stop.after_steps=2", f"path.newton.output={bit}"))
            log = (self.folder / "run" / "nox.log").read_text(encoding="utf-8")
            self.assertEqual([other for other, sentence in words.items() if sentence in log and other != 2 and bit != 2],
                             [] if bit == 2 else [bit], bit)
            self.assertIn(said, log)

    def test_a_path_ends_where_steps_would_be_shorter_than_the_shortest(self):
        for control in ("staged", "arc_length", "dissipation", "load", "opening"):
            self.run_deck("run", settings=(f"path.control={control}", "path.step.shortest=1e6"))
            _, status, reason, *_ = self.outcome("run")
            self.assertEqual(status, "stopped_early", (control, reason))
            self.assertIn("shorter than path.step.shortest (1e+06)", reason)
            rows = (self.folder / "run" / "curve.csv").read_text(encoding="utf-8")
            self.assertNotIn("jump", rows)

    def test_what_is_always_so_may_be_said_and_nothing_else(self):
        self.assertEqual(self.run_deck("run", "--parameters", self.write(FIXED)).returncode, 0)
        for name in FIXED:
            refused = self.run_deck("run", "--parameters", self.write({name: "other"}))
            self.assertEqual(refused.returncode, 2)
            self.assertIn(f"{name}: 'other' cannot take effect here", refused.stderr)

    def test_unknown_and_ineffective_ones_are_refused_with_their_place(self):
        file = self.write({"LOCA/Stepper/Max Steps": 9, "LOCA/Stepper/Max Stps": 9})
        refused = self.run_deck("run", "--parameters", file)
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"{file}:5:", refused.stderr)
        self.assertIn("did you mean 'LOCA/Stepper/Max Steps'", refused.stderr)
        for parameters, settings, words in (
                ({"LOCA/Step Size/Aggressiveness": 0.5}, (), "only `sizing: iterations` has one"),
                ({"LOCA/Step Size/Max Step Size": 1.0}, ("path.control=event",), "does not heed it"),
                ({"LOCA/Stepper/Max Steps": 0}, (), "must be at least 1"),
                ({"LOCA/Stepper/Max Steps": "many"}, (), "many")):
            refused = self.run_deck("run", "--parameters", self.write(parameters), settings=settings)
            self.assertEqual(refused.returncode, 2, parameters)
            self.assertIn(words, refused.stderr)
            self.assertRegex(refused.stderr, re.escape(f"{file}:4:") + rf"\d+: {re.escape(*parameters)} \(path\.")
        (self.folder / "broken.xml").write_text("<ParameterList name='a'><Parameter", encoding="utf-8")
        refused = self.run_deck("run", "--parameters", self.folder / "broken.xml")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("is no parameter list in XML", refused.stderr)
        self.assertFalse((self.folder / "run").exists())

    def test_the_effective_list_starts_the_same_run(self):
        parameters = {"NOX/Status Tests/NormF/Tolerance": 1e-10, "LOCA/Stepper/Max Steps": 30, **ADAPTIVE,
                      "LOCA/Step Size/Aggressiveness": 0.3, "LOCA/Stepper/Continuation Method": "Arc Length"}
        self.run_deck("first", "--parameters", self.write(parameters))
        self.run_deck("again", "--parameters", self.folder / "first" / "parameters.xml")
        self.assertEqual(self.outcome("first"), self.outcome("again"))
        decks = [(self.folder / run / "effective_deck.yaml").read_text(encoding="utf-8") for run in ("first", "again")]
        without_comments = [[line for line in deck.splitlines() if not line.startswith("#")] for deck in decks]
        self.assertEqual(*without_comments)

    def test_yaml_deck_and_option_say_the_same(self):
        parameters = {"LOCA/Stepper/Max Steps": 12, "LOCA/Predictor/Method": "Constant"}
        self.run_deck("xml", "--parameters", self.write(parameters))
        self.run_deck("yaml", "--parameters", self.write(parameters, "list.yaml"))
        lists = nested(parameters)["LOCA"]
        self.run_deck("deck", settings=(f"path.loca={json.dumps(lists)}",))
        named = self.run_deck("key", settings=(f"path.parameters={self.write(parameters)}",))
        self.assertEqual(named.returncode, 3, named.stderr)
        for other in ("yaml", "deck", "key"):
            self.assertEqual(self.outcome("xml"), self.outcome(other))

    def test_set_counts_before_a_list(self):
        self.run_deck("run", "--parameters", self.write({"LOCA/Stepper/Max Steps": 12}), settings=("path.stop.steps=5",))
        self.assertIn("limit of 5 steps", self.outcome("run")[2])

    def test_a_list_in_the_deck_does_not_contradict_it(self):
        refused = self.run_deck("run", settings=("path.loca={Stepper: {Max Steps: 5}}", "path.stop.steps=6"))
        self.assertEqual(refused.returncode, 2)
        self.assertIn("LOCA/Stepper/Max Steps stands for path.stop.steps", refused.stderr)

    def test_lists_do_not_contradict_each_other(self):
        file = self.write({"LOCA/Stepper/Max Steps": 12})
        deck = self.folder / "deck.yaml"
        written = DECK.read_text(encoding="utf-8").replace("beam.geo", str(DECK.parent / "beam.geo"))
        for steps, code in ((12, 3), (13, 2)):
            deck.write_text(written.replace("\npath:\n", f"\npath:\n  loca: {{Stepper: {{Max Steps: {steps}}}}}\n"), encoding="utf-8")
            done = subprocess.run([DDA, "run", deck, "--quiet", "--overwrite", "--folder", self.folder / "run", "--parameters", file],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn("LOCA/Stepper/Max Steps stands for path.stop.steps, which", done.stderr)

    def test_lists_of_the_command_line_do_not_contradict_each_other(self):
        file = self.write({"LOCA/Stepper/Max Steps": 12})
        for setting, code in (("path.loca={Stepper: {Max Steps: 12}}", 3), ("path.loca={Stepper: {Max Steps: 13}}", 2), ("path.stop.steps=13", 3)):
            done = self.run_deck("run", "--parameters", file, settings=(setting,))
            self.assertEqual(done.returncode, code, done.stderr)
            if code == 2:
                self.assertRegex(done.stderr, re.escape(f"{file}:4:") + r"\d+: LOCA/Stepper/Max Steps stands for path\.stop\.steps, which --set ")

    def test_a_resumed_run_takes_a_list_by_set(self):
        self.run_deck("run", "--parameters", self.write({"LOCA/Stepper/Max Steps": 12}))
        resumed = subprocess.run([DDA, "resume", self.folder / "run", "--quiet", "--set", "path.loca={Stepper: {Max Steps: 15}}"],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(resumed.returncode, 3, resumed.stderr)
        self.assertIn("limit of 15 steps", self.outcome("run")[2])

    def test_names_are_taken_as_they_are_explained(self):
        tests = {"NormF": {"Tolerance": 1e-12}, "MaxIters": {"Maximum Iterations": 3}}
        listed = self.run_deck("run", settings=(f"path.nox={json.dumps({'Status Tests': tests})}", "path.stop.after_steps=4"))
        self.assertEqual(listed.returncode, 0, listed.stderr)
        effective = (self.folder / "run" / "effective_deck.yaml").read_text(encoding="utf-8")
        self.assertRegex(effective, r"tolerance: 1\.0e-12\n *max_iterations: 3\n")

    def test_each_predictor_has_an_effect(self):
        outcomes = []
        for predictor in ("Tangent", "Secant", "Constant"):
            self.run_deck(predictor, "--parameters",
                          self.write({"LOCA/Stepper/Max Steps": 20, "LOCA/Predictor/Method": predictor}))
            outcomes.append(self.outcome(predictor)[0])
        for one, other in itertools.combinations(outcomes, 2):
            self.assertNotEqual(one, other)

    def test_a_resumed_run_goes_on_with_its_list(self):
        for predictor in ("Constant", "Secant"):
            run, whole = f"{predictor}-run", f"{predictor}-whole"
            self.run_deck(run, "--parameters",
                          self.write({"LOCA/Stepper/Max Steps": 12, "LOCA/Predictor/Method": predictor}))
            (self.folder / "list.xml").unlink()
            resumed = subprocess.run([DDA, "resume", self.folder / run, "--quiet", "--set", "path.stop.steps=20"],
                                     capture_output=True, text=True, check=False)
            self.assertEqual(resumed.returncode, 3, resumed.stderr)
            self.run_deck(whole, "--parameters",
                          self.write({"LOCA/Stepper/Max Steps": 20, "LOCA/Predictor/Method": predictor}))
            self.assertEqual(self.outcome(run)[0], self.outcome(whole)[0])


if __name__ == "__main__":
    unittest.main()
