"""Reads what the program `dda` wrote, writes decks and starts the program.

    import ddapath
    run = ddapath.read_run("runs/notched-beam")                     # .curve .summary .deck .log .fields(step)
    table = ddapath.read_sweep("runs/size-effect")                  # a DataFrame, one row per case
    run = ddapath.run("deck.yaml", {"path.stop.load_below": 0.2}, folder="runs/one")
    for point in ddapath.follow("deck.yaml"):                       # each as soon as it is found: .load .displacements ...
        print(point.step, point.load)
    table = ddapath.sweep("deck.yaml", {"scene.parameters.depth": [50, 100, 200]}, folder="runs/sizes")

Tables are pandas DataFrames with the unit of each column in `attrs["units"]`; "" where there is none.
"""

from .controls import Control, register_control
from .deck import read_deck, write_deck
from .declared import Number
from .errors import (DdapathError, InputError, Interrupted, NotFound, NothingStored, OutputError, ProgramFailed,
                     ProgramNotFound, StoppedEarly)
from .fields import Fields, Mesh
from .laws import InterfaceLaw, SofteningCurve, register_law, respond
from .loads import Load, register_load
from .program import check, find_program, report, resume, run, sweep
from .run_folder import Run, read_run
from .stepping import Path, Point, follow
from .sweep_folder import read_sweep

__all__ = ["Control", "DdapathError", "Fields", "InputError", "InterfaceLaw", "Interrupted", "Load", "Mesh", "NotFound",
           "NothingStored", "Number", "OutputError", "Path", "Point", "ProgramFailed", "ProgramNotFound", "Run",
           "SofteningCurve", "StoppedEarly", "check", "find_program", "follow", "read_deck", "read_run", "read_sweep",
           "register_control", "register_law", "register_load", "report", "respond", "resume", "run", "sweep", "write_deck"]
