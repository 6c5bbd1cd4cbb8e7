"""Stiffness of the joints over many decades: how much of the result is the setting's."""

import decks
import report
from runs import Case

ALPHAS = (0.51, 0.55, 0.6, 0.8, 1, 2, 4, 10, 100, 1e3, 1e4, 1e5, 1e6)
FACTORS = tuple(10.0**i for i in range(-1, 9))
BLOCKS, ENERGY = 500, 100


def sweep(name, key, values, treatment, quick):
    """Cases of one number of a treatment; the default of `consistent` on the same blocks is the first of each shape."""
    blocks = 150 if quick else BLOCKS
    law = decks.softening("linear", ENERGY)
    shapes = ("voronoi",) if quick else decks.SHAPES
    cases = []
    for shape in shapes:
        cut = decks.subdivision(shape, blocks)
        cases.append(Case(f"{name}-{shape}-default", decks.beam(cut, law), {"shape": shape, key: "default"}))
        for value in values:
            labels = {"shape": shape, key: value}
            deck = decks.beam(cut, law, {"type": treatment, key: value})
            cases.append(Case(f"{name}-{shape}-{value:g}", deck, labels))
    return cases


def initial_stiffness(outcome):
    """Load over deflection at the first crack [N/mm]."""
    if not outcome.curve or len(outcome.curve["load"]) < 2:
        return None
    return outcome.curve["load"][1] / outcome.curve["deflection"][1]


def split(outcomes, key):
    """The default outcome of each shape, and the others."""
    default = {o.case.labels["shape"]: o for o in outcomes if o.case.labels[key] == "default"}
    return default, [o for o in outcomes if o.case.labels[key] != "default"]


def deviations(outcomes, key):
    """Of every outcome: difference of the peak and of the initial stiffness from the default on the same blocks."""
    default, others = split(outcomes, key)

    def deviation(outcome, value):
        mine, reference = value(outcome), value(default[outcome.case.labels["shape"]])
        return None if mine is None or reference is None else mine / reference - 1

    return [(o, deviation(o, lambda r: r.peak), deviation(o, initial_stiffness)) for o in others]


def table(found, key):
    by_outcome = {id(o): (peak, stiffness) for o, peak, stiffness in found}

    def signed(index):
        return lambda o: None if by_outcome[id(o)][index] is None else f"{100 * by_outcome[id(o)][index]:+.2f} %"

    return report.table([o for o, *_ in found], report.label("shape"), report.label(key), report.VERDICT,
                        ("peak against default", signed(0)), ("initial stiffness", signed(1)),
                        *report.EFFORT[1:], *report.QUALITY)


def draw(found, key, title):
    """Peak, initial stiffness and iterations against the setting."""
    drawing, (axes,) = report.figure(1, 3)
    for shape in sorted({o.case.labels["shape"] for o, *_ in found}):
        mine = [(o, peak, stiff) for o, peak, stiff in found if o.case.labels["shape"] == shape and o.reached]
        x = [o.case.labels[key] for o, *_ in mine]
        axes[0].plot(x, [100 * peak for _, peak, _ in mine], ".-", label=shape)
        axes[1].plot(x, [100 * stiff for *_, stiff in mine], ".-", label=shape)
        axes[2].plot(x, [o.iterations for o, *_ in mine], ".-", label=shape)
    for axis, label in zip(axes, ("peak against default [%]", "initial stiffness [%]", "iterations of the path")):
        report.logarithmic(axis, "x")
        axis.set(xlabel=title, ylabel=label)
    report.logarithmic(axes[2], "y")
    axes[0].legend()
    return drawing


def finish(name, key, title, outcomes, must_reach):
    """The section of a sweep; must_reach says for which outcomes a failure is a complaint."""
    found = deviations(outcomes, key)
    near = [(abs(peak), o) for o, peak, _ in found if peak is not None and o.reached]
    worst = max(near, key=lambda pair: pair[0], default=(None, None))
    said = report.count(outcomes) + "."
    if worst[1]:
        at = worst[1].case.labels
        said += (f" Largest difference of the peak from the default's on the same blocks: {100 * worst[0]:.1f} % "
                 f"({at['shape']}, {key} = {at[key]:g}); iterations "
                 f"{report.span([o.iterations for _, o in near])} per path.")
    default, others = split(outcomes, key)
    complaints = report.failures([o for o in others if must_reach(o)] + list(default.values()))
    rows = [o.row() | {"peak_deviation": peak, "stiffness_deviation": stiff} for o, peak, stiff in found]
    return report.Section(name, rows, table(found, key), said, complaints, lambda: draw(found, key, title))


def alpha(runner, quick=False):
    values = (0.51, 0.6, 1e6) if quick else ALPHAS
    outcomes = runner.run(sweep("alpha", "alpha", values, "consistent", quick))
    return finish("alpha", "alpha", "α", outcomes, lambda o: True)


def penalty(runner, quick=False):
    values = (1.0, 100.0) if quick else FACTORS
    outcomes = runner.run(sweep("penalty", "factor", values, "penalty", quick))
    return finish("penalty", "factor", "penalty / (E/h)", outcomes, lambda o: True)
