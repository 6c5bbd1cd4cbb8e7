"""Masonry in motion against limit equilibrium: arches that lack friction or whose supports spread, walls on a ground that moves.

    study.py --program DDA [--quick] [--output FOLDER]

The decks, their figures, results/limits.csv and the marked regions of README.md into FOLDER: this folder, or with --quick
runs/masonry-in-motion. Exit code 1 where a number is beyond its bound.
"""

import math
import os
import shutil
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import arches  # noqa: E402
import decks  # noqa: E402
import walls  # noqa: E402
from ddapath import study  # noqa: E402

CASES = (arches.friction_of_semicircular, arches.friction_of_flat, arches.friction_of_buttresses, arches.spread_at_collapse,
         walls.starts_to_rock, walls.starts_to_slide, walls.slides_under_a_record, walls.slides_stiffly_under_a_record,
         walls.slides_elastically_under_a_record, walls.slides_in_harmonic_motion)


def table_of(rows):
    lines = ["| case | quantity | limit equilibrium | found | error | bound |", "|---|---|---|---|---|---|"]
    lines += [f"| {row['case']} | {row['quantity']} | {row['expected']:.4g} | {row['found']:.4g} | {row['error']:.1%} | "
              f"{bound_of(row)} |" for row in rows]
    return "\n".join(lines)


def bound_of(row):
    return f"{row['bound']:.0%}" if math.isfinite(row["bound"]) else "none"


def figures(run, output):
    """Runs the decks; a row of each: how it ended, and what its energies miss."""
    rows = []
    for name in decks.DECKS:
        done = run(name, output / f"{name}.yaml")
        shutil.copy(done.folder / "motion" / "end.svg", output / f"{name}.svg")
        motion = done.summary["motion"]
        missed = abs(motion["energy_error"]) / motion["external_work"]
        rows.append({"deck": name, "ended": motion["reason"].removeprefix("motion: "), "steps": motion["steps"],
                     "missed": missed})
    return rows


def table_of_decks(rows):
    lines = ["| deck | ended | steps | what the energies miss, of the external work |", "|---|---|---|---|"]
    lines += [f"| [{row['deck']}]({row['deck']}.yaml) | {row['ended']} s | {row['steps']} | {row['missed']:.0e} |" for row in rows]
    return "\n".join(lines)


def limits(asked, run):
    if asked.quick:
        return [arches.friction_of_flat(run, 5e-3), arches.friction_of_buttresses(run, 2e-2)]
    return [case(run) for case in CASES]


def main():
    asked = study.arguments(study.parser(__doc__), HERE)
    os.environ["DDA"] = asked.program
    decks.write(asked.output)
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        run = study.Runs(scratch)
        rows = limits(asked, run)
        if not asked.quick:
            opened, expected = arches.hinges_of_spreading(run)
            ends = figures(run, asked.output)
            study.write_region(asked.output / "README.md", table_of_decks(ends), "decks")
            study.write_region(asked.output / "README.md", f"Joints open in the run at nine tenths of that spread: {opened}; "
                                                           f"by statics: {expected}.", "hinges")
            rows += [] if opened == expected else [arches.row("hinges of the spreading arch", "first", expected[0], opened[0], 0)]
    study.write_rows(asked.output / "results" / "limits.csv", rows, digits=6)
    study.write_region(asked.output / "README.md", table_of(rows))
    beyond = [row for row in rows if not row["error"] <= row["bound"]]
    for row in beyond:
        print(f"beyond its bound: {row}", file=sys.stderr)
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main())
