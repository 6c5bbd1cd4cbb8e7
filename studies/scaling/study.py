"""How time and memory grow with the number of blocks when one crack grows.

    study.py --program DDA [--quick] [--repeats N] [--report] [--output FOLDER]

Writes results/scaling.csv, results/scaling.svg and the marked region of README.md into FOLDER: this folder, or with
--quick runs/scaling. Runs are one after another; each number is the median of the repeats of the run.
"""

import argparse
import csv
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import beams
import report

HERE = Path(__file__).resolve().parent
# Rows of the profile that are shown together.
PHASES = {
    "meshing": ("meshing",),
    "assembly": ("equilibrium",),
    "factorisation": ("factorisation",),
    "columns": ("columns",),
    "products": ("products", "solutions"),
    "reduced iterations": ("reduced iterations",),
    "checks": ("laws", "residuals", "energies", "tangents"),
    "output": ("output", "fields", "restart file", "figures"),
}


def run(program, deck, folder):
    """Seconds of the whole process, and its summary."""
    file = Path(folder) / "deck.json"
    file.write_text(json.dumps(deck), encoding="utf-8")
    command = [program, "run", file, "--folder", Path(folder) / "run", "--overwrite", "--quiet"]
    start = time.perf_counter()
    subprocess.run(command, check=True, capture_output=True)
    seconds = time.perf_counter() - start
    return seconds, json.loads((Path(folder) / "run" / "summary.json").read_text(encoding="utf-8"))


def predicted_memory(program, folder):
    """MiB that the run takes at least, as `dda check` says."""
    said = subprocess.run([program, "check", Path(folder) / "deck.json"], check=True, capture_output=True,
                          text=True).stdout
    line = next(line for line in said.splitlines() if line.strip().startswith("memory"))
    return float(line.split("at least ")[1].split(" MiB")[0])


def row_of(seconds, summary):
    """What is kept of a run: seconds by phase, without start-up, and of one iteration in the reduced space."""
    by_name = {line["phase"]: line["seconds"] for line in summary["profile"]}
    row = {phase: sum(by_name.get(name, 0.0) for name in names) for phase, names in PHASES.items()}
    row["rest"] = summary["timings"]["total"] - summary["timings"]["start_up"] - sum(row.values())
    row["total"] = seconds - summary["timings"]["start_up"]
    row["one reduced iteration"] = by_name["reduced iterations"] / summary["reduced_iterations"]
    return row


def measure(program, deck, repeats):
    with tempfile.TemporaryDirectory() as folder:
        found = [run(program, deck, folder) for _ in range(repeats)]
        memory = predicted_memory(program, folder)
    rows = [row_of(*each) for each in found]
    summary = found[0][1]
    names = ("blocks", "crackable_points", "steps", "reduced_iterations", "newton_iterations", "factorisations")
    out = {name: summary[name] for name in names}
    out |= {"peak_load": summary["peak"]["load"], "memory_mib": summary["peak_memory_mib"], "predicted_mib": memory}
    return out | {name: statistics.median(row[name] for row in rows) for name in rows[0]}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="the program dda")
    parser.add_argument("--quick", action="store_true", help="the two smallest beams: does it work?")
    parser.add_argument("--repeats", type=int, default=3, help="runs of which the median is kept (default 3)")
    parser.add_argument("--report", action="store_true", help="run nothing; figure and README from results/scaling.csv")
    parser.add_argument("--output", type=Path, help="where README.md and results/ go")
    return parser.parse_args()


def run_all(program, most, repeats, file):
    rows = []
    for name, beam in beams.BEAMS.items():
        for number in beams.NUMBERS[name][:most]:
            print(f"{name}: {number} blocks", file=sys.stderr)
            rows.append({"beam": name} | measure(program, beam(number), repeats))
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()})


def main():
    asked = arguments()
    output = asked.output or (Path("runs") / HERE.name if asked.quick else HERE)
    (output / "results").mkdir(parents=True, exist_ok=True)
    if not (output / "README.md").exists():
        shutil.copy(HERE / "README.md", output)
    file = output / "results" / "scaling.csv"
    if not asked.report:
        os.environ["OMP_NUM_THREADS"] = "1"
        run_all(str(Path(asked.program).resolve()), 2 if asked.quick else None, 1 if asked.quick else asked.repeats, file)
    report.write(output, report.read(file), [*PHASES, "rest", "total", "one reduced iteration"])


if __name__ == "__main__":
    main()
