"""What following a crack costs: whole runs and iterations, against their targets.

    cost_of_a_crack.py PROGRAM [RUNS]

Prints a Markdown table; numbers are medians of RUNS runs (default 5), ratios are taken between runs that alternate.
Runs have one thread, but for those that compare one with two. Exit 1 when a target is missed.
"""

import json
import statistics
import sys
import tempfile

import decks
import mesh_of_run
from decks import STUDIES, beams
from processes import Program

# Phases of a profile that belong to following the path.
FOLLOWING = ("tangents", "laws", "solutions", "path", "LOCA", "residuals", "columns", "products", "energies",
             "reduced iterations", "openings")
# Sides of the triangles of the beam of studies/scaling that give 2000 and 20 000 blocks [mm].
ITERATED = {2000: (2.70, 21.6), 20_000: (0.81, 6.48)}


THREADED = (("triangles", 30_000, 1.2), ("triangles", 100_000, 1.2), ("voronoi", 30_000, 1.3), ("voronoi", 100_000, 1.3))


def seconds_per_iteration(summary):
    """Of the path alone; of several factorisations all but the first, which every run needs."""
    profile = {row["phase"]: row for row in summary["profile"]}
    spent = sum(profile[name]["seconds"] for name in FOLLOWING if name in profile)
    factorisation = profile["factorisation"]
    spent += factorisation["seconds"] * (factorisation["calls"] - 1) / factorisation["calls"]
    return spent / (summary["whole_iterations"] + summary["reduced_iterations"])


def iterations(program, runs):
    for number, target in ((20_000, 10), (2000, 5)):
        deck = beams.deck(beams.geometry(*ITERATED[number]) | {"subdivision": {"type": "triangles"}})
        found = {"low_rank": [], "refactorise": []}
        for _ in range(runs):
            for update, seconds in found.items():
                _, summary = program.run(deck, f"path.update={update}", "path.stop.after_steps=25")
                seconds.append(seconds_per_iteration(summary))
        cheap, dear = (statistics.median(seconds) for seconds in found.values())
        yield (f"an iteration, {summary['blocks']} blocks: {1000 * cheap:.2f} ms against {1000 * dear:.1f} ms with a new "
               f"factorisation, times cheaper", dear / cheap, target, True)


def snap_back(program, runs):
    study = STUDIES / "snap-back-beam" / "deck.yaml"
    program.run(study)
    mesh = program.folder / "beam.msh"
    mesh_of_run.write(program.folder / "run", 100 / 6, mesh)
    scene = json.dumps({"type": "msh", "file": str(mesh)})
    seconds, summary = program.seconds(study, runs, f"scene={scene}")
    yield f"snap-back beam, {summary['blocks']} triangles from a .msh [s]", seconds, 0.25, False


def voronoi(program, runs):
    for blocks, target in ((560, 0.7), (2200, 4.5)):
        deck = decks.voronoi(blocks, 2)
        seconds, summary = program.seconds(deck, runs)
        yield f"{summary['blocks']} Voronoi cells, notch D/2, every interface able to crack [s]", seconds, target, False


def large_beam(program, _):
    seconds, summary = program.run(beams.triangles(100_000))
    yield f"{summary['blocks']} triangles, whole path [s]", seconds, 300, False
    yield f"{summary['blocks']} triangles, memory [GiB]", summary["peak_memory_mib"] / 1024, 6, False


def threads(program, runs):
    for beam, number, target in THREADED:
        deck = beams.BEAMS[beam](number)
        seconds = {1: [], 2: []}
        for _ in range(min(runs, 3)):
            for count, found in seconds.items():
                found.append(program.run(deck, threads=count)[0])
        one, two = (statistics.median(found) for found in seconds.values())
        yield f"{number} blocks, {beam}: {one:.1f} s with one thread, {two:.1f} s with two, times faster", one / two, target, True


def main(arguments):
    runs = int(arguments[1]) if len(arguments) > 1 else 5
    missed = 0
    print("| what | measured | target | |\n|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        program = Program(arguments[0], folder)
        for part in (iterations, snap_back, voronoi, large_beam, threads):
            for what, found, target, is_least in part(program, runs):
                held = found >= target if is_least else found <= target
                missed += not held
                print(f"| {what} | {found:.3g} | {'≥' if is_least else '≤'} {target:g} | {'yes' if held else '**no**'} |",
                      flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
