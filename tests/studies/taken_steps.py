"""Whether a LOCA::Stepper has taken every step of a run: what summary.json counts and curve.csv has a row of."""

import csv
import json


def complaints(folder):
    """What is wrong with the runs in a folder and below it."""
    for file in sorted(folder.rglob("summary.json")):
        summary = json.loads(file.read_text(encoding="utf-8"))
        with (file.parent / "curve.csv").open(newline="", encoding="utf-8") as stream:
            rows = [row["step"] for row in csv.DictReader(stream)]
        steps, cracked, whole = (summary[name] for name in ("steps", "cracked_steps", "whole_steps"))
        if steps != cracked + whole:
            yield f"{file}: {steps} steps, of which LOCA has taken {cracked} on the cracked points and {whole} on all unknowns"
        if rows != [str(step) for step in range(steps + 1)]:
            yield f"{file}: {steps} steps, but curve.csv has other rows than its start and one for each"
