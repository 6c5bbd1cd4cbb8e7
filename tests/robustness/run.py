#!/usr/bin/env python3
"""Runs random structures, checks every run independently and prints who reaches the goal; see README.md.

    run.py PROGRAM --count 500 --seed 1 --jobs 2 --time-limit 60 [--kind cracks] [--folder DIR] [--only SEED ...]

Each run has a line on standard error as soon as it has ended; the table follows at the end.
Exit code 1 when a bound is broken: 97 % of the goals with consistent and penalty joints, 90 % with multipliers on meshes
that they are for, 95 % with a crack through blocks, no run that ends with exit 0 and is refused by `dda verify`, no exit code but 0, 2 and 3, no time-out.
"""
import argparse
import collections
import math
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(__file__).resolve().parent))

from matrix_runner import refusals, start_deck  # noqa: E402, it knows where the package is
from ddapath import Run  # noqa: E402
from cracked_structures import cracked_structure  # noqa: E402
from structures import TREATMENTS, structure  # noqa: E402

KINDS = {"joints": structure, "cracks": cracked_structure}
SHARES = {"consistent": 0.97, "penalty": 0.97, "lagrange": 0.90, "augmented_lagrangian": 0.90}


@dataclass
class Outcome:
    seed: int
    kind: dict
    code: object
    seconds: float
    reason: str
    refused: list = field(default_factory=list)

    @property
    def name(self):
        return f"{self.seed}: {self.kind['shape']}, {self.kind['mesh']}, {self.kind['treatment']}"


def run_one(seed, folder, arguments):
    deck, kind = KINDS[arguments.kind](seed)
    place = folder / f"{seed}"
    path = folder / f"{seed}.yaml"
    path.write_text(yaml.safe_dump(deck, sort_keys=False, default_flow_style=None, width=120), encoding="utf-8")
    code, seconds, said = start_deck(path, place, arguments.program, arguments.time_limit)
    reason = Run(place).summary.get("reason", said)
    outcome = Outcome(seed, kind, code, seconds, reason, refusals(place) if code in (0, 3) else [])
    print(row(outcome), file=sys.stderr, flush=True)
    return outcome


def row(outcome):
    """A line about a run, shown as soon as it has ended."""
    refused = f" REFUSED: {'; '.join(outcome.refused)}" if outcome.refused else ""
    return f"exit {outcome.code} {outcome.seconds:6.1f} s  {outcome.name}{'' if outcome.kind['suited'] else ' (other mesh)'}: {outcome.reason}{refused}"


def missed_beyond(outcomes, share):
    """How many more miss their goal than may; of few a single one may."""
    missed = sum(outcome.code != 0 for outcome in outcomes)
    return max(missed - math.ceil((1 - share) * len(outcomes) - 1e-9), 0)


def share_table(outcomes, shares):
    """Prints the shares by treatment; the sentences that say which are below those wanted."""
    broken = []
    for treatment in TREATMENTS:
        for suited in (True, False):
            chosen = [one for one in outcomes
                      if one.kind["treatment"] == treatment and one.kind["suited"] == suited and one.code != 2]
            if not chosen:
                continue
            good = sum(one.code == 0 for one in chosen)
            print(f"  {treatment:21} {'' if suited else 'on other meshes':16} {good:4} of {len(chosen):4}  {100 * good / len(chosen):5.1f} %")
            if suited and missed_beyond(chosen, shares[treatment]):
                broken.append(f"{treatment}: {good} of {len(chosen)} reach their goal, {100 * shares[treatment]:.0f} % are wanted")
    return broken


def print_list(title, outcomes, text):
    if outcomes:
        print(f"{title}: {len(outcomes)}")
        for one in outcomes:
            print(f"  {one.name} ({one.seconds:.1f} s): {text(one)}")


def report(outcomes, shares):
    """Prints everything; what is broken."""
    print(f"{len(outcomes)} structures, {sum(one.seconds for one in outcomes):.0f} s; goals reached:")
    broken = share_table(outcomes, shares)
    early = [one for one in outcomes if one.code == 3]
    for reason, count in collections.Counter(plain(one.reason) for one in early).most_common():
        print(f"  stopped early {count:4}: {reason}")
    print_list("Stopped early", early, lambda one: one.reason)
    groups = {"Refused input": [one for one in outcomes if one.code == 2],
              "Time-outs": [one for one in outcomes if one.code == "time"],
              "Other exit codes": [one for one in outcomes if one.code not in (0, 2, 3, "time")]}
    for title, chosen in groups.items():
        print_list(title, chosen, lambda one: f"exit {one.code}: {one.reason}")
    refused = [one for one in outcomes if one.refused]
    print_list("Refused by the checker", refused, lambda one: f"exit {one.code}: " + "; ".join(one.refused))
    broken += [f"{title.lower()}: {len(groups[title])}" for title in ("Time-outs", "Other exit codes") if groups[title]]
    false = [one for one in refused if one.code == 0]
    return broken + ([f"exit 0, but refused: {', '.join(str(one.seed) for one in false)}"] if false else [])


def plain(reason):
    """A reason without its numbers, for counting."""
    return " ".join(word for word in reason.split() if not any(sign.isdigit() for sign in word))


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1, help="the first one; structure n of a run has the seed SEED + n")
    parser.add_argument("--kind", choices=KINDS, default="joints", help="what cracks: joints, or blocks along one crack")
    parser.add_argument("--only", type=int, nargs="+", metavar="SEED", help="these structures instead of a series")
    parser.add_argument("--every", action="store_true", help="every one must reach its goal, not the shares above")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--time-limit", type=float, default=60, help="processor seconds that a run may take")
    parser.add_argument("--folder", type=Path, help="where decks and runs are kept; nowhere if not given")
    return parser.parse_args()


def main():
    arguments = read_arguments()
    seeds = arguments.only or range(arguments.seed, arguments.seed + arguments.count)
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.folder or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        with ThreadPoolExecutor(arguments.jobs) as pool:
            outcomes = list(pool.map(lambda seed: run_one(seed, folder, arguments), seeds))
    wanted = {"joints": SHARES, "cracks": dict.fromkeys(TREATMENTS, 0.95)}[arguments.kind]
    broken = report(outcomes, dict.fromkeys(TREATMENTS, 1.0) if arguments.every else wanted)
    for sentence in broken:
        print(f"BROKEN: {sentence}")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
