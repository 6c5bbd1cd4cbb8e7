"""Times whole runs of the program, from its start to its end, and prints the Markdown tables of docs/manual/time.md.

    whole_process.py PROGRAM [RUNS]

Each deck is run RUNS times (default 7) after one that fills the file cache; a number is the median. The split by
phase is summary.json's, of the same runs; start-up is also what the process spends before its clock and after it.
Exit 1 when a median exceeds its target.
"""

import statistics
import sys
import tempfile
from dataclasses import dataclass

from decks import STUDIES
from processes import Program


@dataclass(frozen=True)
class Case:
    name: str
    study: str
    target: float  # seconds, of the whole process
    settings: tuple = ()


BRITTLE = "interfaces.joints.law.fracture_energy=0.02"
CASES = (Case("snap-back-beam", "snap-back-beam", 1.0), Case("voronoi-beam", "voronoi-beam", 3.0),
         Case("voronoi-beam, Gf = 0.02", "voronoi-beam", 3.0, (BRITTLE,)))
# Phases of a run that are shown together; all others are "path and the rest".
GROUPS = {
    "meshing": ("meshing",),
    "assembly and factorisation": ("equilibrium", "factorisation"),
    "columns of cracked points, products with them": ("columns", "products", "solutions"),
    "iterations": ("reduced iterations", "LOCA", "contact", "tangents", "openings"),
    "laws, residuals, energies, stability": ("laws", "residuals", "energies", "stability"),
    "output": ("output", "fields", "restart file", "figures"),
    "start-up": ("start_up", "outside"),
}
REST = "path and the rest"


def grouped(phases):
    """Seconds of the groups, and what is left."""
    known = {name for names in GROUPS.values() for name in names} | {"total"}
    out = {group: sum(phases.get(name, 0) for name in names) for group, names in GROUPS.items()}
    return out | {REST: sum(seconds for name, seconds in phases.items() if name not in known)}


def measure_case(program, case, runs):
    found = [program.run(STUDIES / case.study / "deck.yaml", *case.settings) for _ in range(runs + 1)][1:]
    summary = found[-1][1]
    phases = {name: statistics.median(run["timings"].get(name, 0) for _, run in found) for name in summary["timings"]}
    phases["outside"] = statistics.median(seconds - run["timings"]["total"] for seconds, run in found)
    return statistics.median(seconds for seconds, _ in found), grouped(phases), summary


def overview(measured):
    print("| deck | blocks | steps | iterations on the cracked points | on all | factorisations | whole process [s] "
          "| target [s] |")
    print("|---|---|---|---|---|---|---|---|")
    for case, (seconds, _, summary) in measured:
        names = ("blocks", "steps", "reduced_iterations", "whole_iterations", "factorisations")
        counts = " | ".join(str(summary[name]) for name in names)
        print(f"| {case.name} | {counts} | {seconds:.2f} | {case.target:g} |")


def split(measured):
    print("\n| phase [s] | " + " | ".join(case.name for case, _ in measured) + " |")
    print("|---|" + "---|" * len(measured))
    for name in (*GROUPS, REST):
        seconds = (f"{groups[name]:.3f}" for _, (_, groups, _) in measured)
        print(f"| {name} | " + " | ".join(seconds) + " |")


def main(arguments):
    runs = int(arguments[1]) if len(arguments) > 1 else 7
    with tempfile.TemporaryDirectory() as folder:
        program = Program(arguments[0], folder)
        measured = [(case, measure_case(program, case, runs)) for case in CASES]
    overview(measured)
    split(measured)
    return 1 if any(result[0] > case.target for case, result in measured) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
