"""What a program's end is told as: its exit code, or that its processor time was used up."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from matrix_runner import start_deck  # noqa: E402


def told(script, limit):
    """What `start_deck` says of a program that is this script."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program"
        program.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        program.chmod(0o755)
        return start_deck(Path(folder) / "deck.yaml", Path(folder) / "run", str(program), limit)


class Ends(unittest.TestCase):
    def test_one_that_never_ends_has_run_out_of_time(self):
        code, _, said = told("while :; do :; done", 1)
        self.assertEqual(code, "time")
        self.assertEqual(said, "not done in 1 s of processor time")

    def test_another_has_its_exit_code(self):
        code, _, said = told("echo it ends here >&2; exit 3", 1)
        self.assertEqual((code, said), (3, "it ends here"))


if __name__ == "__main__":
    unittest.main()
