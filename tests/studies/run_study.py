"""Runs one case of a study's expect.yaml and compares the results with what is expected; of every run LOCA must have
taken all steps.

    run_study.py PROGRAM EXPECT.yaml CASE      run the case; exit 1 and the numbers where they are not as expected
    run_study.py --list EXPECT.yaml            the cases and their labels, for CMake

A case has `command` (run or compare), `deck`, `set`, `arguments`, `label`, `exit` and `expect`: a list of
quantities, each a Python expression over summary.json (`peak.load`), `curve` (the rows of curve.csv, or of
compare.csv as `table`), `run` (the runs of a comparison by control) and `runs` (the runs under the settings
of `also`, by name), with one or more of `value` and `relative` or `absolute`, `at_least`, `at_most`, `is`.
"""

import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import expectations
import taken_steps

DEFAULTS = {"command": "run", "deck": "deck.yaml", "set": [], "arguments": [], "label": "fast", "exit": 0, "also": {}}


def strict(function):
    """max and min ignore a NaN that does not come first; these refuse it."""

    def of(values):
        values = list(values)
        if any(value != value for value in values):
            raise ValueError("not a number")
        return function(values)

    return of


FUNCTIONS = {"abs": abs, "max": strict(max), "min": strict(min), "sum": sum, "all": all, "any": any, "len": len,
             "zip": zip, "log": math.log}


def cases(file):
    """The cases by name, with defaults."""
    tree = expectations.parse(file.read_text(encoding="utf-8"))
    for name, case in tree.items():
        unknown = set(case) - set(DEFAULTS) - {"expect"}
        if unknown or not case.get("expect"):
            what = f"unknown {sorted(unknown)}" if unknown else "nothing is expected"
            raise SystemExit(f"{file}: case '{name}': {what}")
    return {name: DEFAULTS | case for name, case in tree.items()}


def as_namespace(value):
    if isinstance(value, dict):
        return SimpleNamespace(**{name.replace(" ", "_"): as_namespace(item) for name, item in value.items()})
    return [as_namespace(item) for item in value] if isinstance(value, list) else value


def rows(file):
    """The rows of a table, as objects with one attribute per column."""
    with file.open(newline="", encoding="utf-8") as stream:
        return [as_namespace({name: expectations.scalar(text) for name, text in row.items()})
                for row in csv.DictReader(stream)]


def results(folder):
    """The names that expressions see of one run folder, or of a comparison."""
    if (folder / "compare.csv").exists():
        table = rows(folder / "compare.csv")
        run = {row.control: as_namespace(results(folder / row.control)) for row in table}
        return {"table": {row.control: row for row in table}, "run": run}
    if not (folder / "summary.json").exists():
        return {}
    summary = as_namespace(json.loads((folder / "summary.json").read_text(encoding="utf-8")))
    return vars(summary) | {"curve": rows(folder / "curve.csv")}


def execute(program, deck, case, settings, folder):
    """Runs the program; its exit code and what it said."""
    command = [program, case["command"], deck, "--folder", folder, "--quiet", *case["arguments"]]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def complaint(check, names):
    """What is wrong with one quantity; "" if nothing is."""
    value = eval(check["quantity"], {"__builtins__": {}, **FUNCTIONS, **names})
    wanted = {name: item for name, item in check.items() if name != "quantity"}
    tolerance = check.get("absolute", check.get("relative", 0) * abs(check.get("value", 0)))
    tests = {
        "value": lambda limit: abs(value - limit) <= tolerance,
        "at_least": lambda limit: value >= limit,
        "at_most": lambda limit: value <= limit,
        "is": lambda limit: str(value) == str(limit),
    }
    asked = [name for name in wanted if name in tests]
    if not asked or set(wanted) - set(tests) - {"relative", "absolute"}:
        return f"{check['quantity']}: expected nothing that is known: {wanted}"
    right = all(tests[name](wanted[name]) for name in asked)
    print(f"{'ok    ' if right else 'FAILED'} {check['quantity']} = {value}; expected {wanted}")
    return "" if right else check["quantity"]


def run_case(program, file, case):
    """What is not as expected; the first run is the one whose results have names of their own."""
    with tempfile.TemporaryDirectory() as work:
        runs, names = {}, {}
        for name, settings in {"": case["set"], **case["also"]}.items():
            folder = Path(work) / (name or "run")
            code, said = execute(program, file.parent / case["deck"], case, settings, folder)
            if code != case["exit"]:
                return [f"exit code {code} instead of {case['exit']}: {said[-2000:]}"]
            if untaken := list(taken_steps.complaints(folder)):
                return untaken
            found = results(folder)
            names = names or found
            if name:
                runs[name] = as_namespace(found)
        names["runs"] = SimpleNamespace(**runs)
        return [wrong for wrong in (complaint(check, names) for check in case["expect"]) if wrong]


def main(arguments):
    if arguments[0] == "--list":
        for name, case in cases(Path(arguments[1])).items():
            print(name, case["label"])
        return 0
    file = Path(arguments[1])
    wrong = run_case(arguments[0], file, cases(file)[arguments[2]])
    if wrong:
        print("not as expected:", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
