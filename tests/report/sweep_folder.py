"""A sweep made by hand: two cases that ran, one that stopped and one that failed, in the layout of `dda sweep`.

    sweep_folder.py PROGRAM DECK FOLDER
"""

import csv
import json
import subprocess
import sys
from pathlib import Path

ENERGY = "interfaces.crack.law.fracture_energy"
LENGTH = "path.control"
CASES = ((0.05, "staged"), (0.1, "staged"), (0.1, "opening"), (-1.0, "staged"))
STATUS = {0: "goal_reached", 3: "stopped_early"}


def flattened(value, name=""):
    """Every scalar of a tree of dictionaries, its place joined with dots."""
    if not isinstance(value, dict):
        return {} if isinstance(value, list) else {name: value}
    out = {}
    for key, inner in value.items():
        out.update(flattened(inner, f"{name}.{key}" if name else key))
    return out


def run_case(program, deck, folder, number):
    energy, control = CASES[number - 1]
    run = folder / f"cases/{number:03}"
    result = subprocess.run(
        [program, "run", deck, "--folder", run, "--quiet", "--set", f"{ENERGY}={energy}", "--set", f"{LENGTH}={control}"],
        capture_output=True, text=True, timeout=120, check=False)
    summary = json.loads((run / "summary.json").read_text()) if (run / "summary.json").exists() else {}
    status = STATUS.get(result.returncode, "failed")
    case = {"number": number, "folder": f"cases/{number:03}", "settings": {ENERGY: energy, LENGTH: control},
            "status": status, "reason": summary.get("reason", result.stderr.strip()), "exit_code": result.returncode}
    row = {"case": number, "folder": case["folder"], ENERGY: energy, LENGTH: control, "status": status,
           "exit_code": result.returncode, **{k: v for k, v in flattened(summary).items() if k != "status"}}
    return case, row


def make(program, deck, folder):
    folder = Path(folder)
    folder.mkdir(parents=True)
    cases, rows = zip(*(run_case(program, deck, folder, number) for number in range(1, len(CASES) + 1)))
    (folder / "sweep.yaml").write_text("# Material alone is varied.\ndeck: deck.yaml\n", encoding="utf-8")
    (folder / "sweep.json").write_text(json.dumps({"name": "toughness", "title": "Toughness and <b>control</b>",
                                                   "units": {"length": "mm", "force": "N"}, "cases": cases}), encoding="utf-8")
    names = list(dict.fromkeys(name for row in rows for name in row))
    with open(folder / "sweep.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, names, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    (folder / "sweep.units.json").write_text(json.dumps({"peak.load": "N"}), encoding="utf-8")


if __name__ == "__main__":
    make(*sys.argv[1:])
