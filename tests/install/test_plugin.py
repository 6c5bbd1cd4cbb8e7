"""Plugins: the example, built against an installation, gives the curve of the law it repeats; what is none is refused."""
import csv
import json
import re
import shutil
import unittest
from pathlib import Path

from installation import ROOT, built_plugin, called, install, scratch

LAW = "interfaces.joints.law.type"


def curve(folder):
    with open(folder / "curve.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Plugin(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = scratch(cls)
        cls.prefix = install(cls.work / "prefix")
        cls.program = cls.prefix / "bin" / "dda"
        cls.example = cls.work / "my law"
        cls.library = built_plugin(cls.prefix, cls.example)

    def dda(self, *words):
        return called(self.program, *words, folder=self.work)

    def assert_refused(self, said, *words):
        done = self.dda(*words, "explain", "law")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(said, done.stderr)

    def run_with_both(self):
        deck = self.example / "deck.yaml"
        for name, words in (("mine", ["--plugin", self.library]), ("theirs", ["--set", f"{LAW}=linear_softening"])):
            if not (self.work / name).exists():
                done = self.dda("run", deck, "--quiet", "--folder", name, *words)
                self.assertEqual(done.returncode, 0, done.stderr)
        return self.work / "mine", self.work / "theirs"

    def test_its_curve_is_that_of_the_law_it_repeats(self):
        mine, theirs = map(curve, self.run_with_both())
        self.assertEqual(len(mine), len(theirs))
        self.assertGreater(len(mine), 20)
        for name in ("load_factor", "load", "deflection", "dissipated_energy", "stored_energy"):
            largest = max(abs(float(row[name])) for row in theirs)
            for one, other in zip(mine, theirs):
                self.assertLessEqual(abs(float(one[name]) - float(other[name])), 1e-12 * largest, (name, one["step"]))

    def test_a_curve_in_python_and_the_plugin_are_the_same_law(self):
        if not list((self.prefix / "lib/ddapath").glob("_core.*.so")):
            self.skipTest("built without pybind11")
        script = self.work / "both.py"
        script.write_text(f"""import sys
sys.path[:0] = [{str(self.prefix / 'share/ddapath/python')!r}, {str(ROOT / 'tests/python')!r}]
import ddapath
from test_laws import Straight
deck, columns = {str(self.example / 'deck.yaml')!r}, ("step", "load_factor", "load", "dissipated_energy", "stored_energy")
paths = [ddapath.follow(deck, {{"{LAW}": law}}, plugins=[{str(self.library)!r}]) for law in ("straight_softening", "straight", "linear_softening")]
for name, path in zip(("plugin", "python", "program"), paths):
    for point in path:
        print(name, *(repr(getattr(point, column)) for column in columns))
""", encoding="utf-8")
        done = called("/usr/bin/python3", "-B", script, folder=self.work, environment={"DDA": str(self.program)})
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split() for line in done.stdout.splitlines()]
        curves = {name: [list(map(float, row[1:])) for row in rows if row[0] == name] for name in ("plugin", "python", "program")}
        self.assertGreater(len(curves["program"]), 20)
        for name in ("plugin", "python"):
            self.assertEqual(len(curves[name]), len(curves["program"]))
            for column in range(5):
                largest = max(abs(row[column]) for row in curves["program"])
                for mine, theirs in zip(curves[name], curves["program"]):
                    self.assertLessEqual(abs(mine[column] - theirs[column]), 1e-12 * largest, (name, column, mine[0]))

    def test_the_table_of_what_a_law_costs(self):
        """The numbers are not judged; that all laws are one curve is."""
        if not list((self.prefix / "lib/ddapath").glob("_core.*.so")):
            self.skipTest("built without pybind11")
        script = f"import law_cost; law_cost.load({str(self.library)!r}); print(law_cost.table(runs=1, share=0.01))"
        done = called("/usr/bin/python3", "-B", "-c", script, folder=self.work,
                      environment={"DDA": str(self.program), "PYTHONPATH": str(ROOT / "tests/benchmark")})
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.strip("| ").split(" | ") for line in done.stdout.splitlines() if line.startswith("| ")][1:]
        self.assertEqual(len(rows), 4)
        for name, evaluation, path, difference in rows:
            self.assertGreater(min(float(evaluation), float(path)), 0, name)
            self.assertLessEqual(float(difference), 1e-12, name)

    def test_the_run_tells_which_it_had(self):
        mine, theirs = self.run_with_both()
        self.assertEqual(json.loads((mine / "summary.json").read_text())["plugins"], [str(self.library)])
        self.assertNotIn("plugins", json.loads((theirs / "summary.json").read_text()))
        self.assertIn(f"# --plugin {self.library}\n", (mine / "effective_deck.yaml").read_text())

    def test_verify_leaves_out_what_it_does_not_know(self):
        mine, _ = self.run_with_both()
        done = self.dda("verify", mine)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, "law envelope .*not checked: the law straight_softening is a plugin's")
        self.assertRegex(done.stdout, "ok +block equilibrium")

    def test_resume_needs_it_again(self):
        done = self.dda("run", self.example / "deck.yaml", "--quiet", "--folder", "part", "--plugin", self.library,
                        "--set", "path.stop.after_steps=5")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.dda("resume", "part", "--quiet", "--set", "path.stop.after_steps=9")
        self.assertEqual(done.returncode, 2)
        self.assertIn("unknown law 'straight_softening'", done.stderr)
        done = self.dda("--plugin", self.library, "resume", "part", "--quiet", "--set", "path.stop.after_steps=9")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_cases_of_a_sweep_have_it(self):
        done = self.dda("sweep", self.example / "deck.yaml", "--quiet", "--folder", "sweep", "--plugin", self.library,
                        "--set", "sweep.thickness=[50, 100]", "--set", "path.stop.after_steps=3")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_it_is_explained(self):
        done = self.dda("explain", "law/straight_softening", "--plugin", self.library)
        self.assertIn("from a plugin: an example", done.stdout)
        self.assertIn("fracture_energy", done.stdout)
        self.assertNotIn("straight_softening", self.dda("explain", "law").stdout)

    def test_twice_the_same_file_is_one(self):
        done = self.dda("--plugin", self.library, "explain", "law", "--plugin", self.library)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_load_and_a_control(self):
        """Files of the tree under another name: any member of a family may be outside of it."""
        sources = []
        for file, name in (("models/load/point_load.cpp", "point_load"), ("continuation/control/increments.cpp", "load_increments")):
            text = (ROOT / file).read_text(encoding="utf-8")
            self.assertIn(f'"{name}"', text)
            sources.append(self.work / Path(file).name)
            sources[-1].write_text(text.replace(f'"{name}"', f'"my_{name}"'), encoding="utf-8")
        done = called("g++", "-std=c++20", "-O1", "-shared", "-fPIC", *sources, self.prefix / "lib/cmake/ddapath/stamp.cpp", "-o", "members.so",
                      "-I", self.prefix / "include/ddapath", "-I", "/usr/include/eigen3", folder=self.work)
        self.assertEqual(done.returncode, 0, done.stderr)
        release = "{type: mohr_coulomb, tensile_strength: 3, cohesion: 4, friction_angle: 30}"
        words = ["--quiet", "--plugin", "members.so", "--set", f"interfaces.joints.law={release}"]
        for folder, load, control in (("own", "my_point_load", "my_load_increments"), ("same", "point_load", "load_increments")):
            done = self.dda("run", self.example / "deck.yaml", *words, "--folder", folder, "--set", f"stages.0.loads.0.type={load}",
                            "--set", f"path.control={control}", "--set", "path.stop.after_steps=12")
            self.assertIn(done.returncode, (0, 3), done.stderr)
        self.assertEqual(curve(self.work / "own"), curve(self.work / "same"))
        self.assertGreater(len(curve(self.work / "own")), 5)

    def test_a_report_of_its_run(self):
        mine, _ = self.run_with_both()
        done = self.dda("report", mine)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_is_not_there(self):
        self.assert_refused("no_such.so: there is no such plugin", "--plugin", "no_such.so")

    def test_what_is_no_plugin(self):
        self.assert_refused("is no plugin of ddapath", "--plugin", self.prefix / "lib/ddapath/dda_geos.so")
        self.assert_refused("is no plugin of ddapath", "--plugin", self.example / "deck.yaml")

    def test_what_was_built_for_other_headers(self):
        other = self.work / "old.so"
        content = self.library.read_bytes()
        changed = re.sub(rb"(ddapath plugin for: [\d.]+, headers )\w{12}", rb"\g<1>0123456789ab", content)
        self.assertNotEqual(content, changed)
        other.write_bytes(changed)
        self.assert_refused("old.so: was built for ddapath 0.1.0, headers 0123456789ab", "--plugin", other)

    def test_a_name_that_is_taken(self):
        copy = shutil.copy(self.library, self.work / "another.so")
        self.assert_refused("another.so: cannot be used: law 'straight_softening' is registered twice", "--plugin", self.library, "--plugin", copy)

    def test_what_registers_nothing(self):
        done = called("g++", "-std=c++20", "-shared", "-fPIC", self.prefix / "lib/cmake/ddapath/stamp.cpp", "-o", "empty.so",
                      "-I", self.prefix / "include/ddapath", "-I", "/usr/include/eigen3", folder=self.work)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_refused("empty.so: registers nothing", "--plugin", "empty.so")

    def test_what_needs_what_the_program_has_not(self):
        source = self.work / "lacking.cpp"
        source.write_text("namespace dda { void not_there(); }\nstatic const bool called = (dda::not_there(), true);\n", encoding="utf-8")
        done = called("g++", "-std=c++20", "-shared", "-fPIC", source, self.prefix / "lib/cmake/ddapath/stamp.cpp", "-o", "lacking.so",
                      "-I", self.prefix / "include/ddapath", "-I", "/usr/include/eigen3", folder=self.work)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_refused("lacking.so: cannot be loaded", "--plugin", "lacking.so")


if __name__ == "__main__":
    unittest.main()
