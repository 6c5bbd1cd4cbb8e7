"""The texts with which a path may stop early, from the sources of the program.

    endings(root) -> {file: [text]}; `{}` stands for what is put in
"""

import re

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
# Where a reason is given, and functions whose texts become one.
GIVEN = re.compile(r"(?:stopped_early,|(?:stop_early\(|end_without_equilibrium\(path,)\s*Stop::\w+,)")
MAKERS = re.compile(r"\b(?:obstacle|(?:energy_)?objection(?:_to)?|require_apart|Motion::advance)\([^;{]*\{|\bout_of_range =")


def closed(text, begin, pair):
    """The end of what a bracket before `begin` has opened; literals do not count."""
    bare = LITERAL.sub(lambda literal: "_" * len(literal[0]), text)
    depth = 1
    for k in range(begin, len(bare)):
        depth += (bare[k] == pair[0]) - (bare[k] == pair[1])
        if depth == 0:
            return k
    return len(text)


def texts_in(piece):
    """Literals of a piece of C++, those that follow each other as one."""
    joined = re.sub(r'"\s*\n\s*"', "", piece)
    return [literal for literal in LITERAL.findall(joined) if " " in literal.strip()]


def endings_of(text):
    out = []
    for match in GIVEN.finditer(text):
        end = min(closed(text, match.end(), "()"), closed(text, match.end(), "{}"))
        out += texts_in(text[match.end():end])
    for match in MAKERS.finditer(text):
        is_function = match[0].endswith("{")
        end = closed(text, match.end(), "{}") if is_function else text.index(";", match.end())
        out += texts_in(text[match.end():end])
    return out


def endings(root):
    files = [*sorted((root / "continuation").rglob("*.cpp")), *sorted((root / "studies/dda/run").glob("*.cpp"))]
    found = {file.relative_to(root).as_posix(): endings_of(file.read_text(encoding="utf-8")) for file in files}
    return {file: texts for file, texts in found.items() if texts}
