"""The tables and the conclusion of README.md, from the runs alone; nothing in the marked region is typed."""

import math
import os
import platform

import fronts
import notched_beam
import softening_bar

CLAIMED_SHARE = 0.25  # of penalty's time, in which consistent is to reach the same peak load
CLAIMED_SHAPES = ("quads", "voronoi")
FINE_ERROR, MOST_BLOCKS = 0.002, 8000
REFERENCE_TREATMENT, SECOND_ORDER = "consistent", "second_order"
UNKNOWNS = {REFERENCE_TREATMENT: 6, SECOND_ORDER: 12}  # of a block
ORDERS_AT = (0.01, 0.003, 0.001)


def lines_of(runs, time="seconds"):
    """(time, error) of each run; the time is elapsed, or that of the processor."""
    return {key: [(getattr(run, time), run.error) for run in found] for key, found in runs.items()}


def comparisons(found):
    """One dictionary per problem, block type and treatment other than consistent."""
    out = []
    for problem, (runs, chosen, target) in found.items():
        elapsed, processor = lines_of(runs), lines_of(runs, "processor")
        references = {key[0]: key for key in chosen if key[1] == REFERENCE_TREATMENT}
        for key in chosen:
            if key[1] not in (REFERENCE_TREATMENT, SECOND_ORDER):
                keys = (references[key[0]], key)
                row = comparison(problem, elapsed, keys, target)
                out.append(row | {"processor_factor": comparison(problem, processor, keys, target)["factor"]})
    return out


def comparison(problem, lines, keys, target):
    """Times to the same error: the target, or where one of the two never gets there the error that it keeps."""
    ours, other = (lines[key] for key in keys)
    equal = max(target, fronts.smallest(ours), fronts.smallest(other))
    shape, treatment, parameter = keys[1]
    comparable = math.isfinite(equal)
    mine, theirs = (fronts.time_to(line, equal) if comparable else math.nan for line in (ours, other))
    group = {key[2]: line for key, line in lines.items() if key[:2] == (shape, treatment)}
    touch = fronts.first_touch(group, target)
    return {"problem": problem.NAME, "block_type": shape, "treatment": treatment, "parameter": parameter,
            "finest_error": other[-1][1], "compared_at": equal, "consistent_seconds": mine, "seconds": theirs,
            "factor": theirs / mine,
            "touch_seconds": touch[0] if touch else math.inf, "touch_parameter": touch[1] if touch else "",
            "touch_finest_error": group[touch[1]][-1][1] if touch else math.nan,
            "consistent_to_target": fronts.time_to(ours, target)}


def percent(value):
    if not math.isfinite(value):
        return "failed"
    return f"{100 * value:.0f} %" if abs(value) > 0.99 else f"{100 * value:.2g} %"


def seconds(value):
    if math.isnan(value):
        return "–"
    return f"{value:.2f}" if math.isfinite(value) else "never"


def ratio(value):
    return f"{value:.2g}" if math.isfinite(value) else "–"


def runs_table(runs, chosen):
    """Blocks, error and time of the best of each treatment, from coarse to fine."""
    yield "| blocks | treatment | parameter | number of blocks: error, seconds |"
    yield "|---|---|---|---|"
    for key in chosen:
        cells = (f"{run.blocks}: {percent(run.error)}, {run.seconds:.2f}" if not run.note else "failed"
                 for run in runs[key])
        yield f"| {key[0]} | {key[1].replace('_', ' ')} | {key[2] or 'default'} | {'; '.join(cells)} |"


def comparison_table(rows):
    yield ("| blocks | against | best parameter | compared at | consistent [s] | other [s] | factor | "
           "processor time | any parameter [s] |")
    yield "|---|---|---|---|---|---|---|---|---|"
    for row in rows:
        touch = seconds(row["touch_seconds"])
        if row["touch_parameter"]:
            touch += f" ({row['touch_parameter']})"
        yield (f"| {row['block_type']} | {row['treatment'].replace('_', ' ')} | {row['parameter'] or 'default'} | "
               f"{percent(row['compared_at'])} | {seconds(row['consistent_seconds'])} | {seconds(row['seconds'])} | "
               f"{ratio(row['factor'])} | {ratio(row['processor_factor'])} | {touch} |")


def orders_table(runs):
    """Blocks of first and of second order with consistent joints, at equal errors."""
    yield "| blocks | error | first order: unknowns, seconds | second order: unknowns, seconds | unknowns | time |"
    yield "|---|---|---|---|---|---|"
    for shape in dict.fromkeys(key[0] for key in runs if key[1] == SECOND_ORDER):
        found = {order: next(line for key, line in runs.items() if key[:2] == (shape, order)) for order in UNKNOWNS}
        for target in ORDERS_AT:
            unknowns, elapsed = ({order: fronts.time_to([(of(run, order), run.error) for run in line], target)
                                  for order, line in found.items()}
                                 for of in (lambda run, order: UNKNOWNS[order] * run.blocks, lambda run, order: run.seconds))
            cells = (f"{unknowns[order]:.0f}, {seconds(elapsed[order])}" if math.isfinite(elapsed[order]) else "not reached"
                     for order in UNKNOWNS)
            factors = (ratio(of[REFERENCE_TREATMENT] / of[SECOND_ORDER]) for of in (unknowns, elapsed))
            yield f"| {shape} | {percent(target)} | {' | '.join(cells)} | {' | '.join(factors)} |"


def lucky_hit(row):
    """What the last column of the comparison hides: how a parameter that touched the target does on finer blocks."""
    name = row["treatment"].replace("_", " ")
    return (f"* {row['block_type']}: {name} with {row['touch_parameter']} happens to be below the target after "
            f"{seconds(row['touch_seconds'])} s, and is {percent(row['touch_finest_error'])} off on the finest blocks; "
            f"consistent stays below it after {seconds(row['consistent_to_target'])} s.")


def start_of(found):
    """Seconds that a process takes for next to nothing: the fastest of all runs of the softening bar."""
    return min(run.seconds for problem, (runs, _, _) in found.items() if problem.NAME == softening_bar.NAME
               for line in runs.values() for run in line if not run.note)


def share_verdict(rows, start):
    for row in rows:
        if row["problem"] == notched_beam.NAME and row["treatment"] == "penalty" and \
                row["block_type"] in CLAIMED_SHAPES and math.isfinite(row["factor"]):
            held = "yes" if 1 <= CLAIMED_SHARE * row["factor"] else "**no**"
            yield (f"* A quarter of penalty's time or less on {row['block_type']} at {percent(row['compared_at'])}: "
                   f"{held}, {100 / row['factor']:.0f} % ({seconds(row['consistent_seconds'])} s against "
                   f"{seconds(row['seconds'])} s, penalty at its best k = {row['parameter']} E/d); without the "
                   f"{seconds(start)} s that both take for next to nothing, the start of the process above all, "
                   f"{100 * (row['consistent_seconds'] - start) / (row['seconds'] - start):.0f} %.")


def fine_verdict(runs):
    for key, found in runs.items():
        line = [(run.seconds, run.error) for run in found]
        index = fronts.reached(line, FINE_ERROR)
        if key[1] != REFERENCE_TREATMENT:
            continue
        held = index is not None and found[index].blocks <= MOST_BLOCKS
        what = f"{percent(found[index].error)} on {found[index].blocks} blocks" if held else \
            f"{percent(found[-1].error)} on {found[-1].blocks} blocks"
        yield (f"* Peak within {percent(FINE_ERROR)} on at most {MOST_BLOCKS} {key[0]}: "
               f"{'yes' if held else '**no**'}, {what}.")


def bar_verdict(runs):
    """How far the path of the softening bar is off, over all blocks, sizes and stiffnesses."""
    for treatment in (REFERENCE_TREATMENT, "penalty"):
        errors = [abs(run.error) for key, found in runs.items() if key[1] == treatment for run in found if not run.note]
        yield (f"* Whole path of the softening bar, any blocks, size and stiffness: {treatment} is "
               f"{percent(min(errors))} to {percent(max(errors))} of w_c off.")


def section(problem, runs, chosen, rows):
    yield f"### {problem.TITLE}"
    yield f"![{problem.TITLE}: error over time](results/{problem.NAME}.svg)\n"
    yield from comparison_table(rows)
    yield ""
    if any(key[1] == SECOND_ORDER for key in runs):
        yield "Order of the blocks, both with consistent joints; the factors say how many times more first order takes:\n"
        yield from orders_table(runs)
        yield ""
    yield from (lucky_hit(row) for row in rows if row["touch_parameter"] not in ("", row["parameter"]))
    yield "\nThe best of each treatment, from coarse to fine:\n"
    yield from runs_table(runs, chosen)
    yield ""


def text(found):
    rows = comparisons(found)
    out = [f"Python {platform.python_version()}, {platform.machine()}, {os.cpu_count()} cores, one thread per run.\n"]
    bar = any(problem.NAME == softening_bar.NAME for problem in found)
    conclusion = list(share_verdict(rows, start_of(found) if bar else 0.0))
    for problem, (runs, _, _) in found.items():
        if problem.NAME == notched_beam.NAME:
            conclusion += fine_verdict(runs)
        if problem.NAME == softening_bar.NAME:
            conclusion += bar_verdict(runs)
    if conclusion:
        out += ["### Conclusion", *conclusion, ""]
    for problem, (runs, chosen, _) in found.items():
        out += section(problem, runs, chosen, [row for row in rows if row["problem"] == problem.NAME])
    return "\n".join(out)
