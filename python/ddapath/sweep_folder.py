"""A sweep folder as one table: a row per case, what was varied beside what came out."""

import json
from pathlib import Path

import pandas as pd

from .errors import NotFound
from .run_folder import Run, read_numbers, whole_lines


def read_sweep(folder):
    """The sweep in a folder, finished or not: a DataFrame with a row per case, index `case`.

    Columns: folder, the varied parameters by their dotted keys, status, reason, exit_code, every value of the runs'
    summaries (`peak.load`), and `run`, a Run that reads nothing before it is asked.
    attrs: name, title, axes of the sweep, and units, the unit of each column.
    """
    path = Path(folder)
    if not (path / "sweep.json").is_file():
        hint = "; this is one run: use read_run" if (path / "effective_deck.yaml").exists() else ""
        what = "this is no sweep folder, it has no sweep.json" if path.is_dir() else "there is no such folder"
        raise NotFound(f"{path}: {what}{hint}")
    sweep = json.loads((path / "sweep.json").read_text(encoding="utf-8"))
    table = joined(from_cases(path, sweep["cases"]), from_csv(path / "sweep.csv"))
    table["run"] = [Run(path / name) for name in table["folder"]]
    units = path / "sweep.units.json"
    table.attrs = {name: sweep.get(name) for name in ("name", "title", "axes")}
    table.attrs["units"] = json.loads(units.read_text(encoding="utf-8")) if units.exists() else {}
    return table


def from_cases(path, cases):
    """What sweep.json says of the cases, also of those that have no results."""
    rows = [{"case": int(case["number"]), "folder": case["folder"], **case["settings"],
             **{name: case.get(name) for name in ("status", "reason", "exit_code")}} for case in cases]
    if not rows:
        raise NotFound(f"{path}: this sweep has no case")
    return pd.DataFrame(rows).set_index("case")


def from_csv(file):
    """The table of results; empty as long as no case has ended."""
    text = whole_lines(file) if file.exists() else ""
    if not text:
        return pd.DataFrame(index=pd.Index([], name="case"))
    table = read_numbers(text)
    table["case"] = table["case"].astype(int)
    return table.set_index("case")


def joined(cases, results):
    """Settings and folders as sweep.json has them, which knows their types; everything else is a result."""
    return cases.join(results[[name for name in results.columns if name not in cases.columns]])
