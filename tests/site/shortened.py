#!/usr/bin/python3
"""`./bootstrap` and `dda` as the commands of pages meet them in test_commands.py: PROGRAM with the first steps of every path and the
first moment of every motion, into folders that may have been used. `shortened.py ARGUMENTS`, with PROGRAM in the environment.
"""

import os
import sys
from pathlib import Path

STEPS, MOMENT = 2, 1e-4  # [s]


def has(deck, section):
    return any(line.startswith(f"{section}:") for line in deck.read_text(encoding="utf-8").splitlines())


def words(given):
    name, *rest = given
    if name not in ("run", "compare", "sweep"):
        return given
    deck = Path(rest[0])
    short = [f"path.stop.after_steps={STEPS}"] if has(deck, "stages") else []
    short += [f"motion.time={MOMENT}"] if has(deck, "motion") else []
    return [name, *rest, "--overwrite", *(word for one in short for word in ("--set", one))]


os.environ["OMP_NUM_THREADS"] = "1"
os.execv(os.environ["PROGRAM"], ["dda", *words(sys.argv[1:])])
