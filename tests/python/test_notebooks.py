"""The notebooks of examples/notebooks: their cells run in order, as in Jupyter, in a folder of their own."""

import contextlib
import io
import os
import tempfile
import unittest
from pathlib import Path

import notebooks

FOLDER = Path(__file__).resolve().parents[2] / "examples/notebooks"


def executed(name):
    """The variables that a notebook leaves, what its cells print, and the files that it leaves."""
    printed, home = io.StringIO(), Path.cwd()
    with tempfile.TemporaryDirectory() as scratch, contextlib.redirect_stdout(printed):
        os.chdir(scratch)
        try:
            variables = notebooks.executed(FOLDER / f"{name}.ipynb")
            left = sorted(Path(scratch).iterdir())
        finally:
            os.chdir(home)
    return variables, printed.getvalue(), left


class Notebooks(unittest.TestCase):
    def test_all_are_run_here_and_stored_without_output(self):
        self.assertEqual(sorted(file.stem for file in FOLDER.glob("*.ipynb")), ["first-beam", "own-law", "size-effect"])
        for file in FOLDER.glob("*.ipynb"):
            for source, cell in notebooks.cells(file):
                self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), source)

    def test_first_beam(self):
        found, printed, left = executed("first-beam")
        self.assertIn("interface points", printed)
        self.assertEqual(found["path"].status, "goal_reached")
        self.assertGreater(found["peak"].load, found["points"][-1].load * 4)
        self.assertLess(found["lowest"][-1], found["lowest"][0])
        self.assertEqual(left, [])

    def test_own_law(self):
        found, printed, _ = executed("own-law")
        self.assertLess(found["difference"], 1e-9)
        self.assertEqual(len(found["mine"]), len(found["theirs"]))
        self.assertNotEqual(found["peaks"][0.2], found["peaks"][0.4])
        self.assertIn("kink", printed.splitlines()[-1])
        self.assertIn("below 0.6", printed.splitlines()[-1])

    def test_size_effect(self):
        found, _, _ = executed("size-effect")
        mean = found["strengths"].mean(axis=1)
        self.assertTrue((mean[:-1] > mean[1:]).all(), mean)
        low, high = found["samples"].min(axis=0), found["samples"].max(axis=0)
        self.assertGreater(found["transition"], 0)
        self.assertTrue((low < high).all())


if __name__ == "__main__":
    unittest.main()
