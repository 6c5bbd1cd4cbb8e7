"""An installation of the build that the environment variable BUILD names, in a folder of its own."""
import os
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["BUILD"])
THREADS = {"OMP_NUM_THREADS": "1"}


def scratch(case):
    """A folder that lasts as long as the test case (or class)."""
    folder = tempfile.TemporaryDirectory(prefix="dda install ")
    (case.addClassCleanup if isinstance(case, type) else case.addCleanup)(folder.cleanup)
    return Path(folder.name).resolve()


def called(*words, folder=None, environment=None):
    """What a command gave and said."""
    return subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True, check=False,
                          env={**os.environ, **THREADS, **(environment or {})})


def install(prefix):
    done = called("cmake", "--install", BUILD, "--prefix", prefix)
    if done.returncode != 0:
        raise RuntimeError(done.stdout + done.stderr)
    return prefix
