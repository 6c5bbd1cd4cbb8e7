"""Which line of a work-precision diagram is best, and how many times longer another takes to an equal error.

A line is a list of (seconds, error), from coarse to fine blocks; errors may be signed, a failed run is not a number.
"""

import math


def sizes_of_error(line):
    """|error| per size, infinite where a run failed."""
    return [abs(error) if math.isfinite(error) else math.inf for _, error in line]


def reached(line, target):
    """Index of the coarsest blocks from which the error is at most `target` *and stays so* on all finer ones; None if
    it does not. An error that passes through zero on its way elsewhere has touched the target, not reached it."""
    errors = sizes_of_error(line)
    first = None
    for index in reversed(range(len(errors))):
        if errors[index] > target:
            break
        first = index
    return first


def time_to(line, target):
    """Seconds at which the line falls to the target for good, interpolated on log-log axes between the last size
    above it and the first below; infinite if it does not."""
    index = reached(line, target)
    if index is None:
        return math.inf
    errors = sizes_of_error(line)
    if index == 0 or math.isinf(errors[index - 1]) or errors[index] == 0:
        return line[index][0]
    before, after = math.log(errors[index - 1]), math.log(errors[index])
    share = (before - math.log(target)) / (before - after)
    slow, fast = math.log(line[index][0]), math.log(line[index - 1][0])
    return math.exp(fast + share * (slow - fast))


def smallest(line):
    """The smallest error that the line keeps: that of its finest blocks."""
    return sizes_of_error(line)[-1]


def best(lines, target):
    """The name of the line that reaches the target first; if none does, of the one that keeps the smallest error."""
    times = {name: time_to(line, target) for name, line in lines.items()}
    if any(map(math.isfinite, times.values())):
        return min(times, key=times.get)
    return min(lines, key=lambda name: smallest(lines[name]))


def first_touch(lines, target):
    """(seconds, name) of the fastest run of any line whose error happens to be below the target; None if none is."""
    hits = [(seconds, name) for name, line in lines.items() for seconds, error in line
            if math.isfinite(error) and abs(error) <= target]
    return min(hits, default=None)


def front(lines):
    """The runs that no other beats in both time and error, fastest first: (seconds, |error|)."""
    points = sorted((seconds, abs(error)) for line in lines for seconds, error in line if math.isfinite(error))
    out = []
    for seconds, error in points:
        if not out or error < out[-1][1]:
            out.append((seconds, error))
    return out
