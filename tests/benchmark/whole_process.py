"""Times whole runs of the program, from its start to its end, and prints Markdown tables for the README.

    whole_process.py PROGRAM [RUNS]

Each deck is run RUNS times (default 7) after one that fills the file cache; a number is the median. The split by
phase is summary.json's, of the same runs; "outside" is what the process spends before its clock and after it.
Exit 1 when a median exceeds its target.
"""

import os
import statistics
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from ddapath import study  # noqa: E402


@dataclass(frozen=True)
class Case:
    name: str
    study: str
    target: float  # seconds, of the whole process
    settings: dict = field(default_factory=dict)


BRITTLE = {"interfaces.joints.law.fracture_energy": 0.02}
CASES = (Case("snap-back-beam", "snap-back-beam", 1.0), Case("voronoi-beam", "voronoi-beam", 3.0),
         Case("voronoi-beam, Gf = 0.02", "voronoi-beam", 3.0, BRITTLE))


def measure(deck, settings, folder):
    """Seconds of one whole process, and its summary."""
    done = study.measured(deck, folder, settings)
    if done.exit_code != 0:
        raise SystemExit(done.said)
    return done.seconds, done.run.summary


def measure_case(case, runs):
    with tempfile.TemporaryDirectory() as folder:
        deck = ROOT / "studies" / case.study / "deck.yaml"
        found = [measure(deck, case.settings, folder) for _ in range(runs + 1)][1:]
    summary = found[-1][1]
    phases = {name: statistics.median(run["timings"][name] for _, run in found) for name in summary["timings"]}
    phases["outside"] = statistics.median(seconds - run["timings"]["total"] for seconds, run in found)
    return statistics.median(seconds for seconds, _ in found), phases, summary


def overview(measured):
    print("| deck | blocks | steps | iterations on the cracked points | on all | factorisations | whole process [s] "
          "| target [s] |")
    print("|---|---|---|---|---|---|---|---|")
    for case, (seconds, _, summary) in measured:
        names = ("blocks", "steps", "reduced_iterations", "newton_iterations", "factorisations")
        counts = " | ".join(str(summary[name]) for name in names)
        print(f"| {case.name} | {counts} | {seconds:.2f} | {case.target:g} |")


def split(measured):
    names = list(dict.fromkeys(name for _, (_, phases, _) in measured for name in phases if name != "total"))
    print("\n| phase [s] | " + " | ".join(case.name for case, _ in measured) + " |")
    print("|---|" + "---|" * len(measured))
    for name in names:
        seconds = (f"{phases.get(name, 0):.3f}" for _, (_, phases, _) in measured)
        print(f"| {name.replace('_', '-')} | " + " | ".join(seconds) + " |")


def main(arguments):
    os.environ["DDA"] = str(Path(arguments[0]).resolve())
    runs = int(arguments[1]) if len(arguments) > 1 else 7
    measured = [(case, measure_case(case, runs)) for case in CASES]
    overview(measured)
    split(measured)
    return 1 if any(result[0] > case.target for case, result in measured) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
