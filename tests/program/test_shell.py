"""What a user meets in a shell: completion, manual pages, the version, a first deck, where an error is."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

DDA = os.environ["DDA"]
DECK = Path(__file__).resolve().parent / "beam.yaml"


def dda(*words, folder=None):
    return subprocess.run([DDA, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})


def completed(*words):
    """Words and directives that `dda complete` proposes."""
    return [line.split("\t")[0] for line in dda("complete", "--", *words).stdout.splitlines()]


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)


class Completion(unittest.TestCase):
    def test_commands(self):
        self.assertEqual(completed("re"), ["resume", "report"])
        self.assertIn("run", completed(""))
        self.assertIn("run", completed())
        self.assertNotIn("complete", completed("compl"))

    def test_options(self):
        self.assertEqual(completed("run", DECK, "--th"), ["--threads="])
        self.assertEqual(completed("run", "--overwrite", "--qu"), ["--quiet"])
        self.assertIn("--plugin=", completed("--p"))

    def test_files(self):
        for words, kind in ((["run", ""], ":deck"), (["check", "st"], ":deck"), (["resume", ""], ":folder"),
                            (["run", DECK, "--folder", ""], ":folder"), (["run", DECK, "--parameters", "x"], ":file"),
                            (["plot", "runs/a", "runs"], ":folder"), (["--plugin", ""], ":file")):
            self.assertEqual(completed(*words), [kind], words)
        self.assertEqual(completed("run", DECK, ""), [])

    def test_keys_of_the_deck(self):
        self.assertEqual(completed("run", DECK, "--set", "interfaces."), ["interfaces.any."])
        self.assertIn("interfaces.any.law.fracture_energy=", completed("run", DECK, "--set", "interfaces.any.law.f"))
        self.assertEqual(completed("run", DECK, "--set=path.stop.load_b"), ["--set=path.stop.load_below="])
        self.assertIn("path.control=staged", completed("run", DECK, "--quiet", "--set", "path.control="))
        self.assertIn("path.", completed("run", "no such deck.yaml", "--set", "pa"))

    def test_names(self):
        self.assertEqual(completed("completion", ""), ["bash", "zsh", "fish"])
        self.assertEqual(completed("sweep", DECK, "--launcher", "m"), ["mpirun"])
        self.assertEqual(completed("compare", DECK, "--controls", "event,arc"), ["event,arc_length"])
        self.assertEqual(completed("explain", "law/linear"), ["law/linear_softening"])
        self.assertIn("motion.contact.friction", completed("explain", "motion.contact."))
        self.assertIn("beam", completed("new", ""))

    def test_every_command_is_completed(self):
        for command in completed(""):
            done = dda("complete", "--", command, "--")
            self.assertEqual(done.returncode, 0)
            self.assertIn("--help", done.stdout, command)

    def test_an_unknown_shell(self):
        done = dda("completion", "tcsh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("'tcsh' is none of bash, zsh, fish", done.stdout + done.stderr)


class Shells(Scratch):
    """The scripts, in the shells themselves."""

    def setUp(self):
        super().setUp()
        for name in ("bash", "zsh", "fish"):
            (self.folder / name).write_text(dda("completion", name).stdout, encoding="utf-8")
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "dda").symlink_to(DDA)
        (self.folder / "decks").mkdir()
        for name in ("one.yaml", "two.txt"):
            (self.folder / "decks" / name).touch()
        self.environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", "HOME": str(self.folder)}

    def said(self, *words):
        done = subprocess.run(words, cwd=self.folder, env=self.environment, capture_output=True, text=True, check=False, timeout=60)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def bash(self, line, *words):
        """COMPREPLY for a line; bash has split it at '=' into these words."""
        quoted = " ".join(f"'{word}'" for word in words)
        script = (f"source ./bash; compopt() {{ :; }}; COMP_LINE='{line}' COMP_POINT={len(line)} COMP_WORDS=({quoted}) "
                  f"COMP_CWORD={len(words) - 1}; _dda; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
        return self.said("bash", "--norc", "-c", script)

    def test_bash(self):
        self.assertEqual(self.bash("dda ver", "dda", "ver"), ["verify"])
        self.assertEqual(self.bash("dda run d", "dda", "run", "d"), ["decks"])
        self.assertEqual(self.bash("dda run decks/", "dda", "run", "decks/"), ["decks/one.yaml"])
        self.assertEqual(self.bash("dda run x --set path.control=st", "dda", "run", "x", "--set", "path.control", "=", "st"), ["staged"])
        self.assertEqual(self.bash("dda run x --set path.control=", "dda", "run", "x", "--set", "path.control", "=")[0], "arc_length")
        self.assertEqual(self.bash("dda run x --set path.con", "dda", "run", "x", "--set", "path.con"), ["path.control.", "path.control="])

    @unittest.skipUnless(shutil.which("fish"), "there is no fish")
    def test_fish(self):
        ask = "source fish; complete -C '{}'"
        self.assertEqual(self.said("fish", "--no-config", "-c", ask.format("dda ver"))[0], "verify")
        self.assertEqual(self.said("fish", "--no-config", "-c", ask.format("dda run x --set path.stop.load_b"))[0], "path.stop.load_below=")
        self.assertIn("decks/one.yaml", self.said("fish", "--no-config", "-c", ask.format("dda run decks/")))

    @unittest.skipUnless(shutil.which("zsh"), "there is no zsh")
    def test_zsh(self):
        script = ("autoload -Uz compinit; compinit -u -D; source ./zsh; print -r -- $_comps[dda]; "
                  "compadd() { print -r -- ${(P)@[-1]}; }; words=(dda run x --set path.stop.load_b); CURRENT=5; _dda; "
                  "_files() { print -r -- files $@; }; words=(dda run ''); CURRENT=3; _dda")
        self.assertEqual(self.said("zsh", "-f", "-c", script), ["_dda", "path.stop.load_below=", "files", "-g", "*.(yaml|yml|json)(-.)"])


class Manual(unittest.TestCase):
    def test_pages_are_well_formed(self):
        if not shutil.which("groff"):
            self.skipTest("there is no groff")
        for page in ("dda", "deck"):
            text = dda("man", page).stdout
            done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-k"], input=text, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0)
            self.assertEqual([line for line in done.stderr.splitlines() if "can't break line" not in line and "cannot adjust" not in line], [])

    def test_everything_is_in_them(self):
        page, deck = dda("man").stdout, dda("man", "deck").stdout
        for command in completed(""):
            self.assertIn(f'.SS "dda {command}', page)
        for key in ("path.stop.load_below", "interfaces.NAME.law", "law/bonded", "motion.contact.friction"):
            self.assertIn(key.replace("-", "\\-"), deck)

    def test_version(self):
        said = dda("--version").stdout
        self.assertRegex(said, r"^ddapath \d+\.\d+\.\d+")
        self.assertRegex(said, r"\ncompiler: g\+\+ \d+")
        for library in ("Trilinos", "gmsh", "GEOS", "HDF5", "CHOLMOD", "MUMPS", "OpenBLAS", "Eigen", "fmt", "nlohmann-json", "libyaml", "CLI11"):
            self.assertRegex(said, rf"{library} \d+\.\d")

    def test_explains_a_member_by_its_name_alone(self):
        self.assertIn("load body_force: A force per volume", dda("explain", "body_force").stdout)
        both = dda("explain", "penalty").stdout
        for line in ("contact penalty: ", "treatment penalty: "):
            self.assertIn(line, both)

    def test_find(self):
        done = dda("explain", "--find", "friction")
        self.assertEqual(done.returncode, 0)
        for line in ("  law/friction\n", "  law/linear_softening.friction_angle: number", "  motion.contact.friction: "):
            self.assertIn(line, done.stdout)
        done = dda("explain", "--find", "frictoin")
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean 'friction'?", done.stderr)


class NewDecks(Scratch):
    def test_every_kind_runs(self):
        for kind in completed("new", ""):
            done = dda("new", kind, folder=self.folder)
            self.assertEqual((done.returncode, done.stdout), (0, f"{kind}.yaml: a deck to begin with; next: dda run {kind}.yaml\n"))
            done = dda("run", f"{kind}.yaml", "--quiet", folder=self.folder)
            self.assertEqual(done.returncode, 0, f"{kind}: {done.stdout}{done.stderr}")
            comments = re.findall("#", (self.folder / f"{kind}.yaml").read_text(encoding="utf-8"))
            self.assertGreater(len(comments), 8, kind)

    def test_nothing_is_overwritten(self):
        self.assertEqual(dda("new", "beam", "--out", "mine.yaml", folder=self.folder).returncode, 0)
        done = dda("new", "beam", "--out", "mine.yaml", folder=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("mine.yaml: is there already", done.stderr)

    def test_an_unknown_kind(self):
        done = dda("new", "baem", folder=self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean 'beam'?", done.stdout + done.stderr)


class Errors(Scratch):
    def test_show_the_line(self):
        file = self.folder / "deck.yaml"
        file.write_text(DECK.read_text(encoding="utf-8").replace("thickness", "thicknes"), encoding="utf-8")
        said = dda("check", "deck.yaml", folder=self.folder).stderr.splitlines()
        at = next(i for i, line in enumerate(said) if "unknown" in line and "did you mean 'thickness'?" in line)
        self.assertTrue(said[at].startswith("deck.yaml:8:1: "), said)
        self.assertEqual(said[at + 1:at + 3], ["      8 | thicknes: 100", "        | ^~~~~~~~"])

    def test_a_sweep_tells_the_reason_and_not_the_line(self):
        file = self.folder / "deck.yaml"
        file.write_text(DECK.read_text(encoding="utf-8"), encoding="utf-8")
        dda("sweep", "deck.yaml", "--quiet", "--folder", "out", "--set", "sweep={supports.left.at: [[0, 0], [7, 7000]]}",
            "--set", "path.stop.after_steps=1", folder=self.folder)
        table = (self.folder / "out" / "sweep.csv").read_text(encoding="utf-8")
        self.assertNotIn("^", table)


if __name__ == "__main__":
    unittest.main()
