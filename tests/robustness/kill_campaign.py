#!/usr/bin/env python3
"""Kills runs at random times, resumes them until they are done and compares them bit for bit with runs left alone.

    kill_campaign.py PROGRAM --kills 200 [--seed 1] [--only release] [--folder DIR]

Five decks (a softening beam, unloading legs, release at once, plates with friction, a crack through blocks) and a sweep. Compared are the bytes of
curve.csv, every dataset of fields/ but the provenance, and what summary.json says but its efforts and times. Exit code 1 when
one differs or cannot be resumed.
"""
import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import yaml

TESTS = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS / "robustness"), str(TESTS / "program")]

from contact_structures import plates_on_beam  # noqa: E402
from same_fields import datasets  # noqa: E402

SAID = ("status", "reason", "steps", "peak", "external_work", "stored_energy", "dissipated_energy", "events", "jump_energy",
        "energy_balance_error", "interfaces")
OFTEN = ["record.fields_every=3"]


def decks(folder):
    """Name → (command, deck, settings); each takes seconds, and is killed while it meshes, steps and writes."""
    plates = folder / "plates.yaml"
    plates.write_text(yaml.safe_dump(plates_on_beam("voronoi", "consistent", 30).deck), encoding="utf-8")
    studies, program = TESTS.parent / "studies", TESTS / "program"
    return {"softening": ("run", program / "fine_beam.yaml", ["path.stop.steps=30", *OFTEN]),
            "legs": ("run", program / "legs.yaml", ["scene.subdivision.blocks=1200", *OFTEN]),
            "release": ("run", studies / "reinforced-beam" / "release.yaml", ["path.stop.gauges.deflection=0.04", *OFTEN]),
            "plates": ("run", plates, OFTEN),
            "cracks": ("run", program / "cracked_beam.yaml", ["scene.subdivision.blocks=1200", *OFTEN]),
            "sweep": ("sweep", program / "beam.yaml",
                      ["scene.subdivision.blocks=500", "sweep={thickness: [50, 100, 150, 200]}", *OFTEN])}


def descendants(process):
    """Numbers of a process' children and theirs, from /proc."""
    try:
        found = [word for task in Path(f"/proc/{process}/task").iterdir()
                 for word in (task / "children").read_text(encoding="ascii").split()]
    except OSError:
        return []
    return [number for child in map(int, found) for number in (child, *descendants(child))]


def kill(process):
    """SIGKILL to what was started here and to what that started: nothing is left to write, or holds a lock."""
    process.send_signal(signal.SIGSTOP)  # starts nothing more
    while state_of(process.pid) not in ("T", "Z", ""):
        time.sleep(0.001)
    below = descendants(process.pid)
    for number in (*below, process.pid):
        try:
            os.kill(number, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()
    while any(state_of(number) not in ("Z", "") for number in below):
        time.sleep(0.01)


def state_of(process):
    """Its letter in /proc: T stopped, Z over but not yet taken note of; "" gone."""
    try:
        return Path(f"/proc/{process}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()[0]
    except OSError:
        return ""


class Campaign:
    """One deck: the run that was left alone, and those that were not."""

    def __init__(self, program, name, work, rng):
        self.program, self.name, self.folder, self.rng = program, name, work / name, rng
        self.command, self.deck, settings = decks(work)[name]
        self.settings = [word for setting in settings for word in ("--set", setting)]
        self.reference = work / f"{name}-alone"
        begun = time.monotonic()
        self.code = self.start(self.first(self.reference)).wait()
        self.seconds = time.monotonic() - begun
        self.killed = self.began_again = 0

    def first(self, folder):
        return [self.command, str(self.deck), *self.settings, "--folder", str(folder), "--overwrite", "--quiet"]

    def start(self, words):
        if self.command == "sweep":  # has no --overwrite: the same again runs what is missing
            words = [word for word in words if word != "--overwrite"]
        environment = os.environ | {"OMP_NUM_THREADS": "1"}
        with (self.reference.parent / "said.log").open("w", encoding="utf-8") as said:
            return subprocess.Popen([self.program, *words], stdout=said, stderr=said, env=environment)

    def run_killed(self, kills):
        """Runs and resumes, killed `kills` times on the way; what is wrong in the end, or ""."""
        shutil.rmtree(self.folder, ignore_errors=True)
        words = self.first(self.folder)
        for _ in range(kills):
            process = self.start(words)
            try:
                process.wait(self.rng.uniform(0, 1.05 * self.seconds))
            except subprocess.TimeoutExpired:
                kill(process)
                self.killed += 1
            words = self.next_words()
        return self.finish(words)

    def next_words(self):
        """A run that was killed before its first restart file begins again."""
        if self.command == "sweep" and self.folder.exists() or (self.folder / "restart.h5").exists():
            return ["resume", str(self.folder), "--quiet"]
        self.began_again += 1
        return self.first(self.folder)

    def finish(self, words):
        code = self.start(words).wait()
        if code != self.code:
            said = (self.reference.parent / "said.log").read_text(encoding="utf-8")
            return f"exit {code} instead of {self.code}: {said.strip()[-300:]}"
        return self.difference()

    def difference(self):
        if self.command == "run":
            return difference(self.reference, self.folder)
        cases = sorted(path.name for path in (self.reference / "cases").iterdir())
        found = [f"case {name}: {text}" for name in cases
                 if (text := difference(self.reference / "cases" / name, self.folder / "cases" / name))]
        return "; ".join(found)


def difference(one, other):
    """In what two run folders differ, or ""."""
    out = [name for name in ("curve.csv",) if (one / name).read_bytes() != (other / name).read_bytes()]
    first, second = (datasets(folder) for folder in (one, other))
    out += [f"fields/{name}" for name in sorted(first.keys() | second.keys())
            if not name.startswith("mesh/provenance") and first.get(name) != second.get(name)]
    first, second = (json.loads((folder / "summary.json").read_text(encoding="utf-8")) for folder in (one, other))
    out += [f"summary.json {name}" for name in SAID if first.get(name) != second.get(name)]
    return ", ".join(out[:8])


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=200, help="over all decks")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", action="append", default=[], help="a deck's name; may be repeated")
    parser.add_argument("--folder", type=Path, help="where runs are kept; nowhere if not given")
    return parser.parse_args()


def campaign(program, name, work, kills, rng):
    """Kills one deck's runs `kills` times, up to three times each; True when all of them ended as the one left alone."""
    of = Campaign(program, name, work, rng)
    print(f"{name}: left alone {of.seconds:.1f} s, exit {of.code}", flush=True)
    wrong = runs = tried = 0
    while of.killed < kills:  # one that comes too late is none
        now = min(rng.randint(1, 3), kills - of.killed)
        text = of.run_killed(now)
        tried, runs = tried + now, runs + 1
        if text:
            wrong += 1
            print(f"  run {runs}, {now} kills: {text}", flush=True)
    print(f"{name}: {runs} runs, {of.killed} kills ({tried - of.killed} came too late), {of.began_again} began again, "
          f"{wrong} differ", flush=True)
    return wrong == 0


def main():
    arguments = read_arguments()
    with tempfile.TemporaryDirectory() as scratch:
        work = arguments.folder or Path(scratch)
        work.mkdir(parents=True, exist_ok=True)
        names = arguments.only or list(decks(work))
        share = -(-arguments.kills // len(names))
        good = [campaign(arguments.program, name, work, share, random.Random(f"{arguments.seed} {name}")) for name in names]
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
