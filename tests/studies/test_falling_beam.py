"""The pictures of falling-beam, on large blocks. `python3 test_falling_beam.py PROGRAM`."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from PIL import Image

STUDY = Path(__file__).resolve().parents[2] / "studies" / "falling-beam" / "study.py"
PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else None


class Pictures(unittest.TestCase):
    def test_strip_and_animation(self):
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run([sys.executable, "-B", str(STUDY), "--program", PROGRAM, "--quick", "--output", scratch],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            strip = (Path(scratch) / "collapse.svg").read_text(encoding="utf-8")
            for text in ("intact", "peak", "snapped back", "torn", "at rest"):
                self.assertIn(text, strip)
            with Image.open(Path(scratch) / "collapse.gif") as picture:
                self.assertGreater(picture.n_frames, 20)


if __name__ == "__main__":
    unittest.main()
