"""The runs of a problem as a CSV file, and back: figures and README are made from these files alone."""

import csv

from measure import Measured

COLUMNS = ["block_type", "size", "treatment", "parameter", "blocks", "seconds", "processor_seconds", "error", "note"]


def write_runs(file, sizes_of, runs):
    """`runs`: (block type, treatment, parameter) → Measured from coarse to fine, of the first of the sizes that a block type
    and a treatment have."""
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(COLUMNS)
        for (shape, treatment, label), found in runs.items():
            for size, run in zip(sizes_of(shape, treatment), found):
                writer.writerow([shape, size, treatment, label, run.blocks, f"{run.seconds:.4f}",
                                 f"{run.processor:.4f}", f"{run.error:.6g}", run.note])


def read_runs(file):
    runs = {}
    with file.open(newline="", encoding="utf-8") as stream:
        for row in csv.DictReader(stream):
            run = Measured(float(row["seconds"]), float(row["processor_seconds"]), int(row["blocks"]),
                           float(row["error"]), row["note"])
            runs.setdefault((row["block_type"], row["treatment"], row["parameter"]), []).append(run)
    return runs
