"""Bodies in motion against closed forms: one block, a chart of blocks on a plane, an arch.

    study.py --program DDA [--quick] [--output FOLDER]

results/single.csv, results/chart.csv, arch.svg and the marked regions of README.md into FOLDER: this folder, or with
--quick, which draws no arch, runs/bodies-in-motion. Exit code 1 where a number is beyond its bound.
"""

import os
import shutil
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import several  # noqa: E402
import single  # noqa: E402
from ddapath import study  # noqa: E402

TOO_THIN, FALLING = 0.1, 0.5  # thickness over radius of an arch that is drawn after some time [s]
MILANKOVITCH = 0.1075  # least t/R of a semicircular arch with radial joints


def table_of(rows):
    lines = ["| case | quantity | closed form | found | error | bound |", "|---|---|---|---|---|---|"]
    for row in rows:
        unit = f" [{row['unit']}]" if row["unit"] else ""
        lines.append(f"| {row['case']} | {row['quantity']}{unit} | {row['exact']:.6g} | {row['found']:.6g} | "
                     f"{row['error']:.1e} | {row['bound']:.0e} |")
    return "\n".join(lines)


def table_of_chart(rows):
    lines = ["| b/h | inclination | friction angle | statics | found |", "|---|---|---|---|---|"]
    lines += [f"| {row['b/h']:g} | {row['inclination']:g}° | {row['friction angle']:g}° | {row['statics']} | {row['found']} |"
              for row in rows]
    return "\n".join(lines)


def main():
    asked = study.arguments(study.parser(__doc__), HERE)
    os.environ["DDA"] = asked.program
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        run = study.Runs(scratch)
        rows = [row for case in (single.QUICK if asked.quick else single.CASES) for row in case(run)]
        if not asked.quick:
            rows.append(single.row("semicircular arch of 26 stones", "least thickness over radius", "", MILANKOVITCH,
                                   several.least_thickness(run), 1e-2))
            falling = several.let_go(run, 26, TOO_THIN, time=FALLING)
            shutil.copy(falling.folder / "motion" / "end.svg", asked.output / "arch.svg")
        chart = several.chart(run, several.CHART[:3] if asked.quick else several.CHART)
    study.write_rows(asked.output / "results" / "single.csv", rows, digits=8)
    study.write_rows(asked.output / "results" / "chart.csv", chart)
    study.write_region(asked.output / "README.md", table_of(rows))
    study.write_region(asked.output / "README.md", table_of_chart(chart), "chart")
    beyond = [row for row in rows if not row["error"] <= row["bound"]]
    wrong = [row for row in chart if not row["agree"]]
    for row in [*beyond, *wrong]:
        print(f"beyond its bound: {row}", file=sys.stderr)
    return 1 if beyond or wrong else 0


if __name__ == "__main__":
    sys.exit(main())
