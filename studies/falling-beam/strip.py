"""Five instants of a beam that breaks and falls, with the curve that the first three stand on."""

import math
import re
from collections import Counter

from ddapath import study
from ddapath.animation.motion_reel import MotionReel
from ddapath.animation.path_reel import PathReel, deflection_of
from ddapath.animation.stage import CRACK, INK, PALETTE, Blocks, together

FPS = 20
TORN = 0.3  # of the time between the beginning of the motion and the first hit


def turning_row(run):
    """After the peak, where the deflection has gone back farthest before it grows again."""
    peak = run.summary["peak"]["step"]
    load, deflection = run.curve["load"], run.curve[deflection_of(run)]
    behind = [row for row in run.curve.index if row >= peak and load[row] > 0.3 * load[peak]]
    return min(behind, key=lambda row: deflection[row])


def first_hit(motion):
    """The time at which what moves is fastest [s]."""
    curve = motion.curve
    return float(curve["time"][curve["kinetic_energy"].idxmax()])


def curve(axes, run, rows):
    x, y = run.curve[deflection_of(run)], run.curve["load"] / 1000
    axes.plot(x, y, color=PALETTE[0], linewidth=1.5)
    for number, row in enumerate(rows, 1):
        axes.plot(x[row], y[row], "o", color=CRACK, markersize=5)
        axes.annotate(str(number), (x[row], y[row]), (-10, 3), textcoords="offset points", size=9, color=INK)
    axes.set_xlabel("deflection [mm]", size=9)
    axes.set_ylabel("load [kN]", size=9)
    axes.tick_params(labelsize=8)
    axes.spines[["top", "right"]].set_visible(False)


def moved(axes, reel, time):
    blocks = Blocks(axes, reel.colours(), reel.held)
    polygons = reel.outlines_at(time).polygons
    blocks.show(polygons)
    blocks.hold(polygons)


def frame(axes, box, text):
    for collection in axes.collections:
        collection.set_clip_on(collection.get_hatch() is not None)  # of what is held only a part is shown
    axes.set(xlim=box[[0, 2]], ylim=box[[1, 3]], aspect="equal")
    axes.axis("off")
    axes.set_title(text, size=9, loc="left", color=INK)


def shorter(text):
    """An SVG whose coordinates have two decimals, and whose styles of many paths stand once."""
    text = re.sub(r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", text)
    styles = Counter(re.findall(r' style="([^"]*)"/>', text))
    for number, style in enumerate(style for style, count in styles.items() if count > 20):
        text = text.replace(f' style="{style}"/>', f' class="s{number}"/>')
        text = text.replace("</style>", f".s{number}{{{style}}}</style>", 1)
    return text


def draw(run, file):
    """Two rows of three: the curve, and the beam at the numbered places of it and afterwards."""
    pyplot = study.plots("falling-beam")
    pyplot.rcParams["svg.fonttype"] = "none"
    path, motion = PathReel(run, None, FPS), MotionReel(run, None, FPS)
    figure, axes = pyplot.subplots(2, 3, figsize=(11, 4.2), layout="constrained")
    rows = [0, run.summary["peak"]["step"], turning_row(run)]
    curve(axes[0, 0], run, rows)
    box = together([path.box, motion.box])
    for place, row, text in zip(((0, 1), (0, 2), (1, 0)), rows, ("intact", "peak", "snapped back")):
        path.draw(axes[place], row)
        scale = f", displacements × {path.scale:g}" if row else ""
        frame(axes[place], box, f"{rows.index(row) + 1}  {text}: {run.curve['load'][row] / 1000:.3g} kN{scale}")
    hit, end = first_hit(run.motion), run.summary["motion"]["time"]
    for place, time, text in (((1, 1), math.sqrt(TORN) * hit, "4  torn"), ((1, 2), end, "5  at rest")):
        moved(axes[place], motion, time)
        frame(axes[place], box, f"{text}: {time:.2f} s after it is let go, true scale")
    study.save(figure, file)
    file.write_text(shorter(file.read_text(encoding="utf-8")), encoding="utf-8")
