"""A toy project around the real bootstrap, and stand-ins for the commands that would change the machine."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

CMAKE = """
cmake_minimum_required(VERSION 3.25)
project(toy LANGUAGES NONE)
add_custom_command(OUTPUT bin/dda COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/dda bin/dda DEPENDS dda)
add_custom_target(program ALL DEPENDS bin/dda)
enable_testing()
option(DDA_BUILD_TESTS "" ON)
add_test(NAME slow_but_sure COMMAND ${CMAKE_COMMAND} -E true)
add_test(NAME quick COMMAND ${CMAKE_COMMAND} -E true)
set_tests_properties(slow_but_sure PROPERTIES LABELS long)
set_tests_properties(quick PROPERTIES LABELS fast COST 10000)
"""

DDA = """#!/bin/sh
echo "arguments: $*"
echo "folder: $PWD"
exit 3
"""

ALL_INSTALLED = """
shift 2
for package; do echo "installed $package"; done
"""


class Toy:
    """The toy in a folder with a space in its name; `run` gives what bootstrap returned and printed."""

    def __init__(self, case):
        folder = tempfile.TemporaryDirectory(prefix="dda toy ")
        case.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "project"
        self.tools = self.root.parent / "tools"
        self.log = self.root.parent / "calls"
        self.root.mkdir()
        self.tools.mkdir()
        for name in ("bootstrap", "CMakePresets.json"):
            shutil.copy2(ROOT / name, self.root)
        shutil.copytree(ROOT / ".ci", self.root / ".ci")
        self.write("CMakeLists.txt", CMAKE)
        self.write("dda", DDA).chmod(0o755)
        self.tool("dpkg-query", ALL_INSTALLED)
        self.tool("apt-get")
        self.tool("id", "echo 0")

    def write(self, name, text):
        file = self.root / name
        file.write_text(text, encoding="utf-8")
        return file

    def tool(self, name, body=""):
        """Puts a command before the machine's own of that name; each call is logged."""
        file = self.tools / name
        file.write_text(f'#!/bin/sh\necho "{name} $*" >>"{self.log}"\n{body}\n', encoding="utf-8")
        file.chmod(0o755)

    def borrow(self, *names):
        """Makes the machine's own commands part of `tools`, for a PATH without anything else."""
        for name in names:
            (self.tools / name).symlink_to(shutil.which(name))

    def calls(self, name):
        lines = self.log.read_text(encoding="utf-8").splitlines() if self.log.exists() else []
        return [line for line in lines if line.split(" ", 1)[0] == name]

    def run(self, *arguments, script="bootstrap", folder=None, only_tools=False):
        path = str(self.tools) if only_tools else f"{self.tools}:{os.environ['PATH']}"
        return subprocess.run([str(self.root / script), *arguments], cwd=folder or self.root.parent, text=True,
                              capture_output=True, env={**os.environ, "PATH": path}, check=False)
