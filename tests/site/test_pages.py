"""What the pages show is true: decks pass `dda check`, commands parse, and every message with which a run
may stop early has its entry. `test_pages.py PROGRAM`.
"""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import yaml
from blocks import PAGES, Block, blocks, commands
from fragments import laid_over
from messages import endings

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = str(Path(sys.argv.pop(1)).resolve())


def blocks_of(page):
    return blocks(page.read_text(encoding="utf-8"))


def dda(*arguments, folder=ROOT):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, check=False)


def is_deck(block):
    keys = {line.split(":")[0] for line in block.text.split("\n")}
    return block.language == "yaml" and "scene" in keys and bool(keys & {"stages", "motion"})


class Decks(unittest.TestCase):
    def test_complete_decks_pass_the_check(self):
        count = 0
        for page in PAGES:
            for block in filter(is_deck, blocks_of(page)):
                if "file: beam.geo" in block.text:
                    continue  # the next test
                with self.subTest(page=page.name, line=block.line), tempfile.TemporaryDirectory() as folder:
                    deck = Path(folder) / "deck.yaml"
                    deck.write_text(block.text, encoding="utf-8")
                    self.assertEqual(dda("check", str(deck)).returncode, 0, dda("check", str(deck)).stderr)
                    count += 1
        self.assertGreaterEqual(count, 7)

    def test_the_manual_shows_a_study_s_deck(self):
        shown = [block for block in blocks_of(ROOT / "docs/manual/deck.md") if is_deck(block)]
        study = (ROOT / "studies/notched-beam/deck.yaml").read_text(encoding="utf-8")
        self.assertEqual([yaml.safe_load(block.text) for block in shown], [yaml.safe_load(study)])


class Fragments(unittest.TestCase):
    """Every deck that is not whole, over one that is."""

    def told(self, block, base):
        with tempfile.TemporaryDirectory() as folder:
            return dda("check", str(laid_over(block, base, Path(folder).resolve())))

    def base_of(self, block, page, folder):
        for other in blocks_of(page):
            if other.title == block.over:
                (folder / other.title).write_text(other.text, encoding="utf-8")
                return folder / other.title
        return ROOT / block.over

    def test_they_pass_the_check(self):
        count = 0
        for page in PAGES:
            for block in blocks_of(page):
                if block.language != "yaml" or is_deck(block):
                    continue
                with self.subTest(page=page.relative_to(ROOT).as_posix(), line=block.line), tempfile.TemporaryDirectory() as folder:
                    self.assertTrue(block.over, "a comment above the fragment is to name the deck that it is laid over")
                    done = self.told(block, self.base_of(block, page, Path(folder).resolve()))
                    self.assertEqual(done.returncode, 0, done.stderr)
                    count += 1
        self.assertGreaterEqual(count, 22)

    def test_a_mistake_in_one_is_found(self):
        base = ROOT / "tests/site/bases/unloaded_beam.yaml"
        for text, said in (("stages:\n  - {name: loading, loads: [...], until: {cmud: 0.05}}\n", "cmud"),
                           ("interfaces: {ligament: {law: {fracture_enery: 0.1}}}\n", "fracture_energy"),
                           ("supports: {left: {at: [-200, 0], fix: z}}\n", "fix")):
            done = self.told(Block("yaml", "", text, 1), base)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(said, done.stderr)


class Commands(unittest.TestCase):
    """Names, options and settings of all that is shown, whether it runs here or takes an hour."""

    @classmethod
    def setUpClass(cls):
        cls.help = subprocess.run([ROOT / "bootstrap", "help"], capture_output=True, text=True, check=True).stdout
        cls.options = {}
        cls.checked = set()

    def known(self, name):
        if name not in self.options:
            told = dda(name, "--help")
            self.assertEqual(told.returncode, 0, f"there is no command '{name}'")
            self.options[name] = set(re.findall(r"--[a-z-]+", told.stdout))
        return self.options[name]

    def look_at_study(self, words):
        script = ROOT / "studies" / words[0] / "study.py"
        self.assertTrue(script.exists(), words)
        texts = script.read_text(encoding="utf-8") + (ROOT / "python/ddapath/study.py").read_text(encoding="utf-8")
        for option in words[1:]:
            if option.startswith("--"):
                self.assertIn(f'"{option}"', texts)

    def look_at_deck(self, name, deck, words):
        """A deck of the repository, with the settings that it is shown with."""
        settings = [part for k, word in enumerate(words) if word in ("--set", "--parameters")
                    for part in (word, words[k + 1])]
        asked = (deck, *settings)
        if asked in self.checked or any("$" in word for word in asked):
            return
        self.checked.add(asked)
        if name == "run":
            settings += ["--set", "sweep="] * ("sweep" not in Path(ROOT / deck).name)
        done = dda("check", deck, *settings)
        self.assertEqual(done.returncode, 0, done.stderr)

    def look_at(self, words):
        program, name, *rest = words
        if program == "./bootstrap" and name in ("study", "test", "build", "packages", "site", "help"):
            self.assertRegex(self.help, rf"(?m)^  {name}\b")
            if name == "study" and rest and rest[0] != "NAME":
                self.look_at_study(rest)
            for option in rest if name == "test" else []:
                self.assertTrue(not option.startswith("--") or option in self.help, option)
            return
        if name == "--version":
            return
        known = self.known(name)
        for option in rest:
            if option.startswith("--"):
                self.assertIn(option.split("=")[0], known, words)
        if name in ("run", "check", "compare", "sweep") and rest and (ROOT / rest[0]).is_file():
            self.look_at_deck(name, rest[0], rest)

    def test_all_that_is_shown(self):
        count = 0
        for page in PAGES:
            for block in blocks_of(page):
                for words in commands(block):
                    with self.subTest(page=page.relative_to(ROOT).as_posix(), line=block.line, command=" ".join(words)):
                        self.look_at(words)
                        count += 1
        self.assertGreater(count, 80)


class Stopped(unittest.TestCase):
    def test_every_way_to_stop_has_an_entry_of_its_name(self):
        names = re.findall(r'Stop::\w+, "([a-z-]+)"', (ROOT / "continuation/control/stop.hpp").read_text(encoding="utf-8"))
        entries = re.findall(r"^### (\S+)$", (ROOT / "docs/stopped.md").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual(names, entries)

    def test_every_message_has_an_entry(self):
        page = " ".join((ROOT / "docs/stopped.md").read_text(encoding="utf-8").split())
        found = endings(ROOT)
        self.assertGreater(sum(map(len, found.values())), 25)
        for file, texts in found.items():
            for text in texts:
                for piece in re.split(r"\{[^}]*\}", text):
                    piece = piece.strip(" ;:,.()")
                    with self.subTest(file=file, text=text):
                        self.assertIn(piece, page)


if __name__ == "__main__":
    unittest.main()
