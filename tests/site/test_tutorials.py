"""The tutorials run, each in an empty folder, and print what stands below their commands: `test_tutorials.py PROGRAM`, with
PYTHONPATH=python.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from blocks import TUTORIALS, blocks
from elsewhere import TOO_LONG

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = str(Path(sys.argv.pop(1)).resolve())
STOPS_EARLY = {"dda compare beam.yaml --controls staged,displacement,load"}  # the page says so
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def is_near(shown, printed):
    """Numbers within a hundredth; counts of steps and points within three, as the kernels of OpenBLAS leave them."""
    return abs(float(shown) - float(printed)) <= max(0.01 * abs(float(shown)), 3 * shown.isdigit())


def is_like(shown, printed):
    """Whether a line of a page is what was printed but for times, last digits, and what an ellipsis stands for."""
    shown, printed = (re.sub(r"\d[\d.]* s\b", "s", line).strip() for line in (shown, printed))
    pieces = re.split(f"({NUMBER.pattern})", shown)
    forms = [f"({NUMBER.pattern})" if NUMBER.fullmatch(piece) else re.escape(piece).replace("…", ".*?")
             for piece in pieces]
    match = re.fullmatch("".join(forms), printed)
    return match is not None and all(map(is_near, filter(NUMBER.fullmatch, pieces), match.groups()))


class Tutorials(unittest.TestCase):
    """Each in an empty folder, as a reader would."""

    def run_page(self, page, folder):
        tools = folder / "tools"
        tools.mkdir()
        (tools / "dda").symlink_to(PROGRAM)
        environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "OMP_NUM_THREADS": "1"}
        said = ""
        for block in blocks(page.read_text(encoding="utf-8")):
            if block.title:
                (folder / block.title).write_text(block.text, encoding="utf-8")
            elif block.language == "bash":
                said = "".join(self.run_line(line, folder, environment) for line in block.text.splitlines())
            elif block.language == "text":
                for line in block.text.splitlines():
                    self.assertTrue(any(is_like(line, printed) for printed in said.splitlines()),
                                    f"{page.name}:{block.line}: '{line}' is not in\n{said}")

    def run_line(self, line, folder, environment):
        if line.startswith(tuple(TOO_LONG)):
            return ""
        done = subprocess.run(["/bin/bash", "-c", line], cwd=folder, env=environment, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 3 if line in STOPS_EARLY else 0, f"{line}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def test_every_command_does_what_the_page_says(self):
        for page in TUTORIALS:
            with self.subTest(page=page.name), tempfile.TemporaryDirectory() as folder:
                self.run_page(page, Path(folder).resolve())


if __name__ == "__main__":
    unittest.main()
