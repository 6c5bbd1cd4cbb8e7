"""The commands that pages show outside the tutorials, run as they stand there, loops and all, in a copy of the repository's studies;
paths stop after their first steps. What is not run here is named in elsewhere.py. `test_commands.py PROGRAM`.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from blocks import PAGES, TUTORIALS, blocks
from elsewhere import ELSEWHERE

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = str(Path(sys.argv.pop(1)).resolve())
BEGINS = re.compile(r"(\./bootstrap|dda|build/release/bin/\w+|cmake|ctest|mpirun|cp|for|decks=|PYTHONPATH=\S+|(/usr/bin/)?python3?|\w+\.py) ")
# What commands of the manual ask for has been made by others.
BEFORE = ("studies/notched-beam/deck.yaml", "studies/falling-beam/deck.yaml")


def lines_of(block):
    """Logical lines of a block of commands; none of another block."""
    lines = block.text.replace("\\\n", " ").splitlines()
    is_shell = block.language == "bash" or block.language == "" and any(BEGINS.match(line) for line in lines)
    return [line for line in lines if line.strip()] if is_shell else []


def reason_of(line):
    """The entry of the list that a line falls under, None where it is to be run."""
    return next((begin for begin in ELSEWHERE if line.startswith(begin)), None)


class Commands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="dda pages ")
        cls.addClassCleanup(folder.cleanup)
        cls.root = Path(folder.name).resolve()
        shutil.copytree(ROOT / "studies", cls.root / "studies", ignore=shutil.ignore_patterns("dda", "__pycache__"))
        for name in ("tests", "python", "examples"):
            (cls.root / name).symlink_to(ROOT / name)
        for name in ("bootstrap", "build/release/bin/dda", "tools/dda"):
            (cls.root / name).parent.mkdir(parents=True, exist_ok=True)
            (cls.root / name).symlink_to(ROOT / "tests/site/shortened.py")
        cls.environment = {**os.environ, "PROGRAM": PROGRAM, "PATH": f"{cls.root / 'tools'}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1"}
        for deck in BEFORE:
            cls.shell(f"./bootstrap run {deck} --quiet").check_returncode()

    @classmethod
    def shell(cls, script):
        return subprocess.run(["/bin/bash", "-euc", script], cwd=cls.root, env=cls.environment, capture_output=True, text=True, check=False)

    def test_they_run(self):
        used, count = set(), 0
        for page in PAGES:
            for block in blocks(page.read_text(encoding="utf-8")) if page not in TUTORIALS else ():
                lines = lines_of(block)
                used |= {reason_of(line) for line in lines}
                script = "\n".join(line for line in lines if not reason_of(line))
                if script:
                    with self.subTest(page=page.relative_to(ROOT).as_posix(), line=block.line):
                        done = self.shell(script)
                        self.assertEqual(done.returncode, 0, f"{script}\n{done.stdout}{done.stderr}")
                        count += 1
        self.assertGreater(count, 50)
        self.assertEqual(set(ELSEWHERE) - used, set(), "the list names what no page shows")

    def test_what_is_run_elsewhere_is_there(self):
        for begin, reason in ELSEWHERE.items():
            for file in re.findall(r"tests/\S+?\.(?:py|sh)", reason):
                self.assertTrue((ROOT / file).is_file(), f"{begin}: {file}")


if __name__ == "__main__":
    unittest.main()
