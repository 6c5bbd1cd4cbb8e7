"""What tests of the program share: a scratch folder and the program in it."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify


class ProgramCase(unittest.TestCase):
    """Each test has an empty `self.folder`, where `self.dda` starts the program."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def dda(self, *words, code=0):
        """What `dda WORDS` says; it has to end with that exit code."""
        said = subprocess.run([str(ddapath.find_program()), *words], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(said.returncode, code, said.stdout + said.stderr)
        return said.stdout + said.stderr

    def run_verified(self, deck):
        """A run of the deck in the folder that reaches its goal and holds against all checks."""
        run = ddapath.run(deck, folder=self.folder / "run", check=False, overwrite=True)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        self.assertEqual([str(finding) for finding in verify(run.folder) if not finding.holds], [])
        return run
