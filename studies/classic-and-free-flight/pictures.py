"""The figures of the study."""

from ddapath import study


def rebound(rows, file):
    """Speed after an impact over that before, by the time step: a curve per integrator and penalty."""
    plot = study.plots("classic-and-free-flight")
    figure, axes = plot.subplots(figsize=(6, 3.6), layout="constrained")
    for name in dict.fromkeys(row["integrator"] for row in rows):
        of = [row for row in rows if row["integrator"] == name]
        is_free = name == "free_flight"
        axes.semilogx([1000 * row["step"] for row in of], [row["found"] for row in of], "o-" if is_free else "s--",
                      color="black" if is_free else None, label=name.removesuffix(", displacement 0.2"))
    steps = sorted({1000 * row["step"] for row in rows})
    axes.set_xticks(steps, [f"{step:g}" for step in steps])
    axes.minorticks_off()
    axes.set(xlabel="time step [ms]", ylabel="speed after / before the impact", ylim=(-0.03, 1.03))
    axes.legend(fontsize=8)
    study.save(figure, file)


def collapse(fallen, file):
    """Where the blocks of the columns are at the end of the run with either integrator."""
    plot = study.plots("classic-and-free-flight")
    columns = [(row, outlines) for row, outlines in fallen if row["scene"].startswith("column")][:2]
    figure, all_axes = plot.subplots(1, len(columns), figsize=(4.6 * len(columns), 3.2), layout="constrained", squeeze=False)
    for axes, (row, outlines) in zip(all_axes[0], columns, strict=True):
        for polygon in outlines:
            axes.fill(polygon[:, 0], polygon[:, 1], facecolor="0.85", edgecolor="black", linewidth=0.6)
        axes.set(aspect="equal", xlim=(-8, 12), ylim=(-1, 9), title=f"{row['integrator']}: after {2 * row['reached']:.2g} s")
    study.save(figure, file)
