"""Every shape of block, law, fracture energy, treatment and number of blocks on one beam, no setting touched."""

import decks
import report
from runs import Case

FRACTURE_ENERGIES = (1000, 100, 20, 5, 2)  # N/m
TREATMENTS = {"consistent": decks.CONSISTENT, "penalty": decks.PENALTY}
COUNTS = (500, 2000)


def case(shape, law, energy, treatment, blocks):
    labels = {"shape": shape, "law": law, "fracture_energy": energy, "treatment": treatment, "about": blocks}
    name = "-".join(["matrix", shape, law, f"Gf{energy:g}", treatment, str(blocks)])
    deck = decks.beam(decks.subdivision(shape, blocks), decks.softening(law, energy), TREATMENTS[treatment])
    return Case(name, deck, labels)


def cases(laws=decks.LAWS, counts=COUNTS, energies=FRACTURE_ENERGIES):
    return [case(shape, law, energy, treatment, blocks) for law in laws for blocks in counts
            for shape in decks.SHAPES for energy in energies for treatment in TREATMENTS]


def cell(outcome):
    """Steps / iterations / rescues of a run that reached its end, else the verdict."""
    if not outcome.reached:
        return outcome.verdict
    s = outcome.summary
    return f"{s['steps']} / {outcome.iterations} / {s['rescues']}"


def table(outcomes):
    """A row per shape, law, treatment and number of blocks, a column per fracture energy."""
    names = ("law", "shape", "treatment")
    rows, energies = {}, []
    for o in outcomes:
        key = (*(o.case.labels[name] for name in names), o.case.labels["about"])
        rows.setdefault(key, {"blocks": o.summary.get("blocks")})[o.case.labels["fracture_energy"]] = cell(o)
        if o.case.labels["fracture_energy"] not in energies:
            energies.append(o.case.labels["fracture_energy"])
    header = [*names, "blocks", *(f"Gf = {energy} N/m" for energy in energies)]
    return report.markdown(header, [[*key[:3], found["blocks"] or f"about {key[3]}",
                                     *(found.get(energy) for energy in energies)]
                                    for key, found in sorted(rows.items())])


def draw(outcomes):
    """Load against crack mouth opening of the finest blocks: rows are laws, columns shapes."""
    finest = max(o.case.labels["about"] for o in outcomes)
    shown = [o for o in outcomes if o.case.labels["about"] == finest and o.curve]
    laws = [law for law in decks.LAWS if any(o.case.labels["law"] == law for o in shown)]
    drawing, axes = report.figure(len(laws), len(decks.SHAPES))
    for o in shown:
        at = o.case.labels
        axis = axes[laws.index(at["law"])][decks.SHAPES.index(at["shape"])]
        energies = sorted({other.case.labels["fracture_energy"] for other in shown}, reverse=True)
        consistent = at["treatment"] == "consistent"
        axis.plot(o.curve["deflection"], [load / 1e3 for load in o.curve["load"]],
                  color=f"C{energies.index(at['fracture_energy'])}", linestyle="-" if consistent else "--",
                  label=f"Gf = {at['fracture_energy']:g} N/m" if consistent else None)
    for i, law in enumerate(laws):
        for j, shape in enumerate(decks.SHAPES):
            axes[i][j].set(title=f"{shape}, {law}", xlabel="deflection [mm]", ylabel="load [kN]", xlim=(0, 0.25))
    axes[0][0].legend(title="dashed: penalty")
    return drawing


def largest(outcomes, value):
    values = [value(o) for o in outcomes if o.reached and value(o) is not None]
    return max(values) if values else None


def sentence(outcomes):
    reached = [o for o in outcomes if o.reached]
    rescued = sum(o.summary["rescues"] > 0 for o in reached)
    balance = largest(outcomes, lambda o: o.summary["energy_balance_error"])
    residual = largest(outcomes, lambda o: o.largest_residual)
    known = "" if residual is None else f", largest residual of an accepted step {residual:.2g} of its tolerance"
    return (f"{report.count(outcomes)}. {rescued} needed rescues. Largest error of the energy balance "
            f"{report.text(balance)}, largest unbalanced load of an accepted step "
            f"{report.text(largest(outcomes, lambda o: o.unbalanced))} of the peak{known}.")


def section(runner, quick=False):
    """Laws that the program does not have are left out, and the sentence says so."""
    laws = [law for law in decks.LAWS if runner.knows("law", f"{law}_softening")]
    missing = [law for law in decks.LAWS if law not in laws]
    wanted = cases(["linear"], [150], [100, 5]) if quick else cases(laws)
    outcomes = runner.run(wanted)
    said = sentence(outcomes) + (f" The program has no law for: {', '.join(missing)}." if missing else "")
    refusals = [f"* {o.case.name}: {o.refusal}" for o in outcomes if o.refused]
    text = "Steps / iterations / rescues; nothing is set but what the row and the column say.\n\n" + table(outcomes)
    return report.Section("matrix", [o.row() for o in outcomes], "\n".join([text, *refusals]), said,
                          report.failures(outcomes), lambda: draw(outcomes))
