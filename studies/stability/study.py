"""How far the method carries: one beam under every setting, shape, unit and placement.

    study.py --program build/release/bin/dda [--only matrix,alpha] [--jobs 2] [--output FOLDER]

Writes results/NAME.csv and results/NAME.svg per section and its region of README.md. Exit code 1 where a run failed
or two paths that should be one differ; every such case is named at the end.
"""

import os
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import augmented  # noqa: E402
import brittle  # noqa: E402
import locking  # noqa: E402
import matrix  # noqa: E402
import placement  # noqa: E402
import settings  # noqa: E402
import shapes  # noqa: E402
from ddapath import study  # noqa: E402
from runs import Runner  # noqa: E402

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
    parser = study.parser(__doc__)
    parser.add_argument("--only", default="", help="sections, separated by commas; all without it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time")
    parser.add_argument("--limit", type=float, default=300, help="seconds after which a run has failed")
    parser.add_argument("--work", type=Path, help="keeps the runs here; what is there already is not run again")
    parser.add_argument("--failures", type=Path, help="keeps deck and end of the log of runs that fail")
    return study.arguments(parser, HERE)


def selected(only, quick):
    names = [name for name in only.split(",") if name] or (QUICK if quick else list(SECTIONS))
    unknown = sorted(set(names) - set(SECTIONS))
    if unknown:
        raise SystemExit(f"unknown sections: {', '.join(unknown)}; there are: {', '.join(SECTIONS)}")
    return names


def main():
    wanted = arguments()
    complaints = []
    with tempfile.TemporaryDirectory() as work:
        runner = Runner(wanted, wanted.work or Path(work))
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
