"""Whole runs of the program: the deck written, the process timed from its start to its end, the results read."""

import csv
import json
import os
import resource
import statistics
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

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


def results(folder):
    """summary.json, and curve.csv as one dictionary of numbers per row."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    with (folder / "curve.csv").open(newline="", encoding="utf-8") as stream:
        rows = [{name: number(text) for name, text in row.items()} for row in csv.DictReader(stream)]
    return summary, rows


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def of_children():
    """Processor seconds of all processes that were started and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def timed(program, deck, folder):
    """Elapsed and processor seconds of one process, and how it ended."""
    command = [program, "run", deck, "--folder", folder, "--overwrite", "--quiet"]
    before, start = of_children(), time.perf_counter()
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=LIMIT,
                              env=os.environ | {"OMP_NUM_THREADS": "1"})
    except subprocess.TimeoutExpired:
        done = subprocess.CompletedProcess(command, -1, "", f"given up after {LIMIT:g} s")
    return (time.perf_counter() - start, of_children() - before), done


def complaint(done):
    """Why a process failed, in one line."""
    if done.returncode < -1:
        return f"ended by signal {-done.returncode}"
    said = (done.stderr or done.stdout).strip().splitlines()
    return said[0] if said else f"exit code {done.returncode}"


def not_tried():
    return Measured(float("nan"), float("nan"), 0, float("nan"), "not tried: failed twice on coarser blocks")


def measure(program, deck, error, repeats, folder):
    """Runs a deck `repeats` times. `error` is a function of (summary, rows, run folder); it raises ValueError
    where a run ended too early to tell."""
    file, run = Path(folder) / "deck.json", Path(folder) / "run"
    file.write_text(json.dumps(deck), encoding="utf-8")
    times = []
    while len(times) < repeats and not (times and times[0][0] > LONG_RUN):
        taken, done = timed(program, file, run)
        if done.returncode not in GOOD_EXITS:
            return Measured(*taken, 0, float("nan"), complaint(done))
        times.append(taken)
    summary, rows = results(run)
    try:
        found, note = error(summary, rows, run), ""
    except ValueError as failure:
        found, note = float("nan"), f"{failure}: {summary['reason']}"
    elapsed, processor = map(statistics.median, zip(*times))
    return Measured(elapsed, processor, summary["blocks"], found, note)
