"""results/paths.svg: all paths on one another; results/bias.svg: the paper's beam between blocks and through them."""

import patterns
from ddapath import study

plt = study.plots("crack-paths")

COLOURS = dict(zip(patterns.PATTERNS, ("#0b5fa5", "#3f8fd0", "#86bde8", "#c8550a", "#e08a3c", "#b5541c", "#f0b37e", "#2f8f4e")))
STYLES = {"nonlocal_stress": "-", "released_energy": ":"}
OUTLINES = {  # of what the path is drawn in
    "l-panel": [(0, 0), (250, 0), (250, 250), (500, 250), (500, 500), (0, 500), (0, 0)],
    "eccentric-notch": [(-125, 0), (125, 0), (125, 80), (-125, 80), (-125, 0)],
    "shear-beam": [(0, 0), (1322, 0), (1322, 306), (0, 306), (0, 0)],
    "double-notch": [(0, 0), (200, 0), (200, 200), (0, 200), (0, 0)],
}
BEGIN = {"unnotched": [(0, 0)], "notched": [(0, 50)], "four-point": [(0, 0)], "snap-back": [(0, 100 / 6)], "l-panel": [(250, 250)],
         "eccentric-notch": [(-50, 20)], "shear-beam": [(661, 82)], "double-notch": [(25, 100), (175, 100)]}


def lines_of(places, keys):
    """The path of each crack of each run: (what it is, xs, ys)."""
    out = {}
    for place in places:
        name = tuple(place[key] for key in keys)
        out.setdefault((name, int(place["crack"])), []).append((place["x"], place["y"]))
    for (name, crack), line in out.items():
        begin = BEGIN[name[0]]
        yield name, *zip(begin[crack] if crack < len(begin) else line[0], *line)


def draw_paths(beams, curved, file):
    structures = patterns.BEAMS + patterns.CURVED
    figure, panels = plt.subplots(2, 4, figsize=(15, 8))
    for panel, structure in zip(panels.flat, structures):
        panel.set_title(structure.title, fontsize=9)
        panel.set_aspect("equal")
        panel.tick_params(labelsize=7)
        if structure.name in OUTLINES:
            panel.plot(*zip(*OUTLINES[structure.name]), color="#777777", linewidth=0.7)
        else:
            panel.set(xlim=(-30, 30), ylim=(0, 100))
    by_name = dict(zip((structure.name for structure in structures), panels.flat))
    for (name, size, pattern), xs, ys in lines_of(beams, ("structure", "size", "pattern")):
        by_name[name].plot(xs, ys, color=COLOURS[pattern], linewidth=0.9, alpha=0.8)
    for (name, direction, pattern), xs, ys in lines_of(curved, ("structure", "direction", "pattern")):
        by_name[name].plot(xs, ys, color=COLOURS[pattern], linestyle=STYLES[direction], linewidth=0.9)
    for pattern, colour in COLOURS.items():
        panels[0, 0].plot([], [], color=colour, label=pattern)
    panels[0, 0].legend(fontsize=5, loc="upper right")
    for direction, style in STYLES.items():
        panels[1, 0].plot([], [], color="black", linestyle=style, label=direction)
    panels[1, 0].legend(fontsize=6, loc="lower right")
    figure.tight_layout()
    study.save(figure, file)


def draw_bias(rows, reference, file):
    figure, panel = plt.subplots(figsize=(5.5, 3.6))
    for way, colour in (("between blocks", "#c8550a"), ("through blocks", "#0b5fa5")):
        found = [row for row in rows if row["way"] == way]
        panel.plot([row["blocks_asked"] for row in found], [100 * (row["peak"] / reference - 1) for row in found], "o",
                   color=colour, markersize=5, markerfacecolor="none", label=f"cracks {way}")
    panel.axhline(0, color="black", linewidth=0.6)
    panel.set_xlabel("blocks")
    panel.set_ylabel("peak above that of a straight crack [%]")
    panel.legend(fontsize=8)
    figure.tight_layout()
    study.save(figure, file)
