"""`python -m ddapath COMMAND ...`: what `dda COMMAND ...` does, wherever the program is; `verify`, `animate` and `scene` in this
Python."""
import importlib
import os
import subprocess
import sys

from .errors import ProgramNotFound
from .program import find_program

OF_PYTHON = {"verify": "verify", "animate": "animation", "scene": "scenes"}
SCENE = "`python -m ddapath scene`, which is of this package alone, makes a deck of a picture, a drawing or a mesh."


def is_unknown(program, word):
    said = "" if word.startswith("-") else subprocess.run([program, word, "--help"], capture_output=True, text=True, check=False).stderr
    return "unknown command" in said


def main(words):
    if words and words[0] in OF_PYTHON:
        return importlib.import_module(f"ddapath.{OF_PYTHON[words[0]]}.__main__").main(words[1:])
    try:
        program = find_program()
    except ProgramNotFound as error:
        print(f"ddapath: {error}", file=sys.stderr)
        return 4
    if words and (words[0] in ("--help", "-h") or is_unknown(program, words[0])):
        code = subprocess.run([program, *words], check=False).returncode
        print(SCENE, file=sys.stderr if code else sys.stdout)
        return code
    os.execv(program, [program, *words])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
