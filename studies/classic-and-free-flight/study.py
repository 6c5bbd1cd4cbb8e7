"""`classic` against `free_flight` on the same scenes: errors, energies, failures, time.

    study.py --program DDA [--quick] [--output FOLDER]

results/scenes.csv, results/collapse.csv, rebound.svg, collapse.svg and the marked regions of README.md into FOLDER: this
folder, or with --quick runs/classic-and-free-flight. Exit code 1 where a number that has a bound is beyond it.
"""

import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import collapses  # noqa: E402
import pictures  # noqa: E402
import scenes  # noqa: E402
from ddapath import study  # noqa: E402
from scenes import FREE_FLIGHT, classic  # noqa: E402

PENALTIES = (0.1, 1, 10, 100)
BOUNDS = {"slides": 1e-3, "ten turns": 1e-9, "stack": 1e-3}  # of free_flight, and of classic where it has exact rotations


def single(run, is_quick):
    far = {"displacement": 0.2}
    steps = (0.003,) if is_quick else (0.001, 0.003, 0.01, 0.03)
    turns = (100,) if is_quick else (100, 200, 1000)
    spinning = [FREE_FLIGHT, classic(displacement=0.5), classic(displacement=0.5, rotation="first_order")]
    rows = scenes.incline(run, [FREE_FLIGHT, classic(**far)], steps) + scenes.spin(run, spinning, turns)
    standing = [FREE_FLIGHT, classic(velocity_kept=0.95)] + ([] if is_quick else [classic()])
    return rows + scenes.stack(run, standing, 4 if is_quick else 10)


def bounces(run, is_quick):
    steps = (0.01,) if is_quick else (0.0003, 0.001, 0.003, 0.006, 0.01)
    penalties = (10,) if is_quick else PENALTIES
    return scenes.bounce(run, [FREE_FLIGHT, *(classic(penalty=p, displacement=0.2) for p in penalties)], steps)


def table_of(rows):
    lines = ["| scene | integrator | quantity | exact | found | error | energy missed | energy created | steps | rejected | "
             "systems a step | time [s] |", "|" + 12 * "---|"]
    for row in rows:
        lines.append(f"| {row['scene']} | {row['integrator']} | {row['quantity']} | {row['exact']:.6g} | {row['found']:.6g} | "
                     f"{row['error']:.0e} | {row['missed']:.0e} | {row['created']:.0e} | {row['steps']} | {row['rejected']} | "
                     f"{row['solves'] / max(row['steps'], 1):.1f} | {row['seconds']:.2g} |")
    return "\n".join(lines)


def table_of_bounces(rows):
    steps = sorted({row["step"] for row in rows})
    lines = ["| speed after / before, dt = | " + " | ".join(f"{1000 * step:g} ms" for step in steps) + " |",
             "|" + (1 + len(steps)) * "---|"]
    for name in dict.fromkeys(row["integrator"] for row in rows):
        found = {row["step"]: row["found"] for row in rows if row["integrator"] == name}
        lines.append(f"| {name.removesuffix(', displacement 0.2')} | " + " | ".join(f"{found[step]:.3f}" for step in steps) + " |")
    return "\n".join(lines)


def beyond(rows):
    """Rows of either integrator, rotations in first order and undamped ringing excepted, that are beyond their bound."""
    for row in rows:
        bound = next((bound for scene, bound in BOUNDS.items() if row["scene"].startswith(scene)), None)
        is_bounded = "first_order" not in row["integrator"] and not (row["scene"].startswith("stack") and row["integrator"] == "classic")
        if bound and is_bounded and not row["error"] <= bound:
            yield row


def main():
    asked = study.arguments(study.parser(__doc__), HERE)
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        run = study.Runs(scratch)
        rows, rebounds = single(run, asked.quick), bounces(run, asked.quick)
        fallen = collapses.collapse(Path(scratch), asked.quick)
    results = asked.output / "results"
    study.write_rows(results / "scenes.csv", rows + [{k: v for k, v in row.items() if k != "step"} for row in rebounds], digits=8)
    study.write_rows(results / "collapse.csv", [row for row, _ in fallen], digits=8)
    study.write_region(asked.output / "README.md", table_of(rows))
    study.write_region(asked.output / "README.md", table_of_bounces(rebounds), "bounce")
    study.write_region(asked.output / "README.md", collapses.table_of([row for row, _ in fallen]), "collapse")
    pictures.rebound(rebounds, asked.output / "rebound.svg")
    pictures.collapse(fallen, asked.output / "collapse.svg")
    wrong = list(beyond(rows))
    for row in wrong:
        print(f"beyond its bound: {row}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
