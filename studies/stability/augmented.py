"""The augmented Lagrangian: updates of its multipliers against their closed form, the beam over six decades of p_c."""

import math

import decks
import report
from runs import Case

RATIOS = (0.1, 1, 10, 100)  # p_c in units of the bar's own stiffness
FACTORS = (1e-2, 1e-1, 1.0, 10.0, 1e2, 1e3, 1e4)  # p_c in units of E/(centroid distance)
GAP = 1e-8  # what is left of the gap without a joint
BLOCKS, ENERGY = 150, 100
KIND = "augmented_lagrangian"


def bar(ratio):
    """Two unit cubes of E = 1, ν = 0, pulled apart by a given displacement.

    The gap U without a joint closes by k/(k + p_c) in each solve, k = ½ E/h that of both cubes in series. The tolerance
    of the program is relative to the shortening t h/E = U/2 of one cube.
    """
    def cube(name, y):
        return {"name": name, "material": "unit", "vertices": [[0, y], [1, y], [1, y + 1], [0, y + 1]]}

    law = {"type": "linear_softening", "tensile_strength": 1, "fracture_energy": 1000}
    pulled = [{"type": "prescribed_displacement", "name": name, "at": [x, 2], "direction": [0, 1], "displacement": 0.05}
              for name, x in (("left", 0), ("right", 1))]
    return {
        "title": "Two blocks, one joint", "units": {"length": "mm", "force": "N"},
        "scene": {"regions": [cube("lower", 0), cube("upper", 1)], "curves": {"joint": [[0, 1], [1, 1]]},
                  "boundaries": {"foot": [[0, 0], [1, 0]]}},
        "thickness": 1, "plane": "stress", "materials": {"unit": decks.elastic(1, 0)},
        "interfaces": {"joint": {"law": law, "treatment": {"type": KIND, "factor": ratio / 2}}},
        "supports": {"foot": {"boundary": "foot", "fix": "normal"}, "below": {"at": [0, 0], "fix": "x"},
                     "above": {"at": [0, 2], "fix": "x"}},
        "stages": [{"name": "pull", "loads": pulled}],
        "gauges": {"top": {"type": "displacement", "at": [0.5, 2], "direction": [0, 1]}},
        "path": {"control": "load", "multipliers": {"predicted": False, "tolerance": 2 * GAP},
                 "stop": {"gauges": {"top": 0.01}}},
        "record": {"fields_every": 0},
    }


def expected(ratio):
    """Smallest n with (k/(k + p_c))^(n+1) ≤ GAP."""
    return math.ceil(math.log(GAP) / math.log(1 / (1 + ratio))) - 1


def updates(outcome):
    """Updates of the multipliers."""
    return sum(step["multiplier_iterations"] for step in outcome.steps) if outcome.steps else None


def bars(runner):
    """Rows of the bar, its table, and complaints where the count is more than one off."""
    outcomes = runner.run([Case(f"augmented-bar-{ratio:g}", bar(ratio), {"p_c/k": ratio}, None) for ratio in RATIOS])
    cells = [[o.case.labels["p_c/k"], expected(o.case.labels["p_c/k"]), updates(o)] for o in outcomes]
    complaints = [f"augmented-bar-{ratio:g}: {found} updates instead of {wanted}" for ratio, wanted, found in cells
                  if found is None or abs(found - wanted) > 1]
    return cells, report.markdown(["p_c/k", "updates, closed form", "updates"], cells), complaints


def beams(runner, quick):
    shape, factors = "triangles", (10.0,) if quick else FACTORS
    cut, law = decks.subdivision(shape, BLOCKS), decks.softening("linear", ENERGY)
    stiff = Case("augmented-penalty", decks.beam(cut, law, {"type": "penalty", "factor": 1e4}),
                 {"shape": shape, "treatment": "penalty", "factor": 1e4})
    return runner.run([stiff] + [Case(f"augmented-{factor:g}", decks.beam(cut, law, {"type": KIND, "factor": factor}),
                                      {"shape": shape, "treatment": KIND, "factor": factor}) for factor in factors])


def section(runner, quick=False):
    if not runner.knows("treatment", KIND):
        print(f"augmented: the program has no treatment {KIND}")
        return None
    cells, closed_form, complaints = bars(runner)
    penalty, *outcomes = beams(runner, quick)
    reached = [o for o in outcomes if o.reached]
    said = (f"Updates of the multipliers for p_c/k = {', '.join(f'{ratio:g}' for ratio in RATIOS)}: "
            f"{', '.join(str(found) for *_, found in cells)}; closed form "
            f"{', '.join(str(wanted) for _, wanted, _ in cells)}. The beam: {report.count(outcomes)}.")
    if reached and penalty.peak:
        said += (f" Iterations {report.span([o.iterations for o in reached])}; largest difference of "
                 f"the peak from the stiff penalty's {100 * max(abs(o.peak / penalty.peak - 1) for o in reached):.2g} %.")
    table = report.table([penalty, *outcomes], report.label("treatment"), report.label("factor"), report.VERDICT,
                         report.PEAK, ("against penalty", lambda o: report.percent(o.peak, penalty.peak)),
                         *report.EFFORT, *report.QUALITY)
    complaints += report.failures(outcomes)
    return report.Section("augmented", [o.row() for o in [penalty, *outcomes]], f"{closed_form}\n\n{table}", said,
                          complaints)
