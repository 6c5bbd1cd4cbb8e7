"""The rules that the folders of the house obey, as functions from one file's text to findings.

Includes run one way, framework <- meshing <- models <- continuation <- studies; a third-party library is visible
in one folder; files stay short. A finding is (line, message); a clean file has none. Source: CONTRIBUTING.md.
"""

import posixpath
import re
from dataclasses import dataclass

FOLDERS = ("framework", "meshing", "models", "continuation", "studies")
LONGEST_FILE = 400
UNFINISHED = re.compile(r"\b(" + "TO" + "DO|" + "FIX" + r"ME)\b")
INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')


@dataclass(frozen=True)
class Library:
    """A third-party library: the headers it is known by and the one folder that may see it."""

    name: str
    headers: str
    folder: str
    only_cpp: bool = False

    def owns(self, header):
        return re.match(self.headers, header) is not None


TRILINOS = r"(NOX|LOCA|Tpetra|Teuchos|Amesos2|Thyra|Anasazi|Belos|Kokkos|Stratimikos|Epetra|Xpetra|Ifpack2|MueLu)"

LIBRARIES = (
    Library("gmsh", r"gmsh(c|_cwrap|_cpp)?\.h", "meshing", only_cpp=True),
    Library("GEOS", r"geos(_c\.h|/|\.h)", "meshing", only_cpp=True),
    Library("Trilinos", TRILINOS + r"\w*\.(H|h|hpp)", "continuation"),
    Library("MUMPS", r"[sdcz]mumps_", "continuation"),
    Library("SuiteSparse", r"(suitesparse/)?(cholmod|umfpack|klu)\.h", "continuation"),
    Library("MPI", r"mpi\.h", "continuation"),
    Library("HDF5", r"(hdf5/\w+/)?(hdf5|hdf5_hl|H5\w*)\.h", "framework", only_cpp=True),
    Library("zlib", r"zlib\.h", "framework", only_cpp=True),
    Library("libyaml", r"yaml\.h", "framework", only_cpp=True),
    Library("muParser", r"muParser\w*\.h", "framework", only_cpp=True),
    Library("CLI11", r"CLI/", "studies"),
    Library("pybind11", r"pybind11/", "python"),
)


def folder_of(path):
    """The folder of the house that a path lies in, None outside."""
    first = path.split("/", 1)[0]
    return first if first in FOLDERS else None


def target_folder(path, header):
    """The folder that an include of `path` reaches, also by a relative name such as "../models/x.hpp"."""
    if ".." in header.split("/"):
        header = posixpath.normpath(posixpath.join(posixpath.dirname(path), header))
    return folder_of(header)


def direction_finding(path, header):
    own, target = folder_of(path), target_folder(path, header)
    if target is None or FOLDERS.index(target) <= FOLDERS.index(own):
        return None
    return f"{own} must not include {header}: includes run {' <- '.join(FOLDERS)}"


def library_finding(path, header):
    for library in LIBRARIES:
        if not library.owns(header):
            continue
        if folder_of(path) != library.folder:
            return f"{header}: {library.name} is visible in {library.folder} only"
        if library.only_cpp and not path.endswith(".cpp"):
            return f"{header}: {library.name} is visible in .cpp files only"
    return None


def includes(text):
    """(line, header) of every include."""
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1)


def include_findings(path, text):
    if folder_of(path) is None:  # tests may see everything
        return
    for number, header in includes(text):
        for finding in (direction_finding(path, header), library_finding(path, header)):
            if finding:
                yield number, finding


def length_findings(text):
    lines = len(text.splitlines())
    if lines > LONGEST_FILE:
        yield lines, f"{lines} lines; a file has at most {LONGEST_FILE}"


def unfinished_findings(text):
    for number, line in enumerate(text.splitlines(), 1):
        match = UNFINISHED.search(line)
        if match:
            yield number, f"{match.group(1)}: open an issue instead"


def findings(path, text):
    """Everything wrong with the file at `path` (relative to the root, with slashes)."""
    return [*include_findings(path, text), *length_findings(text), *unfinished_findings(text)]
