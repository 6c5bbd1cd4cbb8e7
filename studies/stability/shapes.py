"""Blocks that are slender or of very unlike areas, and materials of very unlike stiffness."""

import math

import numpy

import decks
import report
from runs import Case

ENERGY = 100
ASPECTS = (1, 10, 100, 1000)
AREA_RATIOS = (1e2, 1e4, 1e6)
PAD = 20.0  # half the width of the load [mm]: a point load would punch a slender column out of the beam
MODULUS_RATIOS = (1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6)


def graded(length, smallest, pieces):
    """Points from 0 to length whose distances grow geometrically from the smallest."""
    low, high = 1e-9, 10.0
    for _ in range(200):
        growth = (low + high) / 2
        total = smallest * numpy.sum((1 + growth) ** numpy.arange(pieces))
        low, high = (growth, high) if total < length else (low, growth)
    widths = (1 + growth) ** numpy.arange(pieces)
    points = numpy.concatenate([[0], numpy.cumsum(widths)])
    return points * (length / points[-1])


def mirrored(points):
    return numpy.concatenate([-points[:0:-1], points])


def rectangles(xs, ys):
    return [[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
            for x0, x1 in zip(xs, xs[1:]) for y0, y1 in zip(ys, ys[1:])]


def halved(boxes):
    """Two triangles of each rectangle."""
    return [half for a, b, c, d in boxes for half in ([a, b, c], [a, c, d])]


def columns(smallest):
    """Columns that shrink towards midspan; the load's pad ends between two of them."""
    pieces = 1 if smallest > PAD / 2 else 4 + 2 * round(math.log10(PAD / smallest))
    inner = graded(PAD, smallest, pieces)
    outer = PAD + graded(decks.BEAM.half_length - PAD, 16.0, 6)
    return mirrored(numpy.concatenate([inner, outer[1:]]))


def columns_and_rows(aspect):
    """Six equal rows; columns as narrow at midspan as the aspect ratio says."""
    height = decks.BEAM.depth / 6
    return columns(height / aspect), numpy.linspace(0, decks.BEAM.depth, 7)


def refined_at_tip(ratio):
    """Columns and rows that shrink towards the tip of the notch, the areas by about this ratio."""
    smallest = decks.BEAM.notch / ratio**0.5
    tip, above = decks.BEAM.notch, decks.BEAM.depth - decks.BEAM.notch
    ys = numpy.concatenate([tip - graded(tip, smallest, 5)[::-1], tip + graded(above, smallest, 12)[1:]])
    ys[0] = 0.0
    return columns(smallest), ys


def given(xs, ys, cut, treatment):
    """The beam of rectangles between these columns and rows, or of what `cut` makes of them."""
    polygons = cut(rectangles(xs, ys))
    deck = decks.beam({"type": "given"}, decks.softening("linear", ENERGY), treatment)
    deck["scene"]["regions"] = [{"name": f"block{i}", "material": "concrete",
                                 "vertices": [[float(x), float(y)] for x, y in polygon]}
                                for i, polygon in enumerate(polygons)]
    deck["scene"]["boundaries"] = {"pad": [[-PAD, decks.BEAM.depth], [PAD, decks.BEAM.depth]]}
    pressure = 1 / (2 * PAD * decks.BEAM.thickness)
    deck["stages"][0]["loads"] = [{"type": "edge_traction", "boundary": "pad", "pressure": pressure}]
    aside, above = float(xs[xs > 0][0]) / 3, float(ys[1]) / 10
    deck["gauges"]["cmod"] |= {"from_inside": [-aside, above], "to_inside": [aside, above]}
    return deck


def measures(boxes):
    """Worst aspect ratio and ratio of the areas of rectangles."""
    sides = numpy.array([(b[0] - a[0], c[1] - b[1]) for a, b, c, _ in boxes])
    areas = sides.prod(axis=1)
    return float((sides.max(axis=1) / sides.min(axis=1)).max()), float(areas.max() / areas.min())


def shape_cases(quick):
    grids = [(f"aspect {aspect}", columns_and_rows(aspect)) for aspect in (ASPECTS[::3] if quick else ASPECTS)]
    if not quick:
        grids += [(f"areas {ratio:g}", refined_at_tip(ratio)) for ratio in AREA_RATIOS]
    cases = []
    for name, (xs, ys) in grids:
        boxes = rectangles(xs, ys)
        aspect, ratio = measures(boxes)
        for shape, cut in (("quads", list), ("triangles", halved)):
            for treatment in (decks.CONSISTENT, decks.PENALTY):
                labels = {"blocks_are": shape, "graded": name, "worst_aspect": aspect, "area_ratio": ratio,
                          "treatment": treatment["type"]}
                unique = f"shapes-{shape}-{name.replace(' ', '')}-{treatment['type']}"
                cases.append(Case(unique, given(xs, ys, cut, treatment), labels))
    return cases


def reference_case():
    """One straight crack on fine triangles: what the peak tends to as the blocks shrink."""
    xs = columns(0.8)
    ys = numpy.concatenate([numpy.linspace(0, decks.BEAM.notch, 17), numpy.linspace(decks.BEAM.notch, 100, 81)[1:]])
    deck = given(xs, ys, halved, decks.CONSISTENT)
    deck["scene"]["curves"] = {"ligament": [[0, decks.BEAM.notch], [0, decks.BEAM.depth]]}
    deck["interfaces"] = {"ligament": {"law": decks.softening("linear", ENERGY)}}
    return Case("shapes-reference", deck, {"blocks_are": "triangles", "graded": "straight crack only"})


def shapes(runner, quick=False):
    outcomes = runner.run(shape_cases(quick) + [reference_case()])
    *varied, reference = outcomes
    error = {id(o): None if not o.peak or not reference.peak else o.peak / reference.peak - 1 for o in outcomes}
    consistent = [o for o in varied if o.case.labels["treatment"] == "consistent"]
    said = (f"{report.count(outcomes)}. Against one straight crack on {reference.summary.get('blocks')} triangles "
            f"({report.text(reference.peak)} N) the peaks of the consistent joint are off by "
            f"{report.span([100 * error[id(o)] for o in consistent if error[id(o)] is not None])} %, at worst aspect "
            f"ratios up to {max(o.case.labels['worst_aspect'] for o in varied):.3g} and area ratios up to "
            f"{max(o.case.labels['area_ratio'] for o in varied):.3g}.")
    table = report.table(outcomes, *(report.label(name) for name in
                                     ("blocks_are", "graded", "worst_aspect", "area_ratio", "treatment")),
                         report.VERDICT, report.PEAK, ("error", lambda o: report.percent(o.peak, reference.peak)),
                         *report.EFFORT, *report.QUALITY)
    no_labels = dict.fromkeys(outcomes[0].case.labels)
    rows = [no_labels | o.row() | {"peak_error": error[id(o)]} for o in outcomes]
    return report.Section("shapes", rows, table, said, report.failures(outcomes))


def unlike_deck(ratio, treatment):
    """The ends beyond three tenths of the span are of another modulus and bonded; the middle may crack anywhere."""
    deck = decks.beam(decks.subdivision("voronoi", 500), decks.softening("linear", ENERGY), treatment)
    inner, outer, top = 0.3 * decks.BEAM.span, decks.BEAM.half_length, decks.BEAM.depth
    deck["scene"]["regions"] = [
        {"name": name, "material": material, "vertices": [[x0, 0], [x1, 0], [x1, top], [x0, top]]}
        for name, material, x0, x1 in (("middle", "concrete", -inner, inner), ("left end", "other", -outer, -inner),
                                       ("right end", "other", inner, outer))]
    deck["materials"]["other"] = decks.elastic(ratio * decks.BEAM.young)
    return deck


def unlike(runner, quick=False):
    ratios = (1.0, 1e6) if quick else MODULUS_RATIOS
    outcomes = runner.run([Case(f"unlike-{treatment['type']}-{ratio:g}", unlike_deck(ratio, treatment),
                                {"treatment": treatment["type"], "modulus_ratio": ratio})
                           for treatment in (decks.CONSISTENT, decks.PENALTY) for ratio in ratios])
    equal = {o.case.labels["treatment"]: o.peak for o in outcomes if o.case.labels["modulus_ratio"] == 1}
    changes = [o.peak / equal[o.case.labels["treatment"]] - 1 for o in outcomes
               if o.reached and equal[o.case.labels["treatment"]]]
    said = (f"{report.count(outcomes)}. The beam is statically determinate: its peak hardly feels the ends. It changes "
            f"by {report.span([100 * change for change in changes])} % over "
            f"{report.text(max(ratios) / min(ratios))}:1.")
    table = report.table(outcomes, report.label("treatment"), report.label("modulus_ratio"), report.VERDICT,
                         report.PEAK,
                         ("against equal moduli", lambda o: report.percent(o.peak, equal[o.case.labels["treatment"]])),
                         *report.EFFORT, *report.QUALITY)
    return report.Section("unlike", [o.row() for o in outcomes], table, said, report.failures(outcomes))
