"""Code blocks of the pages, which are Markdown, and the commands in them.

    blocks(text)            -> [Block(language, title, text, line, over, place)], fenced and indented ones; `over` and `place`
                               are those of a fragment (fragments.py)
    commands(block)         -> [[word, ...]], what it starts by ./bootstrap or as dda, without loops and pipes
"""

import re
import shlex
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "python/README.md", ROOT / "tests/robustness/README.md",
         *sorted((ROOT / "docs").rglob("*.md")), *sorted((ROOT / "studies").glob("*/README.md"))]
TUTORIALS = [ROOT / "docs/first-beam.md", *sorted((ROOT / "docs/tutorials").glob("*.md"))]
PROGRAMS = ("./bootstrap", "dda", "build/release/bin/dda")
OVER = re.compile(r"<!-- over: (\S+)(?: at (\S+))? -->")
FENCE = re.compile(r"^( *)```(\w*)(?: title=\"([^\"]+)\")?$")


class Block(NamedTuple):
    language: str
    title: str
    text: str
    line: int
    over: str = ""
    place: str = ""


def blocks(text):
    lines, out, k = text.split("\n"), [], 0
    while k < len(lines):
        begin, fence = k, FENCE.match(lines[k])
        if fence:
            k += 1
            while not lines[k].strip() == "```":
                k += 1
            inside = [line[len(fence[1]):] for line in lines[begin + 1:k]]
            over = OVER.fullmatch(lines[begin - 1].strip()) if begin > 0 else None
            out.append(Block(fence[2], fence[3] or "", "\n".join(inside) + "\n", begin + 1, *(over.groups("") if over else ())))
        elif lines[k].startswith("    ") and (k == 0 or not lines[k - 1].strip() or lines[k - 1].startswith("#")):
            while k < len(lines) and lines[k].startswith("    "):
                k += 1
            out.append(Block("", "", "\n".join(line[4:] for line in lines[begin:k]) + "\n", begin + 1))
        k += 1
    return out


def parts(words):
    """A line of a shell as the commands that it consists of."""
    out = [[]]
    for word in words:
        if word.rstrip(";") != word or word in ("&&", "||", "|", ";"):
            out[-1] += [word.rstrip(";")] if word.rstrip(";") not in ("", "&&", "||", "|") else []
            out.append([])
        else:
            out[-1].append(word)
    return out


def commands(block):
    if block.language not in ("", "bash"):
        return []
    out = []
    for line in block.text.replace("\\\n", " ").split("\n"):
        if line.lstrip().startswith(PROGRAMS):
            out += [part for part in parts(shlex.split(line, comments=True)) if part and part[0] in PROGRAMS]
    return out
