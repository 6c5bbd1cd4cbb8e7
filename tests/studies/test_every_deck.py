"""The first steps of every deck below studies/, taken by LOCA: `python3 test_every_deck.py PROGRAM`.

The cases of expect.yaml and the studies' own scripts follow the paths to their ends; a deck that only a sweep or a
script uses is run here, too.
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import taken_steps

STUDIES = Path(__file__).resolve().parents[2] / "studies"
PROGRAM = sys.argv.pop(1)
STEPS = 25
MOVING = 1e-3  # of what is let go [s]


def has(file, section):
    """Whether a file has a section at its top: a sweep over other decks has no scene."""
    return any(line.startswith(f"{section}:") for line in file.read_text(encoding="utf-8").splitlines())


def shortened(file):
    """Options for the first steps of a path, and a moment of what is let go."""
    short = [("path.stop.after_steps", STEPS)] if has(file, "stages") else []
    short += [("motion.time", MOVING)] if has(file, "motion") else []
    return [part for key, value in short for part in ("--set", f"{key}={value}")]


class EveryDeck(unittest.TestCase):
    def test_loca_takes_every_step(self):
        decks = [file for file in sorted(STUDIES.glob("*/*.yaml")) if has(file, "scene")]
        self.assertGreater(len(decks), 20)
        for deck in decks:
            with self.subTest(deck=f"{deck.parent.name}/{deck.name}"), tempfile.TemporaryDirectory() as folder:
                command = [PROGRAM, "run", deck, "--folder", f"{folder}/run", "--quiet", "--set", "sweep=", *shortened(deck)]
                done = subprocess.run(command, capture_output=True, text=True, check=False)
                self.assertIn(done.returncode, (0, 3), done.stderr)
                if has(deck, "stages"):
                    self.assertEqual(list(taken_steps.complaints(Path(folder))), [])


if __name__ == "__main__":
    unittest.main()
