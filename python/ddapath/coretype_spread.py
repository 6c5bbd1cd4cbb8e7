"""How far runs of one deck spread over the kernels of OpenBLAS, which differ in their last digits.

The path of an instantaneous release is chaotic: which of two points at their strength goes first may hang on the last digit.
Used by the study.py of the studies with such decks:

    coretype_spread.main(folder, gauge, text)  writes folder/results/spread.csv and the marked region of folder/README.md
"""

import argparse
import csv
import json
import os
import subprocess
import tempfile
from pathlib import Path

KERNELS = ["Prescott", "Nehalem", "Sandybridge", "Haswell", "SkylakeX", "Zen"]
BEGIN, END = "<!-- spread: begin -->", "<!-- spread: end -->"


def last_row(run, gauge):
    with (run / "curve.csv").open(newline="", encoding="utf-8") as stream:
        row = list(csv.DictReader(stream))[-1]
    return float(row["load"]), float(row[gauge])


def execute(program, deck, kernel, gauge):
    """The row of one run."""
    with tempfile.TemporaryDirectory() as work:
        run = Path(work) / "run"
        done = subprocess.run([program, "run", deck, "--folder", run, "--quiet", "--threads", "1"], check=False,
                              stdout=subprocess.DEVNULL, env={**os.environ, "OPENBLAS_CORETYPE": kernel})
        summary = json.loads((run / "summary.json").read_text(encoding="utf-8"))
        load, place = last_row(run, gauge)
    return {"kernel": kernel, "exit_code": done.returncode, "steps": summary["steps"], "rescues": summary["rescues"],
            "peak": summary["peak"]["load"], "peak_at": summary["peak"]["gauges"][gauge], "last_load": load, "last_at": place,
            "balance": summary["energy_balance_error"]}


def table(rows, gauge, unit):
    yield f"| kernel | exit code | steps | rescues | peak [N] | at {gauge} [{unit}] | last load [N] | at {gauge} [{unit}] | energy balance error |"
    yield "|---|---|---|---|---|---|---|---|---|"
    for row in rows:
        yield (f"| {row['kernel']} | {row['exit_code']} | {row['steps']} | {row['rescues']} | {row['peak']:.6g} | {row['peak_at']:.4g} | "
               f"{row['last_load']:.4g} | {row['last_at']:.4g} | {row['balance']:.1e} |")
    steps, peaks, last = ([row[name] for row in rows] for name in ("steps", "peak", "last_load"))
    yield ""
    yield (f"Spread: {min(steps)} to {max(steps)} steps, {100 * (max(peaks) / min(peaks) - 1):.1e} % of the peak; the last load differs by "
           f"{100 * (max(last) - min(last)) / min(peaks):.1e} % of the peak.")


def write(readme, lines):
    """Replaces what is between the marks; nothing there is typed."""
    before, rest = readme.read_text(encoding="utf-8").split(BEGIN)
    after = rest.split(END)[1]
    readme.write_text(before + BEGIN + "\n" + "\n".join(lines) + "\n" + END + after, encoding="utf-8")


def main(folder, gauge, description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", required=True, help="the program dda")
    parser.add_argument("--kernels", nargs="+", default=KERNELS, help="values of OPENBLAS_CORETYPE")
    arguments = parser.parse_args()
    rows = [execute(arguments.program, folder / "release.yaml", kernel, gauge) for kernel in arguments.kernels]
    results = folder / "results"
    results.mkdir(exist_ok=True)
    with (results / "spread.csv").open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    write(folder / "README.md", table(rows, gauge, "mm"))
