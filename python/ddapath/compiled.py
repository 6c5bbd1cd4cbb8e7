"""The compiled part of the package, `_core`: the program's own code, built and installed beside the program.

It lies in lib/ddapath of the installation of the program that `find_program` gives, so that both are of one build.
"""

import importlib.machinery
import importlib.util
import sys
from functools import cache
from pathlib import Path

from .errors import ProgramNotFound
from .program import find_program

NAME = "ddapath._core"


def library():
    """The file of `_core` for this Python. Throws ProgramNotFound, which says what to do, where there is none."""
    program = Path(find_program()).resolve()
    folder = program.parents[1] / "lib" / "ddapath"
    for suffix in importlib.machinery.EXTENSION_SUFFIXES:
        file = folder / f"_core{suffix}"
        if file.exists():
            return file
    others = ", ".join(sorted(file.name for file in folder.glob("_core.*.so")))
    version = f"Python {sys.version_info.major}.{sys.version_info.minor}"
    if others:
        raise ProgramNotFound(f"{folder}: has {others}, which is not for this {version}; use the Python that it was built for")
    raise ProgramNotFound(f"{folder}: has no compiled module for {version}, which `follow` needs: install pybind11-dev and "
                          f"python3-dev, and build the program again; `run` does without")


@cache
def core():
    """The module; it is loaded when something first asks for it, since most of the package does without."""
    file = library()
    loader = importlib.machinery.ExtensionFileLoader(NAME, str(file))
    module = importlib.util.module_from_spec(importlib.util.spec_from_file_location(NAME, file, loader=loader))
    loader.exec_module(module)
    sys.modules[NAME] = module
    return module
