"""How far the method carries: one beam under every setting, shape, unit and placement.

    study.py --program build/release/bin/dda [--only matrix,alpha] [--jobs 2] [--output FOLDER]

Writes results/NAME.csv and results/NAME.svg per section and its region of README.md. Exit code 1 where a run failed
or two paths that should be one differ; every such case is named at the end.
"""

import argparse
import os
import shutil
import sys
import tempfile
from pathlib import Path

import augmented
import brittle
import locking
import matrix
import placement
import settings
import shapes
from runs import Runner

HERE = Path(__file__).resolve().parent
SECTIONS = {
    "matrix": matrix.section,
    "alpha": settings.alpha,
    "penalty": settings.penalty,
    "augmented": augmented.section,
    "shapes": shapes.shapes,
    "unlike": shapes.unlike,
    "brittle": brittle.brittle,
    "units": placement.units,
    "placement": placement.placement,
    "seeds": brittle.seeds,
    "locking": locking.locking,
}
QUICK = ("matrix", "alpha", "units", "placement")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, type=Path, help="the program dda")
    parser.add_argument("--only", default="", help="sections, separated by commas; all without it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time")
    parser.add_argument("--limit", type=float, default=300, help="seconds after which a run has failed")
    parser.add_argument("--output", type=Path,
                        help="where results/ and README.md are written: here, for --quick into runs/stability")
    parser.add_argument("--work", type=Path, help="keeps the runs here; what is there already is not run again")
    parser.add_argument("--failures", type=Path, help="keeps deck and end of the log of runs that fail")
    parser.add_argument("--quick", action="store_true", help="few and small runs of some sections")
    found = parser.parse_args()
    found.output = found.output or (HERE.parents[1] / "runs" / "stability" if found.quick else HERE)
    return found


def selected(only, quick):
    names = [name for name in only.split(",") if name] or (QUICK if quick else list(SECTIONS))
    unknown = sorted(set(names) - set(SECTIONS))
    if unknown:
        raise SystemExit(f"unknown sections: {', '.join(unknown)}; there are: {', '.join(SECTIONS)}")
    return names


def main():
    wanted = arguments()
    wanted.output.mkdir(parents=True, exist_ok=True)
    if not (wanted.output / "README.md").exists():
        shutil.copy(HERE / "README.md", wanted.output)
    complaints = []
    with tempfile.TemporaryDirectory() as work:
        runner = Runner(wanted.program.resolve(), wanted.work or Path(work), wanted.jobs, wanted.limit, wanted.failures)
        for name in selected(wanted.only, wanted.quick):
            section = SECTIONS[name](runner, wanted.quick)
            if section:
                section.write(wanted.output)
                complaints += section.complaints
                print(f"{name}: {section.sentence}", flush=True)
    print(*(f"WRONG {complaint}" for complaint in complaints), sep="\n")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
