"""One figure per problem: |error| over seconds of the whole process, a panel per block type."""

import math

from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

import fronts
from ddapath import study

plt = study.plots("run-time-against-error")

COLOURS = {"consistent": "#0b5fa5", "second_order": "#000000", "penalty": "#c8550a", "augmented_lagrangian": "#2f8f4e", "lagrange": "#8e3a9d"}
GREY = "#a8a8a8"


def draw(problem, lines, chosen, target, file):
    """`lines`: (block type, treatment, parameter) → [(seconds, error)]; `chosen`: the keys of the best of each."""
    shapes = list(dict.fromkeys(key[0] for key in lines))
    figure, panels = plt.subplots(1, len(shapes), figsize=(4.1 * len(shapes), 4.3), sharey=True, squeeze=False)
    for panel, shape in zip(panels[0], shapes):
        draw_panel(panel, {key: line for key, line in lines.items() if key[0] == shape}, chosen)
        panel.axhline(target, color="black", linewidth=0.7, linestyle=":")
        panel.set_title(shape)
        panel.set_xlabel("whole process [s]")
        panel.grid(True, which="major", linewidth=0.3)
    panels[0][0].set_ylabel("|relative error|")
    used = list(dict.fromkeys(key[1] for key in lines))
    figure.suptitle(problem.TITLE)
    has_negative = any(error < 0 for line in lines.values() for _, error in line)
    figure.legend(handles=legend(used, target, has_negative), loc="lower center", ncol=4, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.11, 1, 1))
    study.save(figure, file)


def draw_panel(panel, lines, chosen):
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    panel.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    panel.xaxis.set_minor_formatter(NullFormatter())
    best_front = fronts.front(lines.values())
    panel.plot([s for s, _ in best_front], [e for _, e in best_front], color="#f2d000", linewidth=7, alpha=0.55,
               solid_capstyle="round", zorder=1)
    for key in sorted(lines, key=lambda key: key in chosen):  # the best on top
        draw_line(panel, key, lines[key], key in chosen)


def draw_line(panel, key, line, is_best):
    _, treatment, parameter = key
    colour = COLOURS.get(treatment, "black") if is_best else GREY
    known = [(seconds, error) for seconds, error in line if math.isfinite(error) and error != 0]
    if not known:
        return
    seconds, errors = [s for s, _ in known], [abs(e) for _, e in known]
    panel.plot(seconds, errors, color=colour, linewidth=1.8 if is_best else 0.7, zorder=3 if is_best else 2)
    for sign in (1, -1):
        mine = [(s, abs(e)) for s, e in known if sign * e > 0]
        panel.plot([s for s, _ in mine], [e for _, e in mine], linestyle="none", marker="o", color=colour,
                   markersize=5 if is_best else 2.5, markerfacecolor=colour if sign > 0 else "white",
                   zorder=4 if is_best else 2)
    if parameter:
        panel.annotate(parameter, (seconds[-1], errors[-1]), xytext=(4, 0), textcoords="offset points", fontsize=6,
                       color=colour, va="center")


def legend(treatments, target, has_negative):
    handles = [Line2D([], [], color=COLOURS.get(name, "black"), marker="o", linewidth=1.8, label=name.replace("_", " "))
               for name in treatments]
    handles += [Line2D([], [], color=GREY, linewidth=0.7, label="other parameters"),
                Line2D([], [], color="#f2d000", linewidth=7, alpha=0.55, label="best front"),
                Line2D([], [], color="black", linewidth=0.7, linestyle=":", label=f"compared at {100 * target:g} %")]
    if has_negative:
        handles.append(Line2D([], [], color="black", marker="o", markerfacecolor="white", linestyle="none",
                              label="open: error < 0"))
    return handles
