"""One path in four systems of units, and turned, moved, mirrored, renumbered: the same to 1e-8.

Paths are compared where they land on given loads, before and after the peak. Elsewhere the step lengths are free:
they feel what Newton's tolerance leaves over, so that points of equal number lie on one path but not at one place of
it; that distance is recorded beside the other.
"""

import decks
import report
import transform
from runs import Case

TOLERANCE = 1e-8
GAUGES = ("deflection", "cmod")
LANDINGS = (0.15, 0.3, 0.5, 0.7, 0.9)  # loads in units of the peak, before and after it
ENERGIES = (100, 20)  # N/m; both are followed without a rescue, whose jump would depend on where it begins
UNITS = {"m, N": transform.Units("m", "N", 1e-3, 1.0), "mm, kN": transform.Units("mm", "kN", 1.0, 1e-3),
         "µm, N": transform.Units("µm", "N", 1e3, 1.0)}


def given_scene(runner, energy, quick):
    """Random Voronoi blocks as polygons: no two interfaces are equal, so one point is the weakest.

    The joint at the right support is at rest on a spring whose direction is given, so that it can be turned.
    """
    blocks = 150 if quick else 500
    first = decks.beam(decks.subdivision("voronoi", blocks, seed=3), decks.softening("linear", energy))
    first["record"] = {"fields_every": 10}
    meshed = runner.run_one(Case(f"placement-blocks-Gf{energy}", first))
    deck = decks.beam({"type": "given"}, decks.softening("linear", energy))
    deck["scene"]["regions"] = [{"name": f"block{i}", "material": "concrete", "vertices": polygon}
                                for i, polygon in enumerate(transform.outlines(meshed.folder))]
    deck["gauges"]["force"] = {"type": "load", "scale": 1}
    deck["record"]["at"] = {"force": [share * meshed.peak for share in LANDINGS]}
    deck["supports"]["right"] = {"at": deck["supports"]["right"]["at"], "direction": [0, 1]}
    return deck


def compare(name, runner, variants, quick):
    """The section: variants(deck) gives (label, deck, arguments of transform.distance)."""
    rows, outcomes, energies = [], [], ENERGIES[:1] if quick else ENERGIES
    for energy in energies:
        deck = given_scene(runner, energy, quick)
        wanted = [("as given", deck, {}), *variants(deck)]
        found = runner.run([Case(f"{name}-Gf{energy}-{what.replace(', ', '-').replace(' ', '')}", changed,
                                 {"fracture_energy": energy, "scene_is": what}) for what, changed, _ in wanted])
        for outcome, (*_, arguments) in zip(found, wanted):
            rows.append(outcome.row() | distances(found[0], outcome, arguments))
        outcomes += found
    return finish(name, rows, outcomes)


def distances(reference, outcome, arguments):
    """At the landings, with the column that is worst, and from step to step."""
    points = [transform.landings(o, "force") for o in (reference, outcome)]
    far, column = transform.distance(*points, GAUGES, **arguments)
    step_by_step, _ = transform.distance(reference.curve, outcome.curve, GAUGES, **arguments)
    landed = len(points[1].get("load", []))
    return {"landings": landed, "distance": far, "column": column, "step_by_step": step_by_step}


def finish(name, rows, outcomes):
    by_name = {row["name"]: row for row in rows}
    off = [row for row in rows if not row["distance"] <= TOLERANCE]
    said = (f"{report.count(outcomes)}. {len(rows) - len(off)} of {len(rows)} paths are the same at their landings within "
            f"{TOLERANCE:g} of a column's largest value; the largest difference is "
            f"{report.text(max(row['distance'] for row in rows))}. From step to step, where the step lengths enter, it is "
            f"{report.text(max(row['step_by_step'] for row in rows))}.")
    table = report.table(outcomes, report.label("fracture_energy"), report.label("scene_is"), report.VERDICT,
                         ("difference", lambda o: by_name[o.case.name]["distance"]),
                         ("in", lambda o: by_name[o.case.name]["column"]),
                         ("landings", lambda o: by_name[o.case.name]["landings"]),
                         ("step by step", lambda o: by_name[o.case.name]["step_by_step"]), *report.EFFORT, *report.QUALITY)
    complaints = report.failures(outcomes)
    complaints += [f"{row['name']}: differs by {row['distance']:.3g} in {row['column']}" for row in off]
    return report.Section(name, rows, table, said, complaints)


def units(runner, quick=False):
    def variants(deck):
        return [(what, system.convert(deck), {"units": system}) for what, system in UNITS.items()]

    return compare("units", runner, variants, quick)


def placement(runner, quick=False):
    far = 1e3 * 2 * decks.BEAM.half_length
    mirror = transform.Motion(((-1.0, 0.0), (0.0, 1.0)))

    def variants(deck):
        motions = {"turned by 37°": transform.rotation(37), "turned by 90°": transform.rotation(90),
                   "moved by 1000 lengths": transform.Motion(shift=(far, far)), "mirrored": mirror}
        moved = [(what, motion.convert(deck), {"matrix": motion.matrix}) for what, motion in motions.items()]
        return [*moved, ("renumbered", transform.renumbered(deck), {})]

    return compare("placement", runner, variants, quick)
