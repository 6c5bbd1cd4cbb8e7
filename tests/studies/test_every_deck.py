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


def is_deck(file):
    """Whether a file has the scene of a structure, and not only a sweep over other decks."""
    return any(line.startswith("scene:") for line in file.read_text(encoding="utf-8").splitlines())


class EveryDeck(unittest.TestCase):
    def test_loca_takes_every_step(self):
        decks = [file for file in sorted(STUDIES.glob("*/*.yaml")) if is_deck(file)]
        self.assertGreater(len(decks), 20)
        for deck in decks:
            with self.subTest(deck=f"{deck.parent.name}/{deck.name}"), tempfile.TemporaryDirectory() as folder:
                command = [PROGRAM, "run", deck, "--folder", f"{folder}/run", "--quiet", "--set", "sweep=", "--set",
                           f"path.stop.after_steps={STEPS}"]
                done = subprocess.run(command, capture_output=True, text=True, check=False)
                self.assertIn(done.returncode, (0, 3), done.stderr)
                self.assertEqual(list(taken_steps.complaints(Path(folder))), [])


if __name__ == "__main__":
    unittest.main()
