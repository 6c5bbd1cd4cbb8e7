"""Checks of curve.csv and summary.json: finite numbers, energies, and whether the last row is what the reason says."""
import re

import numpy as np

from .finding import Finding, not_made, worst_of

BALANCE = 0.05     # of the external work: what may be unaccounted for, unless the deck's stop.energy_error says otherwise
ROUNDING = 1e-9    # of the largest energy
SUMMARY = 1e-9     # of the number itself
GOAL = 1e-6        # of the gauge's target
PRINTED = 1e-5     # to which a reason's numbers are printed
NOTHING = 1e-6     # of the work of the dead loads: what live loads may do and count as having done none
RUPTURE = 1e-3     # of the peak: what "complete rupture" may leave
LEFT = 1e-2        # the same where the reason says how much
MAY_BE_UNKNOWN = re.compile(r"negative_|current_stiffness|rigid_modes|mu_|frequency_")  # nan where it is not known
FORCE = 1e-8       # of the largest reaction: a load that is none within the tolerances of the path
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


def balance(curve, log, deck):
    """Rows are compared with the largest work so far: just after the start, or fully unloaded, a row's own is none.

    Nor is what a load does by which nothing resists; less than `NOTHING` of the work of the dead loads counts as that, and
    what the force that counts as none does along the gauges, which a mechanism moves far. What the rounding of stiff springs
    does that drive a displacement is no error.
    """
    work = np.abs(curve["external_work"] - curve["external_work"][0]).to_numpy()
    none = max(NOTHING * abs(curve["external_work"][0]), tolerated_force(curve, deck) * largest_travel(curve, deck))
    largest = np.maximum.accumulate(work).clip(max(1e-2 * work.max(), none))
    error = np.maximum(np.abs(unaccounted(curve, log)) - rounding_of_drives(curve, deck), 0)
    ratio = np.where(error > 0, error / np.where(largest > 0, largest, 1e-300), 0)
    step = int(np.argmax(np.where(np.isnan(ratio), np.inf, ratio)))
    return Finding("work = stored + dissipated + jumps", float(ratio[step]),
                   deck["path"]["stop"].get("energy_error", BALANCE), f"step {step}")


def rounding_of_drives(curve, deck):
    """What the forces of the springs that drive displacements may do by rounding alone: some ε p̄ u along u [FL]."""
    some = 4
    ways = [load["displacement"] for stage in deck.get("stages", []) for load in stage.get("loads", [])
            if load["type"] == "prescribed_displacement"]
    moduli = [material.get("young_modulus", 0) for material in deck.get("materials", {}).values()]
    stiffness = deck.get("support_stiffness", 0) * max(moduli, default=0) * deck.get("thickness", 0)
    way = np.abs(curve["load_factor"]).max() * max(map(abs, ways), default=0)
    return some * np.finfo(float).eps * stiffness * way**2


def of_last_stage(curve, deck):
    """The rows whose load is that of the last row: where several stages are followed each has a load of its own."""
    return curve[curve["stage"] == curve["stage"].iloc[-1]] if len(followed_stages(deck)) > 1 else curve


def followed_stages(deck):
    """Numbers of the stages whose loads the load factor multiplies: from the first with `until` on, or the last."""
    loaded = [(number, bool(stage.get("until"))) for number, stage in enumerate(deck.get("stages", []), start=1) if stage.get("loads")]
    first = next((i for i, (_, ends) in enumerate(loaded) if ends), len(loaded) - 1)
    return [number for number, _ in loaded[first:]]


def summary_agrees(run):
    curve, log, summary = run.curve, run.log, run.summary
    if not summary:
        return not_made("summary.json agrees with curve.csv", "there is no summary: the run is not finished")
    last, peak = curve.iloc[-1], summary["peak"]
    pairs = [(name, summary[name], last[name]) for name in ("external_work", "stored_energy", "dissipated_energy")]
    pairs += [("steps", summary["steps"], len(curve) - 1)]
    if "whole_iterations" in summary:  # else it is of an earlier version
        pairs += [("newton_iterations", summary["newton_iterations"], curve["newton_iterations"].sum())]
    if 0 <= peak["step"] < len(curve):
        pairs += [(f"peak {name}", peak[name], curve[name][peak["step"]]) for name in ("load", "load_factor")]
        largest = (np.sign(peak["load"] or 1) * of_last_stage(curve, run.deck)["load"]).max()  # the other way it unloads
        pairs += [("peak load", abs(peak["load"]), largest if largest > least_load(curve) else abs(peak["load"]))]
    else:
        pairs += [("peak step", peak["step"], len(curve) - 1)]
    found = [(mismatch(a, b), name) for name, a, b in pairs]
    work = np.abs(curve["external_work"] - curve["external_work"][0]).max()
    own = abs(unaccounted(curve, log)[-1]) / work if work > 0 else 0.0
    found.append((max(abs(summary["energy_balance_error"] - own) - 1e-9, 0) if own < 1e6 else 0.0, "energy_balance_error"))
    return worst_of("summary.json agrees with curve.csv", found, SUMMARY)


def least_load(curve):
    """What counts as a load [F]: more than `NOTHING` of the largest reaction, dead loads' among them."""
    reactions = curve.filter(regex=r"\.[xy]$").abs().to_numpy()
    return NOTHING * reactions.max(initial=0)


def mismatch(a, b):
    if a is None or b is None:
        return float("nan")
    return abs(a - b) / max(abs(a), abs(b), 1e-300) if a != b else 0.0


def of_gauge(reason, curve, deck):
    """"deflection reached 0.1": the last row stands there; "... and stands at 0.11": a jump has led beyond, to there."""
    for name in sorted(curve.columns, key=len, reverse=True):
        found = re.fullmatch(re.escape(name.removeprefix("gauge_")) + f" reached {NUMBER}(?: and stands at {NUMBER})?", reason)
        if not found:
            continue
        values, target = curve[name].to_numpy(), float(found[1])
        scale = max(abs(target), 1e-3 * np.abs(values).max(), 1e-300)
        if not found[2]:
            return abs(values[-1] - target) / scale, f"{name} is {values[-1]:.6g}"
        beyond = min(values[0], values[-1]) <= target <= max(values[0], values[-1])
        error = abs(values[-1] - float(found[2])) / max(abs(values[-1]), 1e-300)
        return (max(error - PRINTED, 0) if beyond else float("nan")), f"{name} is {values[-1]:.6g}"
    return None


def of_load(reason, curve, deck):
    """"load below 10 % of its peak", and rupture: how far above that share the last row is, in units of the peak.

    "load below 10 % of its peak, turned round to -45 %": a jump has led to so much of a load against that of the peak.
    """
    load = of_last_stage(curve, deck)["load"].to_numpy()
    found, said = re.match(f"load below {NUMBER} % of its peak", reason), re.search(f"{NUMBER} of the peak", reason)
    if not found and not reason.startswith("complete rupture"):
        return None
    if turned := re.search(f"turned round to {NUMBER} %", reason):
        left = -abs(load[-1]) / max((-np.sign(load[-1]) * load).max(), 1e-300)
        return max(abs(left - float(turned[1]) / 100) - PRINTED * abs(left), 0.0), f"{left:.6g} of the peak acts against it"
    share = float(found[1]) / 100 if found else min(1.1 * float(said[1]), LEFT) if said else RUPTURE
    peak = np.abs(load).max()
    left = abs(load[-1]) / peak if peak > 0 else float("nan")
    return max(left - share, 0.0) if left == left else left, f"{left:.6g} of the peak is left"


def largest_travel(curve, deck):
    """By how much a gauge of displacements has moved at most [L]."""
    gauges = [name for name, gauge in deck.get("gauges", {}).items() if gauge.get("type") in ("displacement", "relative_displacement")]
    columns = [f"gauge_{name}" if f"gauge_{name}" in curve else name for name in gauges]  # where the name is another column's
    return max((np.abs(curve[name] - curve[name][0]).max() for name in columns if name in curve), default=0.0)


def tolerated_force(curve, deck):
    """What a load may be and count as none: a force that the path's tolerances leave of the largest reaction [F]."""
    path, supports = deck.get("path", {}), deck.get("supports", {})
    treatments = [interface.get("treatment") for interface in deck.get("interfaces", {}).values()]
    iterates = any("augmented_lagrangian" in (kind, kind.get("type") if isinstance(kind, dict) else kind) for kind in treatments)
    gap = path.get("multipliers", {}).get("tolerance", 1e-8) if iterates else 0
    tolerance = max(FORCE, 10 * (path.get("newton", {}).get("tolerance", 0) + gap))
    reactions = [name for name in curve if name.rpartition(".")[0] in supports]
    return tolerance * np.abs(curve[reactions].to_numpy()).max() if reactions else 0.0


def of_factor(reason, curve, deck):
    """"slides as a mechanism at a load factor of 6": the last row stands there, and so did the one before."""
    found = re.search(f"load factor of {NUMBER}", reason)
    if not found:
        return None
    largest_of_all = np.abs(curve["load_factor"]).max()
    curve = of_last_stage(curve, deck)
    factor, before = curve["load_factor"].iloc[-1], curve["load_factor"].iloc[-2 if len(curve) > 1 else -1]
    scale = max(abs(factor), 1e-9 * largest_of_all, 1e-300)
    error = max(abs(factor - float(found[1])) / scale - PRINTED, 0)
    largest = np.abs(curve["load"]).max()
    is_none = largest <= tolerated_force(curve, deck)
    if "mechanism" in reason and is_none:
        error = abs(float(found[1]))
    elif "mechanism" in reason and len(curve) > 1:
        change = abs(curve["load"].iloc[-1] - curve["load"].iloc[-2]) / max(largest, 1e-300)
        if "within 0.1 %" in reason:
            change *= GOAL / 1e-3
        error = max(error, change - tolerated_force(curve, deck) / max(largest, 1e-300))
    return error, f"load factor {factor:.9g}, before {before:.9g}"


def of_steps(reason, curve, deck):
    """"100 steps", where the deck asks for so many."""
    found = re.fullmatch(f"{NUMBER} steps", reason)
    if not found:
        return None
    wanted = deck["path"]["stop"].get("after_steps", 0)
    return (0.0 if len(curve) - 1 == int(float(found[1])) == wanted else float("nan")), f"{len(curve) - 1} steps, {wanted} are asked for"


def of_full_load(reason, curve, deck):
    """"nothing can crack": true where no law can crack, slide or open, and the load is applied; "no joint slides": where it is."""
    if "it is applied in full" in reason:
        return abs(curve["load_factor"].iloc[-1] - 1), "load factor"
    if "begins where joints slide on" in reason:
        slides = any(law_type(entry) not in ("bonded", "elastic") for entry in deck.get("interfaces", {}).values())
        return (0.0 if slides and len(deck["stages"]) > 1 else float("nan")), "the last row is that of the stage before"
    if "nothing can crack" not in reason:
        return None
    changing = sorted({law_type(entry) for entry in deck.get("interfaces", {}).values()} - {"bonded", "elastic"})
    error = float("nan") if changing else abs(curve["load_factor"].iloc[-1] - 1)
    return error, f"there is {', '.join(changing)}" if changing else "load factor"


def reason_is_true(curve, summary, deck):
    name = "last row is what the reason says"
    status, reason = summary.get("status", ""), summary.get("reason", "")
    if status != "goal_reached":
        said = bool(reason) and bool(status)
        return Finding(name, 0.0 if said else float("nan"), GOAL, f"{status or 'no status'}: {reason or 'no reason'}")
    for kind in (of_gauge, of_load, of_factor, of_steps, of_full_load):
        found = kind(reason, curve, deck)
        if found is not None:
            return Finding(name, float(found[0]), GOAL, f"step {len(curve) - 1}: {found[1]}")
    return Finding(name, float("nan"), GOAL, f"not known as a goal: {reason or 'no reason'}")


def law_type(entry):
    return entry["law"] if isinstance(entry["law"], str) else entry["law"]["type"]


def all_checks(run):
    curve, log, summary = run.curve, run.log, run.summary
    out = [finite(curve), energies_never_fall(curve), balance(curve, log, run.deck), summary_agrees(run)]
    if summary:
        return [*out, reason_is_true(curve, summary, run.deck)]
    return [*out, not_made("last row is what the reason says", "there is no summary: the run is not finished")]
