"""Brittle laws, with blocks up to the largest that the law admits, and what the random blocks make of the peak."""

import statistics

import decks
import report
from runs import Case

ENERGIES = (1000, 300, 100, 30, 10, 5, 3, 2, 1)  # N/m
SIZES = (2000, 1000, 500, 250, 125, 60, 30, 15)  # blocks
MOST_BRITTLE = (5, 1, 0.2)  # N/m; with the last even small blocks are refused
SEEDS = range(1, 21)


def cases(quick):
    """The fracture energy at 500 blocks; then ever larger blocks at the smallest energies."""
    pairs = [(500, energy) for energy in ENERGIES]
    pairs += [(blocks, energy) for energy in MOST_BRITTLE for blocks in SIZES if (blocks, energy) not in pairs]
    if quick:
        pairs = [(150, 5), (30, 1)]
    return [Case(f"brittle-{shape}-{blocks}-Gf{energy:g}",
                 decks.beam(decks.subdivision(shape, blocks), decks.softening("linear", energy)),
                 {"shape": shape, "about": blocks, "fracture_energy": energy})
            for shape in decks.SHAPES for blocks, energy in pairs]


def draw(outcomes):
    """Peak against fracture energy at one size; the outcome over size and energy."""
    drawing, axes = report.figure(1, 1 + len(decks.SHAPES))
    for shape in decks.SHAPES:
        mine = [o for o in outcomes if o.case.labels["shape"] == shape]
        line = sorted((o.case.labels["fracture_energy"], o.peak / 1e3) for o in mine
                      if o.case.labels["about"] == 500 and o.reached)
        axes[0][0].plot([energy for energy, _ in line], [peak for _, peak in line], ".-", label=shape)
        draw_limit(axes[0][1 + decks.SHAPES.index(shape)], mine, shape)
    report.logarithmic(axes[0][0], "x")
    axes[0][0].set(xlabel="Gf [N/m]", ylabel="peak [kN], about 500 blocks")
    axes[0][0].legend()
    return drawing


def draw_limit(axis, outcomes, shape):
    reached, refused = [o for o in outcomes if o.reached], [o for o in outcomes if o.refused]
    failed = [o for o in outcomes if not o.reached and not o.refused]
    for verdict, mark, colour, chosen in (("reached", "o", "C2", reached), ("refused", "x", "C1", refused),
                                          ("failed", "s", "C3", failed)):
        axis.plot([o.case.labels["fracture_energy"] for o in chosen], [o.case.labels["about"] for o in chosen],
                  mark, color=colour, label=verdict)
    report.logarithmic(axis, "xy")
    axis.set(title=shape, xlabel="Gf [N/m]", ylabel="blocks asked for")
    axis.legend()


def brittle(runner, quick=False):
    outcomes = runner.run(cases(quick))
    refused = [o for o in outcomes if o.refused]
    raised = sum(bool(o.reached and o.notices()) for o in outcomes)
    said = (f"{report.count(outcomes)}; in {raised} of those that reached it the program had raised the stiffness of "
            f"sides for their law. Errors of the energy balance "
            f"{report.span([o.summary['energy_balance_error'] for o in outcomes if o.reached])}.")
    table = report.table(outcomes, report.label("shape"), report.label("about"), report.label("fracture_energy"),
                         report.VERDICT, report.PEAK, *report.EFFORT, *report.QUALITY,
                         ("notice", lambda o: o.notices() or None))
    text = "\n".join([table, "", *(f"* {o.case.name}: {o.refusal}" for o in refused)])
    draws = None if quick else lambda: draw(outcomes)
    return report.Section("brittle", [o.row() for o in outcomes], text, said, report.failures(outcomes), draws)


def draw_seeds(outcomes):
    drawing, ((axis,),) = report.figure(1, 1, 4.2, 3)
    for o in outcomes:
        axis.plot(o.curve.get("deflection", []), [load / 1e3 for load in o.curve.get("load", [])], alpha=0.6)
    axis.set(xlabel="deflection [mm]", ylabel="load [kN]")
    return drawing


def seeds(runner, quick=False):
    blocks, chosen = (150, (1, 2, 3)) if quick else (500, SEEDS)
    cuts = {seed: decks.subdivision("voronoi", blocks, seed) for seed in chosen}
    outcomes = runner.run([Case(f"seeds-Gf{energy}-{seed}", decks.beam(cuts[seed], decks.softening("linear", energy)),
                                {"fracture_energy": energy, "seed": seed}) for energy in (100, 5) for seed in chosen])
    said, rows = [report.count(outcomes) + "."], []
    for energy in (100, 5):
        mine = [o for o in outcomes if o.case.labels["fracture_energy"] == energy]
        peaks = [o.peak for o in mine if o.reached]
        mean = statistics.mean(peaks) if peaks else None
        if len(peaks) > 1:
            said.append(f"Gf = {energy} N/m: mean peak {mean:.0f} N, standard deviation "
                        f"{100 * statistics.stdev(peaks) / mean:.1f} %.")
        rows += [o.row() | {"peak_error": o.peak / mean - 1 if o.peak and mean else None} for o in mine]
    error = {row["name"]: row["peak_error"] and f"{100 * row['peak_error']:+.1f} %" for row in rows}
    table = report.table(outcomes, report.label("fracture_energy"), report.label("seed"), report.VERDICT, report.PEAK,
                         ("against the mean", lambda o: error[o.case.name]), *report.EFFORT,
                         *report.QUALITY)
    return report.Section("seeds", rows, table, " ".join(said), report.failures(outcomes), lambda: draw_seeds(outcomes))
