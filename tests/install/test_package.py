"""The Debian package: what it holds, what it depends on, and that its program runs from where it is unpacked."""
import shutil
import unittest

from installation import BUILD, called, scratch


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not shutil.which("dpkg-shlibdeps"):
            raise unittest.SkipTest("there is no dpkg-dev")
        cls.work = scratch(cls)
        done = called("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", cls.work / "cpack")
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)
        cls.package, = (cls.work / "cpack").glob("*.deb")
        called("dpkg-deb", "-x", cls.package, cls.work / "root")

    def field(self, name):
        return called("dpkg-deb", "-f", self.package, name).stdout.strip()

    def test_it_depends_on_what_it_links_and_loads(self):
        depends = self.field("Depends")
        for package in ("libgmsh4", "libgeos-c1v5", "libtrilinos-nox", "libmumps-5", "libfmt9", "libc6", "python3-h5py", "python3-yaml"):
            self.assertIn(package, depends)

    def test_its_fields(self):
        self.assertEqual((self.field("Package"), self.field("Section")), ("ddapath", "science"))
        self.assertTrue(self.field("Version").startswith("0.1.0"))

    def test_what_policy_asks_for(self):
        usr = self.work / "root/usr"
        for name in ("share/doc/ddapath/copyright", "share/doc/ddapath/changelog.gz", "share/man/man1/dda.1.gz",
                     "share/zsh/vendor-completions/_dda", "lib/python3/dist-packages/ddapath/program.py"):
            self.assertTrue((usr / name).exists(), name)

    def test_a_study_runs(self):
        usr = self.work / "root/usr"
        done = called(usr / "bin/dda", "run", usr / "share/ddapath/studies/notched-beam/deck.yaml", "--quiet", folder=self.work)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_lintian_finds_no_errors(self):
        if not shutil.which("lintian"):
            self.skipTest("there is no lintian")
        done = called("lintian", "--allow-root", "--fail-on", "error", self.package)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
