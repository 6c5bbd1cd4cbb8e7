"""An installation: complete, free of the build folder, and whole where it is moved to."""
import gzip
import re
import unittest

from installation import BUILD, ROOT, called, install, scratch

FILES = """bin/dda lib/ddapath/dda_gmsh.so lib/ddapath/dda_loca.so lib/ddapath/dda_mumps.so lib/cmake/ddapath/ddapathConfig.cmake
include/ddapath/models/interface/law.hpp include/ddapath/framework/plugin/interface.hpp share/ddapath/python/ddapath/verify/laws.py
share/ddapath/notebooks/own-law.ipynb share/ddapath/studies/notched-beam/deck.yaml share/ddapath/studies/notched-beam/beam.geo share/ddapath/plugin/straight_softening.cpp
share/doc/ddapath/CHANGELOG.md share/doc/ddapath/CITATION.cff share/man/man1/dda.1.gz share/man/man5/dda-deck.5.gz
share/bash-completion/completions/dda share/zsh/site-functions/_dda share/fish/vendor_completions.d/dda.fish""".split()


class Installation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = scratch(cls)
        cls.prefix = install(folder / "first").rename(folder / "moved away")
        cls.work = folder / "work"
        cls.work.mkdir()

    def dda(self, *words):
        return called(self.prefix / "bin" / "dda", *words, folder=self.work, environment={"PATH": "/usr/bin:/bin"})

    def binaries(self):
        return [self.prefix / "bin" / "dda", *sorted((self.prefix / "lib" / "ddapath").glob("*.so"))]

    def test_is_complete(self):
        self.assertEqual([name for name in FILES if not (self.prefix / name).is_file()], [])
        built = sorted(module.name for module in (BUILD / "lib" / "ddapath").glob("*.so"))
        self.assertEqual([binary.name for binary in self.binaries()], ["dda", *built])
        self.assertIn("dda_loca.so", built)

    def test_holds_neither_the_program_s_sources_nor_what_sees_trilinos(self):
        self.assertFalse((self.prefix / "share/ddapath/studies/dda").exists())
        self.assertFalse((self.prefix / "include/ddapath/continuation/modules").exists())

    def test_nothing_is_looked_for_in_the_build_folder(self):
        for binary in self.binaries():
            self.assertNotRegex(called("readelf", "-d", binary).stdout, "R(UN)?PATH", binary.name)
            self.assertNotIn(str(BUILD).encode(), binary.read_bytes(), binary.name)

    def test_a_study_runs_and_is_verified(self):
        deck = self.prefix / "share/ddapath/studies/notched-beam/deck.yaml"
        done = self.dda("run", deck, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.work / "runs/notched-beam/summary.json").is_file())
        checked = self.dda("verify", "runs/notched-beam")
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        page = self.dda("report", "runs/notched-beam")
        self.assertEqual(page.returncode, 0, page.stderr)

    def test_modules_of_the_current_folder_are_not_the_program_s(self):
        run = self.work / "runs" / "two-steps"
        done = self.dda("run", self.prefix / "share/ddapath/studies/softening-bar/deck.yaml", "--quiet", "--folder", run,
                        "--set", "path.stop.after_steps=2")
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.work / "copy.py").write_text("raise SystemExit('a file of the user has been run')\n", encoding="utf-8")
        for places in ("", ":", ":/nowhere"):
            done = called(self.prefix / "bin" / "dda", "verify", run, folder=self.work, environment={"PYTHONPATH": places})
            self.assertEqual(done.returncode, 0, places + done.stdout + done.stderr)

    def test_every_module_is_found(self):
        deck = self.prefix / "share/ddapath/studies/softening-bar/deck.yaml"
        for solver in ("mumps", "amesos2"):
            done = self.dda("run", deck, "--quiet", "--folder", solver, "--set", f"path.linear={solver}", "--set", "path.stop.after_steps=2")
            self.assertEqual(done.returncode, 0, solver + done.stderr)

    def test_the_package_finds_its_program(self):
        places = f"import sys; sys.path.insert(0, {str(self.prefix / 'share/ddapath/python')!r})"
        done = called("/usr/bin/python3", "-B", "-c", f"{places}; import ddapath; print(ddapath.find_program())", environment={"DDA": ""})
        self.assertEqual(done.stdout.strip(), str(self.prefix / "bin" / "dda"), done.stderr)

    def test_the_package_follows_a_path(self):
        if not list((BUILD / "lib" / "ddapath").glob("_core.*.so")):
            self.skipTest("built without pybind11")
        script = f"""import sys
sys.path.insert(0, {str(self.prefix / 'share/ddapath/python')!r})
import ddapath
deck = ddapath.read_deck({str(self.prefix / 'share/ddapath/studies/softening-bar/deck.yaml')!r})
print(ddapath.compiled.core().installation(), *(point.step for point in ddapath.follow(deck, {{"path.stop.after_steps": 3}})), sep=":")"""
        done = called("/usr/bin/python3", "-B", "-c", script, environment={"DDA": ""})
        self.assertEqual(done.stdout.strip(), f"{self.prefix}:1:2:3", done.stderr)

    def test_manual_pages_are_those_of_the_program(self):
        page = gzip.decompress((self.prefix / "share/man/man1/dda.1.gz").read_bytes()).decode()
        self.assertEqual(page, self.dda("man").stdout)
        self.assertIn(".SS \"dda resume RUN\"", page)


class Versions(unittest.TestCase):
    def test_all_files_tell_the_same(self):
        version = re.search(r"project\(ddapath VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        self.assertIn(f'\nversion = "{version}"\n', (ROOT / "python/pyproject.toml").read_text(encoding="utf-8"))
        self.assertIn(f"\nversion: {version}\n", (ROOT / "CITATION.cff").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
