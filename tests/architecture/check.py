"""Checks every source file of the tree against rules.py: `python3 check.py ROOT`. Exit 1 on findings."""

import sys
from pathlib import Path

import functions
import house
import rules

SUFFIXES = {".cpp", ".hpp", ".h", ".in", ".py", ".cmake", ".sh", ".js", ".css", ".html", ".md"}
NAMES = {"CMakeLists.txt", "bootstrap", "run"}


def is_source(path):
    return path.is_file() and (path.suffix in SUFFIXES or path.name in NAMES)


def sources(root):
    """Source files of the house, not what was built or computed in it."""
    tops = [root / name for name in (*rules.FOLDERS, "python", "tests", "cmake", ".ci")]
    found = [path for path in root.iterdir() if is_source(path)]
    for top in tops:
        found += [path for path in top.rglob("*") if is_source(path)]
    return sorted(found)


def check(root):
    """Lines `path:line: message`, and the number of files read."""
    texts = {file.relative_to(root).as_posix(): file.read_text(encoding="utf-8") for file in sources(root)}
    messages = []
    for path, text in texts.items():
        if not path.endswith(".md"):
            messages += [f"{path}:{line}: {message}" for line, message in rules.findings(path, text)]
    return messages + house.findings(texts) + functions.findings(root, texts), len(texts)


def main(root):
    messages, count = check(root)
    missing = [name for name in rules.FOLDERS if not (root / name).is_dir()]
    messages += [f"{name}: folder not found under {root}" for name in missing]
    print("\n".join(messages) if messages else f"{count} files obey the rules")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
