"""results/size-effect.svg: nominal strength against size, and the Voronoi blocks against the straight crack."""

import numpy as np
from matplotlib.ticker import FuncFormatter, NullFormatter

import nominal
import size_effect_law as law
from ddapath import study

plt = study.plots("size-effect")

COLOURS = {"notched": "#0b5fa5", "three-point": "#c8550a", "four-point": "#2f8f4e"}
MARKERS = {"notched": "o", "three-point": "s", "four-point": "^"}
GREY = "#777777"
RANGE = np.geomspace(0.03, 17, 200)  # of D/l_ch


def draw(peaks, biases, fitted, file):
    """`peaks` and `biases` by the name of the beam, `fitted` the law of the notched one or None."""
    figure, panels = plt.subplots(1, 3, figsize=(13.2, 4.6))
    draw_notched(panels[0], peaks.get("notched", []), biases.get("notched", []), fitted)
    draw_uncracked(panels[1], peaks, biases)
    draw_bias(panels[2], biases)
    for panel in panels:
        panel.set_xscale("log")
        panel.set_xlabel("size D / l_ch")
        panel.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        panel.grid(True, which="major", linewidth=0.3)
    figure.tight_layout()
    study.save(figure, file)


def draw_column(panel, beam, peaks, biases):
    """The straight crack, the other solver and the Voronoi blocks of one beam."""
    colour = COLOURS[beam.name]
    panel.plot([p.length for p in peaks], [p.strength for p in peaks], color=colour, linewidth=1.4,
               marker=MARKERS[beam.name], markersize=4, label=f"{beam.title}: straight crack", zorder=3)
    panel.plot(nominal.LENGTHS, beam.reference, linestyle="none", marker="x", markersize=8, color="black", zorder=4,
               label="independent solver" if beam.name != "four-point" else None)
    if biases:
        panel.errorbar([b.length for b in biases], [b.strength for b in biases],
                       yerr=[b.scatter * b.strength / (1 + b.mean) for b in biases], linestyle="none", color=colour,
                       marker=MARKERS[beam.name], markerfacecolor="white", markersize=6, capsize=3, linewidth=1,
                       label="Voronoi blocks, mean and scatter" if beam.name != "four-point" else None, zorder=5)


def draw_notched(panel, peaks, biases, fitted):
    draw_column(panel, nominal.BEAMS[0], peaks, biases)
    panel.plot(RANGE, 1 / np.sqrt(law.LEFM_SLOPE * RANGE), color=GREY, linewidth=1, linestyle="--",
               label="linear elastic fracture mechanics")
    panel.axhline(law.PLASTIC["notched"], color=GREY, linewidth=1, linestyle=":", label="plastic limit")
    if fitted:
        panel.plot(RANGE, fitted.strength(RANGE), color="#8e3a9d", linewidth=1, label="size-effect law, fitted")
    decimals(panel, (0.12, 1.1), (0.15, 0.2, 0.3, 0.5, 0.75, 1))
    panel.set_ylabel("nominal strength σ_N / ft")
    panel.legend(fontsize=7, loc="lower left")


def draw_uncracked(panel, peaks, biases):
    for beam in nominal.BEAMS[1:]:
        draw_column(panel, beam, peaks.get(beam.name, []), biases.get(beam.name, []))
        panel.axhline(law.ELASTIC[beam.name], color=COLOURS[beam.name], linewidth=1, linestyle="--",
                      label="elastic limits" if beam.name == "three-point" else None)
    panel.axhline(law.PLASTIC["three-point"], color=GREY, linewidth=1, linestyle=":", label="plastic limit")
    decimals(panel, (0.8, 4.2), (1, 1.5, 2, 3, 4))
    panel.legend(fontsize=7, loc="upper right")


def draw_bias(panel, biases):
    for shift, beam in zip((0.93, 1, 1.07), nominal.BEAMS):
        found = biases.get(beam.name, [])
        x, mean = np.array([shift * b.length for b in found]), np.array([100 * b.mean for b in found])
        panel.errorbar(x, mean, yerr=[100 * b.scatter for b in found], color=COLOURS[beam.name], capsize=3, linewidth=1,
                       marker=MARKERS[beam.name], markerfacecolor="white", label=beam.title)
        panel.vlines(x, [100 * b.lowest for b in found], [100 * b.highest for b in found], color=COLOURS[beam.name],
                     linewidth=0.5)
    panel.axhline(0, color="black", linewidth=0.8)
    panel.margins(y=0.18)  # room for the legend
    panel.set_ylabel("Voronoi blocks: peak against the straight crack [%]")
    panel.legend(fontsize=7)


def decimals(panel, limits, ticks):
    """A logarithmic axis of strengths with these ticks."""
    panel.set_yscale("log")
    panel.set_ylim(*limits)
    panel.set_yticks(ticks)
    panel.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    panel.yaxis.set_minor_formatter(NullFormatter())
