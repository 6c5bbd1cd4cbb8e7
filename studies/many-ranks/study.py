"""What a run on several ranks takes of each: memory, time, and what goes between them; and what limits their number.

    study.py --program DDA [--quick] [--repeats N] [--report] [--output FOLDER]

Writes results/many-ranks.csv, results/many-ranks.svg and the marked region of README.md into FOLDER: this folder, or with --quick runs/many-ranks.
Runs are one after another, all ranks of a run on this machine; times are medians of the repeats of a run.
"""

import statistics
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))
sys.path.insert(0, str(HERE.parent / "scaling"))

import beams  # noqa: E402
import tables  # noqa: E402
from ddapath import study  # noqa: E402

TRIANGLES, QUICK = (30_000, 100_000, 325_000), (1000,)
RANKS = (1, 2, 3, 4)
SHARED = ("factorisation", "columns", "products", "solutions")  # phases whose work ranks share
LAUNCHER = ("mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n")


def row_of(done):
    """What is kept of a run."""
    summary = done.run.summary
    by_name = {line["phase"]: line["seconds"] for line in summary["profile"]}
    ranks = summary.get("ranks", {"peak_memory_mib": [summary["peak_memory_mib"]], "exchanges": 0, "sent_mib": 0.0,
                                  "received_mib": 0.0})
    names = ("blocks", "steps", "factorisations", "crackable_points")
    row = {name: summary[name] for name in names} | {"peak_load": summary["peak"]["load"]}
    row |= {f"memory_{k}": mib for k, mib in enumerate(ranks["peak_memory_mib"])}
    row |= {name: ranks[name] for name in ("exchanges", "sent_mib", "received_mib")}
    return row | {"factorisation": by_name["factorisation"], "whole": summary["timings"]["total"],
                  "shared": sum(by_name.get(name, 0.0) for name in SHARED)}


def measure(deck, ranks, repeats):
    with tempfile.TemporaryDirectory() as folder:
        rows = []
        for _ in range(repeats):
            launcher = (*LAUNCHER, str(ranks)) if ranks > 1 else ()
            done = study.measured(deck, Path(folder) / "run", launcher=launcher)
            if done.exit_code != 0:
                raise SystemExit(f"{ranks} ranks: exit code {done.exit_code}: {done.said}")
            rows.append(row_of(done))
    medians = {name: statistics.median(row[name] for row in rows) for name in ("factorisation", "shared", "whole")}
    columns = {f"memory_{k}": None for k in range(max(RANKS))}
    return {"ranks": ranks} | columns | rows[0] | medians


def main():
    parser = study.parser(__doc__)
    parser.add_argument("--repeats", type=int, default=3, help="runs of which the median is kept (default 3)")
    parser.add_argument("--report", action="store_true", help="run nothing; README from results/many-ranks.csv")
    asked = study.arguments(parser, HERE)
    file = asked.output / "results" / "many-ranks.csv"
    if not asked.report:
        rows = []
        for number in QUICK if asked.quick else TRIANGLES:
            for ranks in RANKS:
                print(f"{number} triangles, {ranks} ranks", file=sys.stderr)
                rows.append(measure(beams.triangles(number), ranks, 1 if asked.quick else asked.repeats))
        study.write_rows(file, rows, digits=6)
    tables.write(asked.output, study.read_rows(file))


if __name__ == "__main__":
    main()
