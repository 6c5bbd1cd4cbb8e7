"""Checks of curve.csv and summary.json: finite numbers, energies, and whether the last row is what the reason says."""
import re

import numpy as np

from .finding import Finding, not_made, worst_of

BALANCE = 0.02     # of the external work: what may be unaccounted for
ROUNDING = 1e-9    # of the largest energy
SUMMARY = 1e-9     # of the number itself
GOAL = 1e-6        # of the gauge's target
RUPTURE = 1e-3     # of the peak: what "complete rupture" may leave
MAY_BE_UNKNOWN = re.compile(r"negative_|current_stiffness|rigid_modes|mu_")  # nan where it is not known
NUMBER = r"([-+]?[0-9.]+(?:e[-+]?[0-9]+)?)"


def finite(curve):
    """The number of cells that are no numbers, and the first of them."""
    numbers = curve.select_dtypes("number")
    numbers = numbers[[name for name in numbers if not MAY_BE_UNKNOWN.match(name)]]
    bad = ~np.isfinite(numbers.to_numpy())
    wrong = [name for name in curve if curve[name].dtype == object and name != "control"]
    rows, columns = np.nonzero(bad)
    place = f"row {rows[0]}, {numbers.columns[columns[0]]}" if len(rows) else ", ".join(wrong) or "everywhere"
    return Finding("every number is finite", float(bad.sum() + len(wrong)), 0.0, place)


def energies_never_fall(curve):
    found = []
    scale = max(np.abs(curve[["external_work", "dissipated_energy"]].to_numpy()).max(), 1e-300)
    for name in curve:
        if name == "dissipated_energy" or name.startswith("dissipated_energy_"):
            fall = -np.diff(curve[name], prepend=curve[name][0]) / scale
            found.append((fall.max(), f"step {int(np.argmax(fall))}, {name}"))
    return worst_of("dissipated energy never falls", found, ROUNDING)


def jumps(log, rows):
    """Energy of the jumps up to each row, from the steps of log.jsonl."""
    out = np.zeros(rows)
    for entry in log:
        if entry.get("event") == "step" and 0 <= entry["step"] < rows:
            out[entry["step"]] = entry.get("jump_energy", 0.0)
    return np.cumsum(out)


def unaccounted(curve, log):
    """Work − stored − dissipated − jumps at every row since the first [FL]."""
    work, stored, spent = (curve[name] - curve[name][0] for name in ("external_work", "stored_energy", "dissipated_energy"))
    return (work - stored - spent - jumps(log, len(curve))).to_numpy()


def balance(curve, log):
    """Rows are compared with the largest work so far: just after the start, or fully unloaded, a row's own is none."""
    work = np.abs(curve["external_work"] - curve["external_work"][0]).to_numpy()
    largest = np.maximum(np.maximum.accumulate(work), 1e-2 * work.max())
    error = np.abs(unaccounted(curve, log))
    ratio = np.where(error > 0, error / np.where(largest > 0, largest, 1e-300), 0)
    step = int(np.argmax(np.where(np.isnan(ratio), np.inf, ratio)))
    return Finding("work = stored + dissipated + jumps", float(ratio[step]), BALANCE, f"step {step}")


def summary_agrees(curve, log, summary):
    if not summary:
        return not_made("summary.json agrees with curve.csv", "there is no summary: the run is not finished")
    last, peak = curve.iloc[-1], summary["peak"]
    pairs = [(name, summary[name], last[name]) for name in ("external_work", "stored_energy", "dissipated_energy")]
    pairs += [("steps", summary["steps"], len(curve) - 1)]
    if 0 <= peak["step"] < len(curve):
        pairs += [(f"peak {name}", peak[name], curve[name][peak["step"]]) for name in ("load", "load_factor")]
        pairs += [("peak load", abs(peak["load"]), np.abs(curve["load"]).max())]
    else:
        pairs += [("peak step", peak["step"], len(curve) - 1)]
    found = [(mismatch(a, b), name) for name, a, b in pairs]
    work = abs(last["external_work"] - curve["external_work"][0])
    own = abs(unaccounted(curve, log)[-1]) / work if work > 0 else 0.0
    found.append((max(abs(summary["energy_balance_error"] - own) - 1e-9, 0) if own < 1e6 else 0.0, "energy_balance_error"))
    return worst_of("summary.json agrees with curve.csv", found, SUMMARY)


def mismatch(a, b):
    if a is None or b is None:
        return float("nan")
    return abs(a - b) / max(abs(a), abs(b), 1e-300) if a != b else 0.0


def of_gauge(reason, curve):
    """"deflection reached 0.1": the last row stands there."""
    for name in sorted(curve.columns, key=len, reverse=True):
        found = re.match(re.escape(name.removeprefix("gauge_")) + " reached " + NUMBER, reason)
        if found:
            target = float(found[1])
            scale = max(abs(target), 1e-3 * np.abs(curve[name]).max(), 1e-300)
            return abs(curve[name].iloc[-1] - target) / scale, f"{name} is {curve[name].iloc[-1]:.6g}"
    return None


def of_load(reason, curve):
    """"load below 10 % of its peak", and rupture: how far above that share the last row is, in units of the peak."""
    load = np.abs(curve["load"].to_numpy())
    found = re.match("load below " + NUMBER + " % of its peak", reason)
    share = float(found[1]) / 100 if found else RUPTURE if reason.startswith("complete rupture") else None
    if share is None:
        return None
    peak = load.max()
    left = load[-1] / peak if peak > 0 else float("nan")
    return max(left - share, 0.0) if left == left else left, f"{left:.6g} of the peak is left"


def reason_is_true(curve, summary, deck):
    name = "last row is what the reason says"
    status, reason = summary.get("status", ""), summary.get("reason", "")
    if status != "goal_reached":
        said = bool(reason) and bool(status)
        return Finding(name, 0.0 if said else float("nan"), GOAL, f"{status or 'no status'}: {reason or 'no reason'}")
    found = of_gauge(reason, curve) or of_load(reason, curve)
    if found is None:
        return Finding(name, 0.0 if is_known_goal(reason, curve, deck) else float("nan"), GOAL, f"goal reached: {reason}")
    return Finding(name, float(found[0]), GOAL, f"step {len(curve) - 1}: {found[1]}")


def is_known_goal(reason, curve, deck):
    """Goals that no gauge tells: a number of steps that the deck asks for, and a structure that only loads can end."""
    steps = re.match(NUMBER + " steps", reason)
    if steps:
        return len(curve) - 1 == int(float(steps[1])) == deck["path"]["stop"].get("steps")
    can_crack = any(law_type(entry) not in ("bonded", "elastic") for entry in deck.get("interfaces", {}).values())
    return "nothing can crack" in reason and not can_crack and abs(curve["load_factor"].iloc[-1] - 1) <= GOAL


def law_type(entry):
    return entry["law"] if isinstance(entry["law"], str) else entry["law"]["type"]


def all_checks(run):
    curve, log, summary = run.curve, run.log, run.summary
    out = [finite(curve), energies_never_fall(curve), balance(curve, log), summary_agrees(curve, log, summary)]
    if summary:
        return [*out, reason_is_true(curve, summary, run.deck)]
    return [*out, not_made("last row is what the reason says", "there is no summary: the run is not finished")]
