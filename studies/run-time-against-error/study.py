"""Work-precision diagrams: relative error over the time of whole processes, for each treatment, block type and size.

    study.py --program DDA [--quick] [--repeats N] [--only PROBLEM ...] [--report] [--output FOLDER]

Writes results/*.csv and from them results/*.svg and the marked region of README.md into FOLDER: this folder, or with
--quick runs/run-time-against-error. Runs are sequential, with one thread; those of less than a second are repeated,
and their medians are what is kept.
"""

import sys
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import double_cantilever  # noqa: E402
import elastic_cantilever  # noqa: E402
import figures  # noqa: E402
import fronts  # noqa: E402
import measure  # noqa: E402
import notched_beam  # noqa: E402
import report  # noqa: E402
import softening_bar  # noqa: E402
import tables  # noqa: E402
from ddapath import study  # noqa: E402

PROBLEMS = (elastic_cantilever, softening_bar, double_cantilever, notched_beam)
SECOND_ORDER = "second_order"  # consistent joints between blocks of second order
TREATMENTS = ("consistent", SECOND_ORDER, "penalty", "augmented_lagrangian", "lagrange")
FACTORS = (1, 5, 10, 20, 30, 50, 100, 1000, 1e4)  # of the penalty stiffness
# Parameters tried beside a treatment's defaults; the softening bar shows that the consistent joint needs none.
PARAMETERS = {("penalty", None): ("factor", FACTORS), ("consistent", softening_bar.NAME): ("alpha", (0.6, 2, 10))}
# Relative errors at which treatments are compared.
TARGETS = {elastic_cantilever.NAME: 0.01, softening_bar.NAME: 1e-4, double_cantilever.NAME: 0.01,
           notched_beam.NAME: 0.01}


@dataclass(frozen=True)
class Plan:
    """What is run: of each problem the first `sizes` sizes."""

    problems: tuple
    sizes: int = 100
    factors: tuple = FACTORS
    repeats: int = 3
    treatments: tuple = TREATMENTS


QUICK = Plan((elastic_cantilever, softening_bar, notched_beam), sizes=2, factors=(10, 100), repeats=1,
             treatments=("consistent", SECOND_ORDER, "penalty"))


def known_treatments(wanted):
    known = {line.split()[0] for line in study.told("explain", "treatment").splitlines()[1:] if line.strip()}
    known.add(SECOND_ORDER)
    for name in wanted:
        if name not in known:
            print(f"skipped: this program does not know the treatment {name}", file=sys.stderr)
    return [name for name in wanted if name in known]


def variants(treatment, problem, plan):
    """(label, deck value) of a treatment with each of its parameters."""
    name, values = PARAMETERS.get((treatment, problem.NAME)) or PARAMETERS.get((treatment, None), ("", ()))
    if treatment == "penalty":
        values = plan.factors
    if not values:
        return [("", {"type": treatment})]
    return [(f"{value:g}", {"type": treatment, name: value}) for value in values]


def sizes_of(problem, shape, treatment, most=100):
    """The first sizes of a block type, from coarse to fine; blocks of second order have sizes of their own."""
    sizes = getattr(problem, "SECOND_ORDER_SIZES", {}) if treatment == SECOND_ORDER else problem.SIZES
    return sizes.get(shape, ())[:most]


def deck_of(problem, scene, treatment):
    if treatment["type"] == SECOND_ORDER:
        return problem.deck(scene, {"type": "consistent"}) | {"kinematics": "second_order"}
    return problem.deck(scene, treatment)


class Runner:
    """Runs decks in one folder and says how far it is."""

    def __init__(self, folder, repeats):
        self.folder, self.repeats = folder, repeats

    def run(self, problem, scene, treatment):
        return measure.measure(deck_of(problem, scene, treatment), problem.error, self.repeats, self.folder)

    def sweep(self, problem, treatments, plan):
        """(block type, treatment, parameter) → its runs from coarse to fine. All that have the same blocks run one
        after another, so that what else the machine does disturbs them alike."""
        runs = {}
        for shape in problem.SIZES:
            own = {treatment: sizes_of(problem, shape, treatment, plan.sizes) for treatment in treatments}
            is_of_blocks = problem.SIZES[shape][0] > problem.SIZES[shape][-1]  # else their number
            for size in sorted({size for sizes in own.values() for size in sizes}, reverse=is_of_blocks):
                print(f"{problem.NAME}: {shape} {size}", file=sys.stderr)
                scene = problem.SCENES[shape](size)
                for treatment in (t for t in treatments if size in own[t]):
                    for label, value in variants(treatment, problem, plan):
                        key = (shape, treatment, label)
                        done = runs.setdefault(key, [])
                        hopeless = len(done) > 1 and all(run.note for run in done[-2:])
                        done.append(measure.not_tried() if hopeless else self.run(problem, scene, value))
        return runs


def best_keys(runs, target):
    """Of each block type and treatment the parameter with the best line."""
    groups = {}
    for key, line in report.lines_of(runs).items():
        groups.setdefault(key[:2], {})[key] = line
    return [fronts.best(group, target) for group in groups.values()]


def arguments():
    parser = study.parser(__doc__)
    parser.add_argument("--repeats", type=int, default=3, help="runs of which the median is kept (default 3)")
    parser.add_argument("--only", action="append", choices=[p.NAME for p in PROBLEMS],
                        help="run this problem again and keep the runs of the others; repeatable")
    parser.add_argument("--treatment", action="append", choices=TREATMENTS,
                        help="run this treatment again and keep the runs of the others; repeatable")
    parser.add_argument("--report", action="store_true", help="run nothing; figures and README from results/*.csv")
    return study.arguments(parser, HERE)


def plan_of(asked):
    plan = QUICK if asked.quick else Plan(PROBLEMS, repeats=asked.repeats)
    if asked.only:
        plan = replace(plan, problems=tuple(p for p in PROBLEMS if p.NAME in asked.only))
    if asked.treatment:
        plan = replace(plan, treatments=tuple(asked.treatment))
    return plan


def run_all(plan, results):
    treatments = known_treatments(plan.treatments)
    with tempfile.TemporaryDirectory() as folder:
        for problem in plan.problems:
            file = results / f"{problem.NAME}.csv"
            kept = tables.read_runs(file) if len(treatments) < len(TREATMENTS) and file.exists() else {}
            runs = kept | Runner(folder, plan.repeats).sweep(problem, treatments, plan)
            tables.write_runs(file, lambda shape, treatment: sizes_of(problem, shape, treatment), runs)


def write_report(output):
    """Figures, comparison and the region of the README from the runs that are there."""
    found = {}
    for problem in PROBLEMS:
        file = output / "results" / f"{problem.NAME}.csv"
        if not file.exists():
            continue
        runs, target = tables.read_runs(file), TARGETS[problem.NAME]
        chosen = best_keys(runs, target)
        figures.draw(problem, report.lines_of(runs), chosen, target, file.with_suffix(".svg"))
        found[problem] = (runs, chosen, target)
    study.write_rows(output / "results" / "comparison.csv", report.comparisons(found), digits=4)
    study.write_region(output / "README.md", report.text(found))


def main():
    asked = arguments()
    if not asked.report:
        run_all(plan_of(asked), asked.output / "results")
    write_report(asked.output)


if __name__ == "__main__":
    main()
