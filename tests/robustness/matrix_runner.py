"""Runs the cases of the contact matrix and judges them: a row per case."""
import math
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

from ddapath import Run, study  # noqa: E402
from ddapath.errors import DdapathError, NothingStored  # noqa: E402
from ddapath.verify import verify  # noqa: E402

COLUMNS = ("case", "status", "exit", "steps", "rejected", "end", "peak", "expected", "verdict", "seconds", "reason")


def start_deck(deck, folder, program, limit):
    """Runs a deck into a folder: exit code (or `time`), seconds and the last line said.

    `limit` is the processor time that it may take [s], so that a busy machine changes nothing. A second more is the hard
    limit, at which it would be killed without saying why.
    """
    begun = time.monotonic()
    seconds = math.ceil(limit)
    command = ["prlimit", f"--cpu={seconds}:{seconds + 1}", program, "run", str(deck), "--folder", str(folder), "--overwrite",
               "--quiet", "--threads", "1"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=10 * limit, check=False)
    except subprocess.TimeoutExpired:
        return "time", time.monotonic() - begun, f"not done in {10 * limit:g} s"
    if done.returncode == -signal.SIGXCPU:
        return "time", time.monotonic() - begun, f"not done in {limit:g} s of processor time"
    said = (done.stderr.strip() or done.stdout.strip() or " ").splitlines()[-1]
    return done.returncode, time.monotonic() - begun, said


def told(read, nothing):
    """What `read` gives of a run, `nothing` where the run has not come to that."""
    try:
        return read()
    except NothingStored:
        return nothing


def refusals(folder):
    """The checks of `dda verify` that refuse a run, each with its place."""
    try:
        return [f"{found.check} ({found.worst:.1e} at {found.place})" for found in verify(folder) if not found.holds]
    except (DdapathError, OSError, KeyError, ValueError) as error:
        return [f"cannot be verified: {error}"]


def is_passed_by_jump(row, name, value):
    """Whether joints that snap have carried a gauge beyond its goal, and the run says so."""
    said = f"{name} reached {value:g} and stands at {row['goal'][name]!r}"
    return row["goal"][name] > value and said in row["reason"]


def goals(deck):
    """The values of gauges at which a run ends: of its last stage, or of its path."""
    return deck["stages"][-1].get("until") or deck["path"]["stop"]["gauges"]


def faults(case, row):
    """What is wrong with a case's run, in words; empty when all that is known of it holds."""
    has_stopped = row["exit"] == 3 and case.may_stop and case.may_stop in row["reason"]
    out = [] if row["exit"] == 0 or has_stopped else [f"exit {row['exit']}"]
    if row["exit"] == 0:
        out += [f"{name} stands at {row['goal'][name]:.6g}, not {value:g}" for name, value in goals(case.deck).items()
                if not abs(row["goal"][name] - value) <= 1e-6 * abs(value) and not is_passed_by_jump(row, name, value)]
    for quantity, (value, tolerance) in case.expected.items():
        if has_stopped and quantity == "end":
            continue
        found = row[quantity]
        if found is None or not abs(found - value) <= tolerance:
            out.append(f"{quantity} is not {value:.10g}")
    if case.rejected is not None and row["rejected"] > case.rejected:
        out.append(f"{row['rejected']} rejected")
    return out


def run_case(case, folder, arguments):
    run = folder / case.name
    code, seconds, said = start_deck(folder / f"{case.name}.yaml", run, arguments.run, arguments.time_limit)
    found = Run(run)
    summary, curve = found.summary, told(lambda: found.curve.to_dict("records"), [])
    factors = [entry["load_factor"] for entry in curve]
    rejected = sum(entry["event"] == "rejected" for entry in told(lambda: found.log, []))
    row = {"case": case.name, "status": summary.get("status", "none"), "exit": code, "steps": max(len(factors) - 1, 0),
           "rejected": rejected, "end": factors[-1] if factors else None,
           "peak": max(map(abs, factors)) if factors else None,
           "expected": " ".join(f"{name} {value:.10g}" for name, (value, _) in case.expected.items()),
           "goal": {name: curve[-1][name] for name in goals(case.deck)} if curve else {},
           "seconds": round(seconds, 2), "reason": summary.get("reason", said)}
    wrong = faults(case, row) + (refusals(run) if row["exit"] in (0, 3) else [])
    row["verdict"] = "; ".join(wrong) or "good"
    return row


def shown(value):
    return "" if value is None else f"{value:.10g}" if isinstance(value, float) else str(value)


def run_cases(cases, folder, arguments):
    """The rows in order; each is printed as soon as it is there."""
    print(" | ".join(COLUMNS), flush=True)
    rows = []
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for row in pool.map(lambda case: run_case(case, folder, arguments), cases):
            rows.append(row)
            print(" | ".join(shown(row[column]) for column in COLUMNS), flush=True)
    return rows


def print_rows(rows, path):
    """Writes the rows to `path` where one is given; returns 1 when a case is not good, or there is none."""
    if path:
        study.write_rows(path, [{column: row[column] for column in COLUMNS} for row in rows])
    good = sum(row["verdict"] == "good" for row in rows)
    print(f"{good} of {len(rows)} cases are good", file=sys.stderr)
    return 0 if rows and good == len(rows) else 1
