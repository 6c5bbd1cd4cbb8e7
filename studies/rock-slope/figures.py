"""The slope before it is let go and at rest."""

import numpy as np
from ddapath import study
from matplotlib.collections import PolyCollection


def count(run, region):
    """Blocks of a region of the deck, whose number is its place there."""
    names = [one["name"] for one in run.deck["scene"]["regions"]]
    return int(np.sum(run.motion.fields().mesh.region == names.index(region)))


def before_and_after(run, file):
    pyplot = study.plots("slope")
    fields = run.motion.fields()
    time = run.summary["motion"]["time"]
    figure, axes = pyplot.subplots(2, 1, figsize=(9, 7), sharex=True, layout="constrained")
    colours = ["#c9b79c" if region == 0 else "#9a9a9a" for region in fields.mesh.region]
    for axis, scale, title in zip(axes, (0, 1), ("before", f"after {time:.3g} s")):
        axis.add_collection(PolyCollection(fields.polygons(scale), facecolors=colours, edgecolors="black", linewidths=0.3))
        axis.set_aspect("equal")
        axis.set(title=title, ylabel="y [m]", ylim=(-3, 23), xlim=(-25, 35))
    axes[1].set_xlabel("x [m]")
    study.save(figure, file)
