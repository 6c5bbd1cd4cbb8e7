"""Rules about the house as a whole, as functions from all its files to findings `path: message`.

Folders do not include each other in circles: of two that do, neither can be read without the other. In `studies/` the
program is one folder, and every other one is a study. Source: CONTRIBUTING.md.
"""

import posixpath
from collections import defaultdict

import rules

PROGRAM = "studies/dda"


def folder_includes(texts):
    """{folder: {folder it includes: (file, line)}} of {path: text}; only files of the house count."""
    out = defaultdict(dict)
    for path, text in texts.items():
        if rules.folder_of(path) is None:
            continue
        own = posixpath.dirname(path)
        for line, header in rules.includes(text):
            other = posixpath.dirname(header)
            if header in texts and other != own:
                out[own].setdefault(other, (path, line))
    return out


def reached(graph, start):
    """Folders that includes lead to from a folder, itself only if they lead back."""
    found, waiting = set(), [start]
    while waiting:
        new = graph.get(waiting.pop(), {}).keys() - found
        found |= new
        waiting += new
    return found


def circle_findings(texts):
    graph = folder_includes(texts)
    reach = {folder: reached(graph, folder) for folder in graph}
    for own, others in graph.items():
        for other, (path, line) in others.items():
            if own in reach.get(other, ()):
                yield f"{path}:{line}: {own} includes {other}, which leads back to {own}: folders in a circle"


def studies_findings(paths):
    names = {path.split("/")[1] for path in paths if path.startswith("studies/") and path.count("/") > 1}
    for path in paths:
        if not path.startswith("studies/") or path == "studies/CMakeLists.txt":
            continue
        if path.count("/") == 1:
            yield f"{path}: a file of the program belongs to {PROGRAM}/, one of a study to its folder"
        elif path.endswith((".cpp", ".hpp")) and not path.startswith(PROGRAM + "/"):
            yield f"{path}: C++ of the program belongs to {PROGRAM}/"
    for name in sorted(names - {"dda"}):
        if f"studies/{name}/README.md" not in paths:
            yield f"studies/{name}: a study has a README.md"


def findings(texts):
    """Everything wrong with the house that consists of these files, {path: text}."""
    return [*circle_findings(texts), *studies_findings(texts)]
