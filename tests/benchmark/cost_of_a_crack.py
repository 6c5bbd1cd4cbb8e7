"""What following a crack costs: whole runs and iterations, against their targets.

    cost_of_a_crack.py PROGRAM [RUNS]

Prints a Markdown table; numbers are medians of RUNS runs (default 5), ratios are taken between runs that alternate.
Runs have one thread, but for those that compare one with two. Exit 1 when a target is missed.
"""

import os
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ROOT / "studies"
sys.path[:0] = [str(ROOT / "python"), str(STUDIES / "scaling")]

import beams  # noqa: E402
import mesh_of_run  # noqa: E402
from ddapath import study  # noqa: E402

# Phases of a profile that belong to following the path.
FOLLOWING = ("tangents", "laws", "solutions", "path", "LOCA", "residuals", "columns", "products", "energies",
             "reduced iterations")
# Sides of the triangles of the beam of studies/scaling that give 2000 and 20 000 blocks [mm].
ITERATED = {2000: (2.70, 21.6), 20_000: (0.81, 6.48)}


THREADED = (("triangles", 30_000, 1.2), ("triangles", 100_000, 1.2), ("voronoi", 30_000, 1.3), ("voronoi", 100_000, 1.3))


class Runs:
    """Runs in one folder, which each replaces."""

    def __init__(self, folder):
        self.folder = Path(folder)

    def run(self, deck, settings=None, threads=1):
        """Seconds of the whole process, and its summary; `deck` is a file or what goes into one."""
        done = study.measured(deck, self.folder / "run", settings, threads=threads)
        if done.exit_code != 0:
            raise SystemExit(done.said)
        return done.seconds, done.run.summary

    def seconds(self, deck, runs, settings=None):
        found = [self.run(deck, settings) for _ in range(runs + 1)][1:]
        return statistics.median(seconds for seconds, _ in found), found[-1][1]


def seconds_per_iteration(summary):
    """Of the path alone; of several factorisations all but the first, which every run needs."""
    profile = {row["phase"]: row for row in summary["profile"]}
    spent = sum(profile[name]["seconds"] for name in FOLLOWING if name in profile)
    factorisation = profile["factorisation"]
    spent += factorisation["seconds"] * (factorisation["calls"] - 1) / factorisation["calls"]
    return spent / (summary["newton_iterations"] + summary["reduced_iterations"])


def iterations(program, runs):
    for number, target in ((20_000, 10), (2000, 5)):
        deck = beams.deck(beams.geometry(*ITERATED[number]) | {"subdivision": {"type": "triangles"}})
        found = {"low_rank": [], "refactorise": []}
        for _ in range(runs):
            for update, seconds in found.items():
                _, summary = program.run(deck, {"path.update": update, "path.stop.after_steps": 25})
                seconds.append(seconds_per_iteration(summary))
        cheap, dear = (statistics.median(seconds) for seconds in found.values())
        yield (f"an iteration, {summary['blocks']} blocks: {1000 * cheap:.2f} ms against {1000 * dear:.1f} ms with a new "
               f"factorisation, times cheaper", dear / cheap, target, True)


def snap_back(program, runs):
    deck = STUDIES / "snap-back-beam" / "deck.yaml"
    program.run(deck)
    mesh = program.folder / "beam.msh"
    mesh_of_run.write(program.folder / "run", 100 / 6, mesh)
    seconds, summary = program.seconds(deck, runs, {"scene": {"type": "msh", "file": mesh}})
    yield f"snap-back beam, {summary['blocks']} triangles from a .msh [s]", seconds, 0.25, False


def voronoi(program, runs):
    for blocks, target in ((560, 0.7), (2200, 4.5)):
        deck = {
            "scene": {"regions": [{"material": "concrete", "vertices": [[0, 0], [300, 0], [300, 100], [0, 100]]}],
                      "slits": {"notch": [[150, 0], [150, 50]]},
                      "subdivision": {"type": "voronoi", "blocks": blocks, "seed": 1}},
            "thickness": 100,
            "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
            "interfaces": {"any": {"between": ["concrete", "concrete"], "law": {
                "type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.1}}},
            "supports": {"left": {"at": [0, 0], "fix": "xy"}, "right": {"at": [300, 0], "fix": "y"}},
            "stages": [{"loads": [{"type": "point_load", "at": [150, 100], "force": [0, -1]}]}],
            "path": {"stop": {"load_below": 0.1}},
        }
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
        os.environ["DDA"] = str(Path(arguments[0]).resolve())
        program = Runs(folder)
        for part in (iterations, snap_back, voronoi, large_beam, threads):
            for what, found, target, is_least in part(program, runs):
                held = found >= target if is_least else found <= target
                missed += not held
                print(f"| {what} | {found:.3g} | {'≥' if is_least else '≤'} {target:g} | {'yes' if held else '**no**'} |",
                      flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
