"""Whole runs of the program, repeated: the medians of their times, and the error of what came out."""

import statistics
from dataclasses import dataclass

from ddapath import study

LONG_RUN = 1.0  # seconds; a longer run is not repeated: what disturbs it is small against its own time
LIMIT = 20.0  # seconds; a run that takes longer is given up
GOOD_EXITS = (0, 3)  # goal reached, stopped early


@dataclass(frozen=True)
class Measured:
    """One deck, run: medians over the whole processes, blocks, relative error; a note if it failed."""

    seconds: float  # elapsed
    processor: float  # seconds of user and system; does not see what else the machine does
    blocks: int
    error: float
    note: str = ""


def complaint(done):
    """Why a process failed, in one line."""
    if done.exit_code < study.GIVEN_UP:
        return f"ended by signal {-done.exit_code}"
    said = done.said.strip().splitlines()
    return said[0] if said else f"exit code {done.exit_code}"


def not_tried():
    return Measured(float("nan"), float("nan"), 0, float("nan"), "not tried: failed twice on coarser blocks")


def measure(deck, error, repeats, folder):
    """Runs a deck `repeats` times. `error` is a function of the Run; it raises ValueError where it ended too early to
    tell."""
    times = []
    while len(times) < repeats and not (times and times[0][0] > LONG_RUN):
        done = study.measured(deck, folder, limit=LIMIT)
        if done.exit_code not in GOOD_EXITS:
            return Measured(done.seconds, done.processor, 0, float("nan"), complaint(done))
        times.append((done.seconds, done.processor))
    summary = done.run.summary
    try:
        found, note = error(done.run), ""
    except ValueError as failure:
        found, note = float("nan"), f"{failure}: {summary['reason']}"
    elapsed, processor = map(statistics.median, zip(*times))
    return Measured(elapsed, processor, summary["blocks"], found, note)
