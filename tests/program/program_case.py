"""What tests of the program share: a scratch folder and the program in it."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import ddapath


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
