"""`pip install ./python` in an environment of its own: nothing is downloaded to build it, the program is found, and the first
notebook runs there."""
import shutil
import unittest
import zipfile

from installation import ROOT, called, install, scratch
from PIL import Image


class InAnEnvironment(unittest.TestCase):
    """A virtual environment, which sees Debian's modules, and a copy of the package's source."""

    @classmethod
    def setUpClass(cls):
        cls.work = scratch(cls)
        cls.source = shutil.copytree(ROOT / "python", cls.work / "python", ignore=shutil.ignore_patterns("__pycache__"))
        done = called("/usr/bin/python3", "-m", "venv", "--system-site-packages", cls.work / "env")
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)

    @classmethod
    def python(cls, *words, folder=None, **environment):
        return called(cls.work / "env/bin/python", *words, folder=folder or cls.work,
                      environment={"DDA": "", "PYTHONPATH": "", **environment})

    @classmethod
    def pip(cls, *words):
        done = cls.python("-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--force-reinstall", cls.source, *words)
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)

    def found(self, **environment):
        done = self.python("-c", "import ddapath; print(ddapath.__file__); print(ddapath.find_program())", **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        package, program = done.stdout.splitlines()
        self.assertIn("site-packages", package)
        return program


class Wheels(InAnEnvironment):
    def test_one_for_every_platform(self):
        self.pip()
        prefix = install(self.work / "prefix")
        self.assertEqual(self.found(DDA=str(prefix / "bin/dda")), str(prefix / "bin/dda"))
        self.assertEqual(self.found(PATH=f"{prefix / 'bin'}:/usr/bin:/bin"), str(prefix / "bin/dda"))
        done = self.python("-m", "ddapath", "run", "deck.yaml", PATH="/usr/bin:/bin")
        if not shutil.which("dda", path="/usr/bin:/bin"):
            self.assertEqual(done.returncode, 4)
            self.assertIn("there is no program dda: install it", done.stderr)

    def test_a_wrong_installation(self):
        done = self.python("-m", "pip", "wheel", "--quiet", "--no-index", "--no-deps", self.source, "--config-settings", "installation=/nowhere")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("installation=/nowhere: there is no bin/dda", done.stderr + done.stdout)

    def test_the_record_has_every_file(self):
        done = self.python("-m", "pip", "wheel", "--quiet", "--no-index", "--no-deps", self.source, "-w", "wheels")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        wheel, = (self.work / "wheels").glob("*.whl")
        self.assertEqual(wheel.name, "ddapath-0.1.0-py3-none-any.whl")
        with zipfile.ZipFile(wheel) as archive:
            recorded = [line.split(",")[0] for line in archive.read("ddapath-0.1.0.dist-info/RECORD").decode().splitlines()]
            self.assertEqual(sorted(recorded), sorted(archive.namelist()))
            self.assertIn("ddapath/verify/laws.py", recorded)


class WithTheProgram(InAnEnvironment):
    """The wheel that carries an installation, which is gone when it is used."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        prefix = install(cls.work / "carried")
        cls.pip("--config-settings", f"installation={prefix}")
        shutil.rmtree(prefix)
        shutil.rmtree(cls.source)

    def test_a_study_runs(self):
        program = self.found(PATH="/usr/bin:/bin")
        self.assertTrue(program.endswith("site-packages/ddapath/installation/bin/dda"), program)
        deck = ROOT / "studies/softening-bar/deck.yaml"
        script = f"import ddapath; print(ddapath.run({str(deck)!r}, folder='run', overwrite=True).status)"
        done = self.python("-c", script)
        self.assertEqual(done.stdout.strip(), "goal_reached", done.stderr)
        done = self.python("-m", "ddapath", "verify", "run")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_first_notebook(self):
        """From an empty folder, isolated: neither the folder of a script nor the environment's variables say where modules are."""
        empty, tools = self.work / "first", self.work / "tools"
        for folder in (empty, tools):
            folder.mkdir()
        for file in (ROOT / "tests/python/notebooks.py", ROOT / "examples/notebooks/first-beam.ipynb"):
            shutil.copy(file, tools)
        done = self.python("-I", tools / "notebooks.py", tools / "first-beam.ipynb", folder=empty, PATH="/usr/bin:/bin")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("interface points", done.stdout)
        self.assertIn("goal_reached", done.stdout)
        self.assertRegex(done.stdout, r"peak load \d+ N at a deflection of 0\.\d+ mm")
        self.assertEqual(sorted(file.name for file in empty.iterdir()), ["figure-1.png", "figure-2.png"])
        for file in empty.iterdir():
            with Image.open(file) as figure:
                drawn = sum(figure.convert("L").histogram()[:250])
                self.assertGreater(drawn, 0.005 * figure.width * figure.height, file.name)


if __name__ == "__main__":
    unittest.main()
