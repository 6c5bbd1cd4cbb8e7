"""Checks of a motion: its energy book, that nothing is inside of anything else, and that rest is rest.

Integrators that hold bodies apart by penalties alone promise no such thing: how deep bodies overlap, and what impact gives back,
is measured and told, beside a bound that refuses nothing.
"""
import math

import numpy as np

from .finding import Finding, worst_of

ROUNDING = 1e-9  # of the largest energy
SOLVING = 1e-5   # of the largest energy: what steps may have been solved inexactly by
GIVEN_BACK = 1e-2  # of the largest energy: what integration may add where bodies turn in free flight
REST = 1e-6      # of the largest kinetic energy
BOOKED = ("kinetic_energy", "stored_energy", "friction", "fracture", "viscous_damping", "impact", "numerical_damping", "energy_error")
SPENT = ("friction", "fracture", "viscous_damping")


def scale_of(curve):
    """The largest energy there has been [FL]."""
    return max(np.abs(curve[["external_work", *BOOKED]].to_numpy()).max(), 1e-300)


def finite(curve):
    bad = ~np.isfinite(curve.select_dtypes("number").to_numpy())
    return Finding("motion: every number is finite", float(bad.sum()), 0.0, "everywhere")


def books(curve):
    """What the loads have done is kinetic, stored, spent or damped, from every row to the next."""
    scale = scale_of(curve)
    miss = np.abs(np.diff(curve["external_work"]) - np.diff(curve[list(BOOKED)], axis=0).sum(axis=1)) / scale
    at = int(np.argmax(miss)) + 2 if len(miss) else 0
    return [worst_of("motion: energies add up", [(miss.max(initial=0), f"step {at}")], ROUNDING),
            worst_of("motion: steps are solved", [(np.abs(curve["energy_error"]).max() / scale, "energy_error")], SOLVING)]


def spent_never_falls(curve, names=SPENT):
    scale = scale_of(curve)
    found = [(-np.diff(curve[name]).min(initial=0) / scale, name) for name in names]
    return worst_of("motion: what is spent never falls", found, ROUNDING)


def lost(curve):
    """What impacts and integration have taken [FL]."""
    return curve["impact"] + curve["numerical_damping"]


def stored_at_first(curve, is_of_path):
    """What was stored before the first step: of a path, which hands nothing over that moves, all that the first row has beyond
    the work of the loads [FL]."""
    return curve[list(BOOKED)].iloc[0].sum() - curve["external_work"].iloc[0] if is_of_path else 0.0


def told_half_a_step_early(curve, is_of_path):
    """What of the last change of the stored energy impact and damping may have been told too little, ± [FL].

    Work and kinetic energy are those of the middle of a step, most of what is stored is that of its end: half a step ahead. How
    much of it that is no file tells; it is none of it to all of it, but for what impacts have taken.
    """
    stored = curve["stored_energy"] - curve.get("impact_energy", 0.0)
    return np.diff(stored, prepend=stored_at_first(curve, is_of_path)) / 2


def given_back(curve, is_of_path, swings):
    """What impact and damping have given back from the row before, more than half a step of stored energy is [FL].

    Where an integrator `swings`, it takes and gives the same again and again while nothing meets: such rows give back what is
    missing in the end, of the most that has been taken since something met.
    """
    taken, early = (np.concatenate([[0.0], values]) for values in (lost(curve), told_half_a_step_early(curve, is_of_path)))
    low, high = taken + early.clip(max=0), taken + early.clip(min=0)
    falls = (low[:-1] - high[1:]).clip(min=0)
    if not swings:
        return falls
    closed = np.concatenate([[False], curve["meetings"] > 0])
    meets = closed[:-1] | closed[1:]
    most, missing = low[0], 0.0
    for row in range(len(curve)):
        if meets[row]:
            most, missing = low[row + 1], 0.0
        else:
            deepest = max(missing, most - high[row + 1])
            falls[row] = deepest - missing
            most, missing = max(most, low[row + 1]), deepest
    return falls


def nothing_is_given_back(curve, is_of_path, bound=GIVEN_BACK, swings=False):
    """Impact and damping take energy; where they fall, integration has made some, and all such falls together are bounded."""
    falls = given_back(curve, is_of_path, swings)
    at = int(np.argmax(falls)) + 1 if len(falls) else 0
    return worst_of("motion: impact and damping give nothing back", [(falls.sum() / scale_of(curve), f"mostly step {at}")], bound)


def rest(curve, summary):
    """The last row is what the summary says of it."""
    if not summary.get("is_at_rest"):
        return []
    left = curve["kinetic_energy"].iloc[-1] / max(curve["kinetic_energy"].max(), 1e-300)
    return [Finding("motion: at rest", left, REST, "last row")]


def outlines(fields):
    """The corners of every block where they are now, n × 2 each."""
    vertices = fields.vertices
    now = np.column_stack([vertices["x"] + vertices["displacement_x"], vertices["y"] + vertices["displacement_y"]])
    return [now[rows] for rows in vertices.groupby("block").indices.values()]


def stand_back(polygon):
    """1 + 1/sin(β/2) of every corner, β its inner angle: times s, how deep it may be where cores only touch."""
    before, after = np.roll(polygon, 1, axis=0) - polygon, np.roll(polygon, -1, axis=0) - polygon
    cross = after[:, 0] * before[:, 1] - after[:, 1] * before[:, 0]
    angle = np.arctan2(cross, (before * after).sum(axis=1)) % (2 * np.pi)
    return 1 + 1 / np.sin(angle / 2)


def depths_inside(points, polygon):
    """How deep each point is inside of a polygon; 0 outside."""
    start, end = polygon, np.roll(polygon, -1, axis=0)
    edge, to = end - start, points[:, None, :] - start[None]
    share = np.clip((to * edge).sum(-1) / (edge**2).sum(-1), 0, 1)
    distance = np.linalg.norm(to - share[..., None] * edge, axis=-1).min(axis=1)
    above = (start[None, :, 1] > points[:, None, 1]) != (end[None, :, 1] > points[:, None, 1])
    rise = np.where(edge[:, 1] == 0, 1, edge[:, 1])
    crossing = start[:, 0] + (points[:, None, 1] - start[:, 1]) / rise * edge[:, 0]
    return distance * ((above & (points[:, None, 0] < crossing)).sum(axis=1) % 2 == 1)


def no_margin(polygon):
    return np.ones(len(polygon))


def depths(polygons, margin=stand_back):
    """How deep the deepest corner of each block is in another, over a margin, by default what its core stands back: {(i, j): depth}."""
    low, high = (np.array([f(p, axis=0) for p in polygons]) for f in (np.min, np.max))
    out = {}
    for i, polygon in enumerate(polygons):
        near = np.flatnonzero(((low <= high[i]) & (high >= low[i])).all(axis=1))
        for j in near[near != i]:
            out[i, int(j)] = float((depths_inside(polygon, polygons[j]) / margin(polygon)).max())
    return out


def deepest(found):
    """The deepest of them and its two blocks."""
    return max(((depth, f"block {i} in block {j}") for (i, j), depth in found.items()), default=(0.0, "everywhere"))


def nothing_crosses(motion, offset, is_of_path):
    """No corner is deeper in another block than the margins s by which cores are smaller let it be. Joints of a path that have
    turned about points inside their sides overlap at their corners: these go no deeper than the margin more."""
    found, left = [], {}
    for step in motion.steps:
        here = {pair: depth / offset for pair, depth in depths(outlines(motion.fields(step))).items()}
        if step == motion.steps[0] and is_of_path:
            left = {tuple(sorted(pair)): depth for pair, depth in sorted(here.items(), key=lambda item: item[1]) if depth > 1}
        depth, place = deepest({pair: depth - left.get(tuple(sorted(pair)), 0) for pair, depth in here.items()})
        found.append((depth, f"step {step}, {place}"))
    return worst_of("motion: nothing crosses", found, 1 + ROUNDING)


def overlaps(motion):
    """How deep the deepest corner is in another block, in sizes of the smallest block."""
    size = np.sqrt(motion.fields(motion.steps[0]).mesh.areas.min())
    found = [(depth / size, f"step {step}, {place}")
             for step in motion.steps for depth, place in [deepest(depths(outlines(motion.fields(step)), no_margin))]]
    return worst_of("motion: overlap by penalties, not bounded", found, math.inf)


def integrator_of(run):
    integrator = run.deck["motion"]["integrator"]
    return integrator["type"] if isinstance(integrator, dict) else integrator


def offset_of(run):
    """s of the deck, a share of the size of the smallest block before any was cut [L]."""
    whole = run if run.deck.get("stages") else run.motion
    return run.deck["motion"]["contact"]["offset"] * np.sqrt(whole.fields(whole.steps[0]).mesh.areas.min())


def all_checks(run):
    motion, summary, is_of_path = run.motion, run.summary.get("motion", {}), bool(run.deck.get("stages"))
    curve, integrator = motion.curve, integrator_of(run)
    has_penalties_alone = integrator == "classic"
    out = [finite(curve)] if len(curve) else []
    if len(curve):
        bound = math.inf if has_penalties_alone else GIVEN_BACK
        out += [*books(curve), spent_never_falls(curve, SPENT if has_penalties_alone else (*SPENT, "impact")),
                nothing_is_given_back(curve, is_of_path, bound, swings=integrator == "trapezoidal"), *rest(curve, summary)]
    return [*out, overlaps(motion) if has_penalties_alone else nothing_crosses(motion, offset_of(run), is_of_path)]
