"""An installation of the build that the environment variable BUILD names, in a folder of its own."""
import os
import shutil
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


def built_plugin(prefix, folder):
    """The example of a plugin, copied to a folder and compiled there against an installation: its library."""
    shutil.copytree(prefix / "share/ddapath/plugin", folder)
    for step in (["-B", "build", "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={prefix}"], ["--build", "build"]):
        done = called("cmake", *step, folder=folder)
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)
    return folder / "build" / "straight_softening.so"
