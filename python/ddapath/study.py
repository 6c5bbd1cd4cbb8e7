"""What studies share: whole processes, measured; tables of results as CSV files; what a README says of them.

    asked = study.arguments(study.parser(__doc__), HERE)                 # .program .quick .output, and what it adds
    done = study.measured(deck, folder, {"path.control": "staged"})      # .exit_code .said .seconds .processor .run
    study.write_rows(file, rows, digits=6)
    study.write_region(README, text)                                     # between <!-- results: begin --> and end
"""

import argparse
import csv
import json
import os
import re
import resource
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from . import deck as decks
from .program import find_program, setting_options
from .run_folder import Run

GIVEN_UP = -1  # exit code of a process that took longer than its limit


@dataclass(frozen=True)
class Measured:
    """A whole process from its start to its end, and the run folder it has written to."""

    exit_code: int
    said: str
    seconds: float  # elapsed
    processor: float  # seconds of user and system; those of processes that end meanwhile count, too
    run: Run


def processor_seconds():
    """Of all processes that were started and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measured(deck, folder, settings=None, *, threads=1, limit=None, environment=None, program=None, launcher=()):
    """Runs a deck, a file or a dictionary, into a folder, whose results it replaces; any exit code is a result.

    settings: as those of ddapath.run; limit: seconds after which it is given up; environment: variables beside those
    of this process; program: that is run, by default the one of `dda`; launcher: words that start
    it, such as mpirun and its options.
    """
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        file = deck
        if isinstance(deck, dict):  # JSON is YAML, and sooner written
            file = Path(scratch) / "deck.json"
            file.write_text(json.dumps(decks.plain(decks.with_absolute_files(deck, Path.cwd()))), encoding="utf-8")
        command = [*launcher, program or find_program(), "run", file, "--folder", folder, "--overwrite", "--quiet", "--threads", str(threads),
                   *setting_options(settings)]
        before, start = processor_seconds(), time.perf_counter()
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=limit,
                                  env=os.environ | (environment or {}))
            ended = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired:
            ended = GIVEN_UP, f"given up after {limit:g} s"
        return Measured(*ended, time.perf_counter() - start, processor_seconds() - before, Run(folder))


class Runs:
    """Decks that are run into a folder of their own, one after another; the first that fails ends the study."""

    def __init__(self, folder):
        self.folder = Path(folder)

    def file(self, name, text):
        """A file that a deck may name."""
        file = self.folder / name
        file.write_text(text, encoding="utf-8")
        return file

    def __call__(self, name, deck, settings=None):
        done = measured(deck, self.folder / name, settings)
        if done.exit_code != 0:
            raise SystemExit(f"{name}: exit code {done.exit_code}: {done.said}")
        return done.run


def told(*arguments):
    """What `dda ARGUMENTS` prints."""
    return subprocess.run([find_program(), *arguments], check=True, capture_output=True, text=True).stdout


def write_rows(file, rows, digits=None):
    """Dictionaries with the keys of the first as a CSV file; numbers in `digits` significant digits, by default all."""
    with Path(file).open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(rows[0]) if rows else [], lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({name: f"{value:.{digits}g}" if digits and isinstance(value, float) else value
                             for name, value in row.items()})


def read_rows(file):
    """The rows of a CSV file as dictionaries: numbers where there are numbers, None where there is nothing."""
    with Path(file).open(newline="", encoding="utf-8") as stream:
        return [{name: number(text) for name, text in row.items()} for row in csv.DictReader(stream)]


def number(text):
    try:
        return float(text) if text else None
    except ValueError:
        return text


def marks(name="results"):
    """The lines of a README between which stands what a study has found."""
    return f"<!-- {name}: begin -->", f"<!-- {name}: end -->"


def write_region(readme, text, name="results"):
    """Puts a text between the marks; ValueError where there are none."""
    begin, end = marks(name)
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.DOTALL)
    whole, found = pattern.subn(lambda _: f"{begin}\n{text}\n{end}", readme.read_text(encoding="utf-8"))
    if not found:
        raise ValueError(f"{readme}: no region '{name}'")
    readme.write_text(whole, encoding="utf-8")


def plots(name, backend="svg"):
    """matplotlib.pyplot for the figures of a study: the same figure is the same file."""
    import matplotlib  # not every study draws

    matplotlib.use(backend)
    from matplotlib import pyplot

    pyplot.rcParams["svg.hashsalt"] = name
    return pyplot


def save(figure, file):
    from matplotlib import pyplot

    figure.savefig(file, metadata={"Date": None})
    pyplot.close(figure)


def parser(description):
    """Of a study's command line, to which a study adds what else it asks."""
    out = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    out.add_argument("--program", required=True, type=lambda name: str(Path(name).resolve()), help="the program dda")
    out.add_argument("--quick", action="store_true", help="few and small runs: does it work?")
    out.add_argument("--output", type=Path, help="where README.md and results/ go: by default the study's folder, for "
                                                 "--quick runs/ and its name")
    return out


def arguments(parsed, home):
    """What the command line asks of the study in `home`; its output is there, and the program is DDA from now on."""
    asked = parsed.parse_args()
    asked.output = asked.output or (Path("runs") / home.name if asked.quick else home)
    (asked.output / "results").mkdir(parents=True, exist_ok=True)
    if not (asked.output / "README.md").exists():
        shutil.copy(home / "README.md", asked.output)
    os.environ |= {"DDA": asked.program, "OMP_NUM_THREADS": "1"}
    return asked
