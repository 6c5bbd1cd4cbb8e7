"""`python -m ddapath COMMAND ...`: what `dda COMMAND ...` does, wherever the program is; `verify`, `animate` and `scene` in this
Python."""
import importlib
import os
import sys

from .errors import ProgramNotFound
from .program import find_program

OF_PYTHON = {"verify": "verify", "animate": "animation", "scene": "scenes"}


def main(words):
    if words and words[0] in OF_PYTHON:
        return importlib.import_module(f"ddapath.{OF_PYTHON[words[0]]}.__main__").main(words[1:])
    try:
        program = find_program()
    except ProgramNotFound as error:
        print(f"ddapath: {error}", file=sys.stderr)
        return 4
    os.execv(program, [program, *words])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
