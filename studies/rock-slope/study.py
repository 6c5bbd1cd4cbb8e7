"""Rock slopes: toppling columns against Goodman and Bray's limit equilibrium, and a jointed slope that comes to rest.

    study.py --program DDA [--quick] [--output FOLDER]

columns.yaml, figures, results/ and the marked regions of README.md into FOLDER: this folder, or with --quick
runs/rock-slope. Exit code 1 where a number is beyond its bound.
"""

import math
import os
import shutil
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import columns  # noqa: E402
import figures  # noqa: E402
from ddapath import deck as decks  # noqa: E402
from ddapath import study  # noqa: E402
from goodman_bray import Slope  # noqa: E402

BOUND = 0.03
MISSED = 1e-6  # by the energies, of the external work


def toppling(run, precise):
    exact = Slope().limiting_angle()
    ends = {"precise": precise} if precise < 0.5 else {"low": exact - 1.2, "high": exact + 1.2, "precise": precise}
    found = columns.limiting_angle(run, **ends)
    tangents = [math.tan(math.radians(angle)) for angle in (exact, found)]
    return {"quantity": "tan φ at the limit", "limit_equilibrium": tangents[0], "found": tangents[1],
            "angle_expected": exact, "angle_found": found, "error": abs(tangents[1] / tangents[0] - 1), "bound": BOUND}


def table_of(row):
    return ("| quantity | Goodman and Bray | found | error | bound |\n|---|---|---|---|---|\n"
            f"| φ at the limit | {row['angle_expected']:.2f}° | {row['angle_found']:.2f}° | | |\n"
            f"| tan φ at the limit | {row['limit_equilibrium']:.4f} | {row['found']:.4f} | {row['error']:.1%} | {BOUND:.0%} |")


def table_of_columns(friction):
    found = Slope().passed_on(friction)
    kinds = [kind for _, kind in found]
    return " · ".join(f"{i + 1} {kind}" for i, kind in enumerate(kinds))


def failing(run, output, settings=None):
    """The jointed slope: how it ends, and whether what is independent of the program agrees."""
    done = run("slope", HERE / "deck.yaml", settings)
    motion = done.summary["motion"]
    told = study.told("verify", done.folder)
    figures.before_and_after(done, output / "slope.svg")
    return {"moving": figures.count(done, "rock"), "ended": motion["reason"].removeprefix("motion: "), "steps": motion["steps"],
            "iterations": motion["iterations"] / motion["steps"], "missed": abs(motion["energy_error"]) / motion["external_work"],
            "friction": motion["friction"] / motion["external_work"],
            "is_at_rest": motion["is_at_rest"], "verified": "all checks hold" in told}


def table_of_slope(row):
    return ("| | |\n|---|---|\n"
            f"| blocks of rock | {row['moving']} |\n| ended | {row['ended']} s |\n"
            f"| time steps; iterations a step | {row['steps']}; {row['iterations']:.1f} |\n"
            f"| energies miss, of the external work | {row['missed']:.0e} (bound {MISSED:.0e}) |\n"
            f"| spent by friction, of the external work | {row['friction']:.0%} |\n"
            f"| `dda verify` | {'all checks hold' if row['verified'] else 'refuses it'} |")


def toppled(run, output):
    """A deck two degrees below the limit, and where its columns are after 8 s."""
    deck = columns.deck(36.0, time=8, frame_every=0.1)
    (output / "columns.yaml").write_text(decks.lines(deck, schema="../../deck.schema.json"), encoding="utf-8")
    done = run("toppled", deck)
    shutil.copy(done.folder / "motion" / "end.svg", output / "columns.svg")


def main():
    asked = study.arguments(study.parser(__doc__), HERE)
    os.environ["DDA"] = asked.program
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        run = study.Runs(scratch)
        row = toppling(run, 0.7 if asked.quick else 0.05)
        quick = {"scene.subdivision.size": 3, "motion.time": 1}
        slope = failing(run, asked.output, quick if asked.quick else None)
        toppled(run, asked.output)
    study.write_rows(asked.output / "results" / "toppling.csv", [row], digits=6)
    study.write_rows(asked.output / "results" / "slope.csv", [slope], digits=6)
    study.write_region(asked.output / "README.md", table_of(row))
    study.write_region(asked.output / "README.md", table_of_columns(row["angle_expected"] - 1e-6), "columns")
    study.write_region(asked.output / "README.md", table_of_slope(slope), "slope")
    right = row["error"] <= BOUND and slope["missed"] <= MISSED and slope["verified"] and (asked.quick or slope["is_at_rest"])
    if not right:
        print(f"beyond its bound: {row} {slope}", file=sys.stderr)
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
