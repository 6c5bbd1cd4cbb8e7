"""Whole processes of two programs, one after the other, and what one program takes for two decks.

    paired.py PROGRAM --against OTHER [--runs N] [--only NAME ...]

The pairs alternate, so that what else the machine does meets both alike; a ratio is the median over the pairs. The
program may take 1.1 times as long as the other and 25 ms more; an unsymmetric stiffness 1.6 times as long as a
symmetric one. Runs have one thread. Prints a Markdown table; exit 1 when a bound is not kept.
"""

import argparse
import statistics
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import decks
from decks import STUDIES, beams
from processes import Program

SHARE, START = 1.1, 0.025  # times as long, and seconds more
UNSYMMETRIC = 1.6
LARGE_RUNS = 3  # at most, of what takes longer than ten seconds
STRENGTH = 3  # N/mm², that of decks.voronoi


@dataclass(frozen=True)
class Case:
    """The same deck for two programs, or two decks for the first of them."""

    name: str
    deck: object
    other_deck: object = None
    is_large: bool = False


def cases():
    for name, file in (("softening bar", "softening-bar/deck.yaml"), ("snap-back beam", "snap-back-beam/deck.yaml"),
                       ("voronoi-beam", "voronoi-beam/deck.yaml"), ("kitoh-beam, 455 blocks", "kitoh-beam/deck.yaml")):
        yield Case(name, STUDIES / file)
    yield Case("100 000 triangles", beams.triangles(100_000), is_large=True)
    for seeds, cells in ((557, 561), (2196, 2201)):  # the slit cuts some in two
        yield Case(f"unsymmetric, {cells} cells", decks.voronoi(seeds, 6, cohesion=STRENGTH / 2),
                   decks.voronoi(seeds, 6, cohesion=STRENGTH))


def pairs(one, other, runs):
    """Seconds of both, alternating, the first pair left out: it fills the caches of files."""
    found = [(one(), other()) for _ in range(runs + 1)]
    return found[1:]


def compare(case, program, against, runs):
    """What is printed of a case, and whether its bound is kept."""
    other_deck = case.other_deck or case.deck
    other = program if case.other_deck else against
    seconds = pairs(lambda: program.run(case.deck)[0], lambda: other.run(other_deck)[0],
                    min(runs, LARGE_RUNS) if case.is_large else runs)
    one, two = (statistics.median(each) for each in zip(*seconds))
    ratio = statistics.median(a / b for a, b in seconds)
    if case.other_deck:
        bound, kept = f"{UNSYMMETRIC:g}", ratio <= UNSYMMETRIC
    else:
        bound = f"{SHARE:g}, and {1000 * START:g} ms"
        kept = statistics.median(a - SHARE * b for a, b in seconds) <= START
    return f"| {case.name} | {one:.3f} | {two:.3f} | {ratio:.2f} | {bound} | {'yes' if kept else '**no**'} |", kept


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program dda that is judged")
    parser.add_argument("--against", help="another program dda; without it only the unsymmetric stiffness is timed")
    parser.add_argument("--runs", type=int, default=7, help="pairs of each case (default 7)")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="cases whose name begins so")
    return parser.parse_args()


def main():
    asked = arguments()
    kept = True
    print("| whole process | [s] | against [s] | ratio | at most | kept |\n|---|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        places = [Path(folder) / name for name in ("one", "other")]
        for place in places:
            place.mkdir()
        program = Program(asked.program, places[0])
        against = Program(asked.against, places[1]) if asked.against else None
        for case in cases():
            is_wanted = not asked.only or any(case.name.startswith(name) for name in asked.only)
            if not is_wanted or not (against or case.other_deck):
                continue
            line, holds = compare(case, program, against, asked.runs)
            print(line, flush=True)
            kept = kept and holds
    return 0 if kept else 1


if __name__ == "__main__":
    sys.exit(main())
