"""What a time step of moving blocks costs: columns of Voronoi blocks that collapse, by their number and by threads.

    moving_blocks.py PROGRAM [RUNS]

Prints a Markdown table: Newton iterations a step, milliseconds a step and an iteration, blocks · steps a second, and the exponent
of the time of a step from one number of blocks to the next; with two threads the same and whether the bits are those of one.
Numbers are medians of RUNS runs (default 3). Exit 1 when a target is missed.
"""

import csv
import math
import statistics
import sys
import tempfile

from processes import Program

STONE = {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2, "density": 2500}
HEIGHT, BREADTH, FRICTION_ANGLE = 8.0, 4.0, 21.8
STEPS = {50: 200, 300: 60, 2000: 6}
TARGETS = {50: 3e4, 300: 1e4, 2000: 2000 / 0.3}  # blocks · steps a second


def column(blocks):
    """A column, twice as high as it is broad, on a held floor; every joint is friction alone."""
    size = math.sqrt(HEIGHT * BREADTH / blocks)
    joint = {"type": "friction", "friction_angle": FRICTION_ANGLE}

    def box(low, high, left, right):
        return [[left, low], [right, low], [right, high], [left, high]]

    return {"units": {"length": "m", "force": "N"},
            "scene": {"regions": [{"name": "floor", "material": "floor", "vertices": box(-size, 0, -2 * BREADTH, 3 * BREADTH)},
                                  {"name": "column", "material": "stone", "vertices": box(0, HEIGHT, 0, BREADTH)}],
                      "subdivision": {"type": "voronoi", "size": size, "seed": 1}},
            "thickness": 1, "materials": {"floor": STONE, "stone": STONE},
            "interfaces": {"joints": {"between": ["stone", "stone"], "law": joint},
                           "foot": {"between": ["stone", "floor"], "law": joint}},
            "motion": {"time": STEPS[blocks] * 0.01 * math.sqrt(0.7 * size / 9.81), "gravity": [0, -9.81], "held": ["floor"],
                       "frame_every": 10, "contact": {"friction": 0.4}}}


def moved(program, deck, threads):
    """Steps, iterations, seconds of the motion, and its table as text."""
    _, summary = program.run(deck, threads=threads)
    text = (program.folder / "run" / "motion" / "motion.csv").read_text(encoding="utf-8")
    last = list(csv.DictReader(text.splitlines()))[-1]
    return int(last["step"]), int(last["iterations"]), summary["timings"]["motion"], text


def measured(program, blocks, threads, runs):
    found = [moved(program, column(blocks), threads) for _ in range(runs)]
    steps, iterations, _, text = found[0]
    return {"blocks": blocks, "steps": steps, "iterations": iterations / steps, "text": text,
            "seconds": statistics.median(seconds for _, _, seconds, _ in found) / steps}


def rows(program, runs):
    before = None
    for blocks in STEPS:
        one, two = (measured(program, blocks, threads, runs) for threads in (1, 2))
        exponent = math.log(one["seconds"] / before["seconds"]) / math.log(one["blocks"] / before["blocks"]) if before else None
        yield {"blocks": one["blocks"], "iterations": one["iterations"], "ms": 1000 * one["seconds"],
               "per_iteration": 1000 * one["seconds"] / one["iterations"], "speed": one["blocks"] / one["seconds"],
               "target": TARGETS[blocks], "exponent": exponent, "threads": one["seconds"] / two["seconds"],
               "same": one["text"] == two["text"]}
        before = one


def main():
    program, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    print("| blocks | iterations a step | ms a step | ms an iteration | blocks · steps/s | target | exponent | two threads | same bits |")
    print("|---|---|---|---|---|---|---|---|---|")
    missed = False
    with tempfile.TemporaryDirectory(prefix="ddapath-") as folder:
        for row in rows(Program(program, folder), runs):
            missed |= row["speed"] < row["target"] or not row["same"]
            exponent = f"{row['exponent']:.2f}" if row["exponent"] else ""
            print(f"| {row['blocks']} | {row['iterations']:.1f} | {row['ms']:.1f} | {row['per_iteration']:.2f} | {row['speed']:.3g} "
                  f"| {row['target']:.3g} | {exponent} | {row['threads']:.2f} times | {'yes' if row['same'] else 'no'} |")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
