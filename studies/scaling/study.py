"""How time and memory grow with the number of blocks when one crack grows.

    study.py --program DDA [--quick] [--repeats N] [--only BEAM] [--report] [--output FOLDER]

Writes results/scaling.csv, results/scaling.svg and the marked region of README.md into FOLDER: this folder, or with
--quick runs/scaling. Runs are one after another; each number is the median of the repeats of the run.
"""

import statistics
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import beams  # noqa: E402
import report  # noqa: E402
from ddapath import study, write_deck  # noqa: E402

# Rows of the profile that are shown together.
PHASES = {
    "meshing": ("meshing",),
    "assembly": ("equilibrium",),
    "factorisation": ("factorisation",),
    "columns": ("columns",),
    "borders": ("growth",),
    "products": ("products", "solutions"),
    "reduced iterations": ("reduced iterations",),
    "tangents, openings, energies": ("path", "openings", "laws", "energies", "tangents", "stability"),
    "checks": ("residuals",),
    "output": ("output", "fields", "restart file", "figures"),
}
OF_A_STEP = ("reduced iterations", "tangents, openings, energies")  # what no more than every tenth asks for left out


def predicted_memory(deck, folder):
    """MiB that the run takes at least, as `dda check` says."""
    said = study.told("check", write_deck(deck, Path(folder) / "deck.yaml"))
    line = next(line for line in said.splitlines() if line.strip().startswith("memory"))
    return float(line.split("at least ")[1].split(" MiB")[0])


def row_of(seconds, summary):
    """What is kept of a run: seconds by phase, without start-up, of an iteration in the reduced space and of a step."""
    by_name = {line["phase"]: line["seconds"] for line in summary["profile"]}
    row = {phase: sum(by_name.get(name, 0.0) for name in names) for phase, names in PHASES.items()}
    row["rest"] = summary["timings"]["total"] - summary["timings"]["start_up"] - sum(row.values())
    row["total"] = seconds - summary["timings"]["start_up"]
    row["one reduced iteration"] = by_name["reduced iterations"] / summary["reduced_iterations"]
    row["one step"] = sum(row[phase] for phase in OF_A_STEP) / summary["steps"]
    return row


def measure(deck, repeats):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(repeats):
            done = study.measured(deck, Path(folder) / "run")
            summary = done.run.summary
            rows.append(row_of(done.seconds, summary))
        memory = predicted_memory(deck, folder)
    names = ("blocks", "crackable_points", "steps", "reduced_iterations", "whole_iterations", "factorisations")
    out = {name: summary[name] for name in names}
    out |= {"peak_load": summary["peak"]["load"], "memory_mib": summary["peak_memory_mib"], "predicted_mib": memory}
    return out | {name: statistics.median(row[name] for row in rows) for name in rows[0]}


def run_all(chosen, most, repeats, file):
    """Rows of beams that were not chosen stay what they were."""
    rows = []
    for name, beam in beams.BEAMS.items():
        if name not in chosen:
            kept = [row for row in study.read_rows(file) if row["beam"] == name]
            rows += [row | {phase: row.get(phase) or 0.0 for phase in PHASES} for row in kept]
            continue
        for number in beams.NUMBERS[name][:most]:
            print(f"{name}: {number} blocks", file=sys.stderr)
            rows.append({"beam": name} | measure(beam(number), repeats))
    study.write_rows(file, rows, digits=6)


def main():
    parser = study.parser(__doc__)
    parser.add_argument("--repeats", type=int, default=3, help="runs of which the median is kept (default 3)")
    parser.add_argument("--only", choices=beams.BEAMS, help="run this beam; the others keep their rows of results/scaling.csv")
    parser.add_argument("--report", action="store_true", help="run nothing; figure and README from results/scaling.csv")
    asked = study.arguments(parser, HERE)
    file = asked.output / "results" / "scaling.csv"
    if not asked.report:
        run_all([asked.only] if asked.only else list(beams.BEAMS), 2 if asked.quick else None, 1 if asked.quick else asked.repeats, file)
    report.write(asked.output, study.read_rows(file), [*PHASES, "rest", "total", "one reduced iteration", "one step"])


if __name__ == "__main__":
    main()
