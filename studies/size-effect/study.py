"""Nominal strength against size: notched and uncracked beams, a straight crack and Voronoi blocks.

    study.py --program DDA [--quick] [--jobs N] [--keep] [--report] [--output FOLDER]

Nine sweeps, NAME.yaml, the same with blocks of second order, and NAME-voronoi.yaml beside this file, into
runs/size-effect (--quick: runs/size-effect-quick); results/straight.csv, results/second-order.csv, results/voronoi.csv,
results/size-effect.svg and the marked region of README.md into FOLDER: this folder, or with --quick runs/size-effect.
"""

import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import ddapath  # noqa: E402
import nominal  # noqa: E402
import report  # noqa: E402
from ddapath import study  # noqa: E402

STRAIGHT_ENERGY, VORONOI_ENERGY = (f"interfaces.{name}.law.fracture_energy" for name in ("ligament", "joints"))
SECOND_ORDER = {"scene.parameters.ligament_size": [4, 2], "scene.parameters.far_size": [64, 64]}
# A few sizes [N/mm], coarse blocks [mm] and two seeds.
QUICK = {"straight": {STRAIGHT_ENERGY: [0.3, 0.03, 0.003],
                      "zip": {"scene.parameters.ligament_size": [4, 2], "scene.parameters.far_size": [32, 16]}},
         "voronoi": {VORONOI_ENERGY: [0.03], "seed": "1..2"}}


def sweep(name, file, changes, asked):
    """(the base deck, the table of the sweep); a case that fails ends the study with its reason."""
    deck = ddapath.read_deck(HERE / f"{file}.yaml")
    started = time.perf_counter()
    table = ddapath.sweep(deck | changes if changes else HERE / f"{file}.yaml", folder=asked.runs / name, jobs=asked.jobs,
                          overwrite=not asked.keep, check=False)
    print(f"{name}: {len(table)} runs, {time.perf_counter() - started:.0f} s", file=sys.stderr)
    failed = table[table["status"] != "goal_reached"]
    if len(failed):
        raise SystemExit("\n".join(f"{asked.runs / case.folder}: {case.reason}" for case in failed.itertuples()))
    return deck, table


def changes_to(kind, beam, is_quick):
    """What becomes of a deck for a sweep; nothing where it is taken as it stands."""
    quick = QUICK["voronoi" if kind == "voronoi" else "straight"]
    if kind != "second-order":
        return {"sweep": quick} if is_quick else {}
    energies = quick if is_quick else ddapath.read_deck(HERE / f"{beam.name}.yaml")["sweep"]
    return {"kinematics": "second_order",
            "sweep": {STRAIGHT_ENERGY: energies[STRAIGHT_ENERGY], "zip": SECOND_ORDER}}


def run_all(asked):
    """The rows of results/straight.csv, results/second-order.csv and results/voronoi.csv."""
    rows = {kind: [] for kind in ("straight", "second-order", "voronoi")}
    for kind, found in rows.items():
        for beam in nominal.BEAMS:
            file = beam.name + "-voronoi" * (kind == "voronoi")
            name = beam.name + f"-{kind}" * (kind != "straight")
            deck, table = sweep(name, file, changes_to(kind, beam, asked.quick), asked)
            found += nominal.strengths(beam, deck, table)
    return rows


def arguments():
    parser = study.parser(__doc__)
    parser.add_argument("--jobs", type=int, help="runs at a time; by default one per processor")
    parser.add_argument("--keep", action="store_true", help="do not repeat the runs that are there")
    parser.add_argument("--report", action="store_true", help="run nothing; figure and README from results/*.csv")
    parser.add_argument("--runs", type=Path, help="where the sweeps go")
    asked = study.arguments(parser, HERE)
    asked.runs = asked.runs or Path("runs") / (HERE.name + "-quick" * asked.quick)
    return asked


def main():
    asked = arguments()
    if not asked.report:
        for kind, rows in run_all(asked).items():
            study.write_rows(asked.output / "results" / f"{kind}.csv", rows, digits=8)
    report.write(asked.output)


if __name__ == "__main__":
    main()
