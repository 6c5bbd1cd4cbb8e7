"""Checks of runs that follow several stages: what acted before stays as it was when its stage ended."""
import numpy as np

from .curve_checks import followed_stages
from .finding import worst_of

HELD = 1e-9  # of the load factor


def expected(curve, stages, row):
    """Load factor of every followed stage at a row of curve.csv: of those before where their last rows stand, then its own, then 0."""
    now = int(curve["stage"][row])
    rows = [np.flatnonzero(curve["stage"][:row + 1] == number) for number in stages]
    return np.array([curve["load_factor"][found[-1]] if number <= now and len(found) else 0.0 for number, found in zip(stages, rows)])


def mismatches(found, wanted, what):
    return [(abs(a - b) / max(abs(b), 1e-12) if a != b else 0.0, what) for a, b in zip(found, wanted)]


def all_checks(steps, run):
    """None where but one stage is followed."""
    name, stages, curve = "loads of earlier stages are held", followed_stages(run.deck), run.curve
    if len(stages) < 2:
        return []
    if "stage" not in curve or any(step.model.stages != stages for step in steps):
        return [worst_of(name, [(float("nan"), "the run knows nothing of its stages")], HELD)]
    falls = np.diff(curve["stage"].to_numpy())
    found = [(float("nan") if (falls < 0).any() else 0.0, "curve.csv")]
    for step in steps:
        if step.number < len(curve):
            found += mismatches(step.load_factors, expected(curve, stages, step.number), f"step {step.number}")
    if not run.summary:
        return [worst_of(name, found, HELD)]
    listed = run.summary.get("stages", [])
    for entry in listed[:-1]:
        found += mismatches([entry["load_factor"]], [curve["load_factor"][entry["end"]]], f"stage {entry['number']}")
    numbers = [entry["number"] for entry in listed]
    if numbers != stages[:len(numbers)] or not numbers:
        found.append((float("nan"), "summary.json"))
    return [worst_of(name, found, HELD)]
