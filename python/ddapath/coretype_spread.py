"""How far runs of one deck spread over the kernels of OpenBLAS, which differ in their last digits.

The path of an instantaneous release is chaotic: which of two points at their strength goes first may hang on the last digit.
Used by the study.py of the studies with such decks:

    coretype_spread.main(folder, gauge, text)  writes folder/results/spread.csv and the marked region of folder/README.md
"""

import argparse
import os
import tempfile
from pathlib import Path

from . import study

KERNELS = ["Prescott", "Nehalem", "Sandybridge", "Haswell", "SkylakeX", "Zen"]


def execute(deck, kernel, gauge):
    """The row of one run."""
    with tempfile.TemporaryDirectory() as work:
        done = study.measured(deck, Path(work) / "run", environment={"OPENBLAS_CORETYPE": kernel})
        summary, last = done.run.summary, done.run.curve.iloc[-1]
    return {"kernel": kernel, "exit_code": done.exit_code, "steps": summary["steps"], "rescues": summary["rescues"],
            "peak": summary["peak"]["load"], "peak_at": summary["peak"]["gauges"][gauge], "last_load": float(last["load"]),
            "last_at": float(last[gauge]), "balance": summary["energy_balance_error"]}


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


def main(folder, gauge, description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", required=True, help="the program dda")
    parser.add_argument("--kernels", nargs="+", default=KERNELS, help="values of OPENBLAS_CORETYPE")
    arguments = parser.parse_args()
    os.environ["DDA"] = str(Path(arguments.program).resolve())
    rows = [execute(folder / "release.yaml", kernel, gauge) for kernel in arguments.kernels]
    (folder / "results").mkdir(exist_ok=True)
    study.write_rows(folder / "results" / "spread.csv", rows)
    study.write_region(folder / "README.md", "\n".join(table(rows, gauge, "mm")), "spread")
