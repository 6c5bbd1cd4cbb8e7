"""Table, exponents and figure from results/scaling.csv; nothing in the marked region of README.md is typed."""

import math
import os
import platform

import numpy as np

from ddapath import study

plt = study.plots("scaling")

FITTED_FROM = 9000  # blocks; below, start-up and calls of a few microseconds decide
LIMITS = {"total": 1.45, "one reduced iteration": 0.7, "one step": 0.75}  # of the exponents


def exponent(rows, name):
    """p of seconds ∝ blocks^p by least squares of the logarithms, over the large beams; None below two of them."""
    large = [row for row in rows if row["blocks"] >= FITTED_FROM and row[name] > 0]
    if len(large) < 2:
        return None
    x, y = (np.log([row[key] for row in large]) for key in ("blocks", name))
    return float(np.polyfit(x, y, 1)[0])


def seconds(value):
    return f"{value:.2f}" if value >= 1 else f"{value:.3f}" if value >= 0.01 else f"{1000 * value:.3f} ms"


def table(rows, names):
    yield "| | " + " | ".join(f"{row['blocks']:.0f}" for row in rows) + " | exponent |"
    yield "|---|" + "---|" * (len(rows) + 1)
    for title, key, form in (("points that can crack", "crackable_points", "{:.0f}"), ("steps", "steps", "{:.0f}"),
                             ("iterations on the cracked points", "reduced_iterations", "{:.0f}"),
                             ("iterations on all unknowns", "whole_iterations", "{:.0f}"),
                             ("factorisations", "factorisations", "{:.0f}"), ("peak load [N]", "peak_load", "{:.2f}"),
                             ("memory [MiB]", "memory_mib", "{:.0f}"), ("at least, by `check` [MiB]", "predicted_mib", "{:.0f}")):
        yield f"| {title} | " + " | ".join(form.format(row[key]) for row in rows) + " | |"
    for name in names:
        if not any(row.get(name, 0) for row in rows):
            continue
        p = exponent(rows, name)
        yield f"| {name} [s] | " + " | ".join(seconds(row[name]) for row in rows) + f" | {'–' if p is None else f'{p:.2f}'} |"


def verdicts(rows):
    for name, limit in LIMITS.items():
        p = exponent(rows, name)
        if p is not None:
            yield f"* Exponent of {name}: {p:.2f}, at most {limit}: {'yes' if p <= limit else '**no**'}."


def draw(by_beam, names, file):
    figure, panels = plt.subplots(1, len(by_beam), figsize=(4.8 * len(by_beam), 4.4), sharey=True, squeeze=False)
    for panel, (beam, rows) in zip(panels[0], by_beam.items()):
        for name in names:
            heavy = name in LIMITS
            panel.loglog([row["blocks"] for row in rows], [row.get(name) or math.nan for row in rows], marker="o", markersize=3,
                         linewidth=2.2 if heavy else 1, color="black" if name == "total" else None, label=name)
        panel.set_title(beam)
        panel.set_xlabel("blocks")
        panel.grid(True, which="major", linewidth=0.3)
    panels[0][0].set_ylabel("time [s]")
    figure.legend(*panels[0][0].get_legend_handles_labels(), loc="lower center", ncol=4, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.14, 1, 1))
    study.save(figure, file)


def text(by_beam, names):
    out = [f"{platform.machine()}, {os.cpu_count()} cores, one thread per run; [what two bring](../../docs/manual/time.md#threads).\n"]
    for beam, rows in by_beam.items():
        out += [f"### {beam.capitalize()}", *table(rows, names), "", *verdicts(rows), ""]
    return "\n".join(out)


def write(output, rows, names):
    by_beam = {beam: [row for row in rows if row["beam"] == beam] for beam in dict.fromkeys(row["beam"] for row in rows)}
    draw(by_beam, names, output / "results" / "scaling.svg")
    study.write_region(output / "README.md", text(by_beam, names))
