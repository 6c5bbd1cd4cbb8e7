"""bootstrap on a toy project: packages, configuration, build, and what is handed on. Nothing is installed."""

import unittest

from toy import CMAKE, Toy


class Commands(unittest.TestCase):
    def setUp(self):
        self.toy = Toy(self)

    def test_help_needs_nothing(self):
        for arguments in ([], ["help"], ["--help"]):
            result = self.toy.run(*arguments)
            self.assertEqual(result.returncode, 0)
            self.assertIn("Usage: ./bootstrap", result.stdout)
        self.assertEqual(self.toy.calls("dpkg-query"), [])

    def test_unknown_command(self):
        result = self.toy.run("rum", "deck.yaml")
        self.assertEqual(result.returncode, 2)
        self.assertIn("unknown command 'rum'", result.stderr)
        self.assertEqual(self.toy.calls("dpkg-query"), [])

    def test_packages_are_unique(self):
        names = self.toy.run("packages").stdout.split()
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("libtrilinos-nox-dev", names)

    def test_packages_come_in_groups(self):
        groups = {group: self.toy.run("packages", group).stdout.split() for group in ("run", "python", "site", "test")}
        self.assertEqual(sum(groups.values(), []), self.toy.run("packages").stdout.split())
        self.assertIn("libgmsh-dev", groups["run"])
        self.assertIn("python3-h5py", groups["python"])
        self.assertIn("mkdocs", groups["site"])
        self.assertIn("chromium", groups["test"])
        result = self.toy.run("packages", "tests")
        self.assertEqual(result.returncode, 2)
        self.assertIn("has the groups run, python, site and test, not 'tests'", result.stderr)


class Packages(unittest.TestCase):
    # All but two are there; one of these is known to dpkg and removed.
    SOME = """shift 2
for package; do case $package in
  libgmsh-dev) ;;
  cmake) echo "config-files $package" ;;
  *) echo "installed $package" ;;
esac; done
exit 1"""

    def setUp(self):
        self.toy = Toy(self)

    def test_nothing_is_done_when_all_are_there(self):
        self.assertEqual(self.toy.run("build").returncode, 0)
        self.assertEqual(self.toy.calls("apt-get"), [])

    def test_only_what_is_missing_is_installed(self):
        self.toy.tool("dpkg-query", self.SOME)
        result = self.toy.run("build")
        self.assertEqual(result.returncode, 0, result.stderr)
        update, sizes, install = self.toy.calls("apt-get")
        self.assertTrue(update.endswith(" update"))
        self.assertIn(" --print-uris ", sizes)
        self.assertTrue(install.endswith(" install --no-install-recommends cmake libgmsh-dev"), install)

    def test_a_run_asks_for_nothing_of_tests(self):
        asked = {"run": (["libgmsh-dev"], ["python3-h5py", "chromium"]), "verify": (["libgmsh-dev", "python3-h5py"], ["chromium"]),
                 "build": (["libgmsh-dev", "python3-h5py", "chromium"], [])}
        for command, (needed, others) in asked.items():
            self.toy.log.unlink(missing_ok=True)
            self.toy.run(command, "deck.yaml")
            query = self.toy.log.read_text(encoding="utf-8").split()
            self.assertEqual([name for name in needed if name not in query], [], command)
            self.assertEqual([name for name in others if name in query], [], command)

    def test_what_is_to_be_downloaded_is_said_before(self):
        self.toy.tool("dpkg-query", self.SOME)
        self.toy.tool("apt-get", """case "$*" in *--print-uris*)
echo "'http://a/cmake.deb' cmake.deb 8700000 SHA256:1"
echo "'http://a/gmsh.deb' gmsh.deb 3300000 SHA256:2";; esac""")
        said = self.toy.run("build").stderr
        self.assertIn("installing 2 Debian packages (to download: 12 MB in 2 packages): cmake libgmsh-dev", said)

    def test_tests_are_configured_when_they_are_asked_for(self):
        cache = self.toy.root / "build" / "release" / "CMakeCache.txt"
        for command, built in (("run", "OFF"), ("test", "ON"), ("run", "ON")):
            self.toy.run(command)
            self.assertIn(f"DDA_BUILD_TESTS:BOOL={built}\n", cache.read_text(encoding="utf-8"), command)

    def test_sudo_only_if_not_root(self):
        self.toy.tool("dpkg-query", self.SOME)
        self.toy.tool("id", "echo 1000")
        self.toy.tool("sudo", '[ "$1" = -v ] || exec "$@"')
        self.assertEqual(self.toy.run("build").returncode, 0)
        self.assertEqual(len(self.toy.calls("sudo")), 3)
        self.assertEqual(len(self.toy.calls("apt-get")), 3)  # sizes are told to anyone

    def test_failed_installation_shows_why(self):
        self.toy.tool("dpkg-query", self.SOME)
        self.toy.tool("apt-get", 'case "$*" in *install*) echo "E: Unable to locate package"; exit 100;; esac')
        result = self.toy.run("build")
        self.assertEqual(result.returncode, 4)
        self.assertIn("E: Unable to locate package", result.stderr)
        self.assertIn("Debian 12", result.stderr)

    def test_stale_package_lists_do_not_stop_it(self):
        self.toy.tool("dpkg-query", self.SOME)
        self.toy.tool("apt-get", 'case "$*" in *update*) exit 100;; esac')
        self.assertEqual(self.toy.run("build").returncode, 0)

    def test_no_rights(self):
        self.toy.tool("dpkg-query", self.SOME)
        self.toy.tool("id", "echo 1000")
        self.toy.borrow("bash", "dirname", "sed", "grep")
        result = self.toy.run("build", only_tools=True)
        self.assertEqual(result.returncode, 4)
        self.assertIn("apt-get install --no-install-recommends cmake libgmsh-dev", result.stderr)

    def test_not_debian(self):
        (self.toy.tools / "dpkg-query").unlink()
        self.toy.borrow("bash", "dirname")
        result = self.toy.run("build", only_tools=True)
        self.assertEqual(result.returncode, 4)
        self.assertIn("not a Debian system", result.stderr)


class Builds(unittest.TestCase):
    def setUp(self):
        self.toy = Toy(self)

    def test_dda_gets_arguments_and_folder_and_keeps_its_exit_code(self):
        elsewhere = self.toy.root.parent / "my decks"
        elsewhere.mkdir()
        result = self.toy.run("run", "deck.yaml", "--set", "a=b c", folder=elsewhere)
        self.assertEqual(result.returncode, 3)
        self.assertEqual(result.stdout, f"arguments: run deck.yaml --set a=b c\nfolder: {elsewhere}\n")

    def test_a_failing_configuration_is_shown(self):
        self.toy.write("CMakeLists.txt", CMAKE + 'message(FATAL_ERROR "no such library")')
        result = self.toy.run("run", "deck.yaml")
        self.assertEqual(result.returncode, 4)
        self.assertIn("no such library", result.stderr)

    def test_a_failing_build_is_shown_without_its_progress_and_can_be_repaired(self):
        self.toy.write("CMakeLists.txt", CMAKE + "add_custom_target(broken ALL COMMAND echo oh dear && false)")
        result = self.toy.run("build")
        self.assertEqual(result.returncode, 4)
        self.assertIn("oh dear", result.stderr)
        self.assertNotIn("[1/", result.stderr)
        self.toy.write("CMakeLists.txt", CMAKE)
        self.assertEqual(self.toy.run("build").returncode, 0)

    def test_a_moved_project_is_configured_again(self):
        self.assertEqual(self.toy.run("build").returncode, 0)
        self.toy.root = self.toy.root.rename(self.toy.root.parent / "moved")
        result = self.toy.run("build")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("configuring", result.stderr)


class Studies(unittest.TestCase):
    STUDY = """import os, pathlib, sys
print("arguments:", *sys.argv[1:])
print("folder:", pathlib.Path.cwd())
sys.exit(0 if os.access(sys.argv[2], os.X_OK) else 7)
"""

    def setUp(self):
        self.toy = Toy(self)
        for name in ("slow-beam", "fast-beam", "deck-only"):
            (self.toy.root / "studies" / name).mkdir(parents=True)
        for name in ("slow-beam", "fast-beam"):
            self.toy.write(f"studies/{name}/study.py", self.STUDY)

    def test_it_gets_the_built_program_arguments_and_folder(self):
        result = self.toy.run("study", "slow-beam", "--quick", "a b", folder=self.toy.tools)
        self.assertEqual(result.returncode, 0, result.stderr)
        program = self.toy.root / "build" / "release" / "bin" / "dda"
        self.assertEqual(result.stdout, f"arguments: --program {program} --quick a b\nfolder: {self.toy.tools}\n")

    def test_its_exit_code_is_kept(self):
        self.toy.write("studies/slow-beam/study.py", "raise SystemExit(5)")
        self.assertEqual(self.toy.run("study", "slow-beam").returncode, 5)

    def test_an_unknown_or_missing_name_lists_the_studies_and_builds_nothing(self):
        for arguments, said in (("slow", "unknown study 'slow'"), ("deck-only", "unknown study 'deck-only'"),
                                (".*", "unknown study '.*'"), ("", "unknown study ''")):
            result = self.toy.run("study", arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(said + "; there are: fast-beam slow-beam", result.stderr)
        result = self.toy.run("study")
        self.assertEqual(result.returncode, 2)
        self.assertIn("study needs a name; there are: fast-beam slow-beam", result.stderr)
        self.assertFalse((self.toy.root / "build").exists())


class Site(unittest.TestCase):
    def test_it_is_made_with_the_built_program_and_keeps_its_exit_code(self):
        toy = Toy(self)
        (toy.root / "docs/site").mkdir(parents=True)
        toy.write("docs/site/build.py", Studies.STUDY)
        result = toy.run("site", "--site", "a b", folder=toy.tools)
        self.assertEqual(result.returncode, 0, result.stderr)
        program = toy.root / "build" / "release" / "bin" / "dda"
        self.assertEqual(result.stdout, f"arguments: --program {program} --site a b\nfolder: {toy.tools}\n")
        toy.write("docs/site/build.py", "raise SystemExit(4)")
        self.assertEqual(toy.run("site").returncode, 4)


class Tests(unittest.TestCase):
    def setUp(self):
        self.toy = Toy(self)

    def test_all_run_under_one_summary_at_the_end(self):
        result = self.toy.run(script=".ci/run")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("100% tests passed, 0 tests failed out of 2", result.stdout)
        self.assertTrue(result.stdout.splitlines()[-1].startswith("Total Test time"))

    def test_label(self):
        for arguments in (["--label", "fast"], ["--label=fast"], ["-R", "quick"]):
            result = self.toy.run("test", *arguments)
            self.assertIn("0 tests failed out of 1", result.stdout)
            self.assertIn("quick", result.stdout)

    def test_nightly_tests_run_when_they_are_asked_for(self):
        self.toy.write("CMakeLists.txt", CMAKE + "add_test(NAME night COMMAND ${CMAKE_COMMAND} -E true)\n"
                       "set_tests_properties(night PROPERTIES LABELS nightly)\n")
        self.assertNotIn("night", self.toy.run("test").stdout)
        result = self.toy.run("test", "--label", "nightly")
        self.assertIn("0 tests failed out of 1", result.stdout)
        self.assertIn("night", result.stdout)

    def test_sanitizers_have_a_build_of_their_own(self):
        self.toy.write("CMakeLists.txt", CMAKE + """add_test(NAME options COMMAND sh -c "test $ASAN_OPTIONS = detect_leaks=0")
            set_tests_properties(options PROPERTIES LABELS fast)
            """)
        for arguments, count in ((["--label", "sanitizers"], 2), (["--label=sanitizers", "-R", "options"], 1)):
            result = self.toy.run("test", *arguments)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn(f"0 tests failed out of {count}", result.stdout)
        self.assertIn("-fsanitize=address", (self.toy.root / "build" / "asan" / "CMakeCache.txt").read_text(encoding="utf-8"))
        self.assertFalse((self.toy.root / "build" / "release").exists())

    def test_no_test_is_a_failure(self):
        self.assertNotEqual(self.toy.run("test", "--label", "quicker").returncode, 0)

    def test_exit_code_of_a_failed_test_is_kept(self):
        self.toy.write("CMakeLists.txt", CMAKE + "add_test(NAME wrong COMMAND ${CMAKE_COMMAND} -E false)")
        result = self.toy.run("test")
        self.assertEqual(result.returncode, 8)
        self.assertIn("1 tests failed out of 3", result.stdout)


if __name__ == "__main__":
    unittest.main()
