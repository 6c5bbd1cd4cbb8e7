"""Tables and figures from results/runs.csv and results/curves.csv; nothing in the marked region of README.md is typed."""

import statistics

from ddapath import study

plt = study.plots("kitoh-beam")

# Peak load [kN] of a straight central crack by depth [mm] and Gf [N/mm]: an independent cohesive-crack solver.
REFERENCE = {(100, 0.05): 13.163, (100, 0.1): 14.997, (100, 0.15): 16.154, (200, 0.1): 26.327, (400, 0.1): 46.544, (800, 0.1): 84.220}
FIRST_CRACK = {"beam theory": 9.667, "plane stress": 9.17}  # kN
STRAIGHT = "h = 100, Gf = 0.1"


def of_group(rows, group):
    return [row for row in rows if row["group"] == group]


def straight_table(rows):
    yield "| h [mm] | Gf [N/mm] | reference [kN] | peak [kN] | difference | blocks | steps | processor time [s] |"
    yield "|---|---|---|---|---|---|---|---|"
    for row in rows:
        depth, energy = (float(part.split("=")[1]) for part in row["name"].split(","))
        expected, found = REFERENCE[depth, energy], row["peak_load"] / 1000
        yield (f"| {depth:.0f} | {energy:g} | {expected:.3f} | {found:.3f} | {100 * (found / expected - 1):+.2f} % | "
               f"{row['blocks']:.0f} | {row['steps']:.0f} | {row['seconds']:.2f} |")


def beam_table(rows):
    yield ("| run | blocks | peak [kN] | at [mm] | steps | rejected | Newton's iterations | residuals in relaxation | "
           "factorisations | processor time [s] | exit code |")
    yield "|---|---|---|---|---|---|---|---|---|---|---|"
    for row in rows:
        iterations = row["whole_iterations"] + row["reduced_iterations"]
        yield (f"| {row['name']} | {row['blocks']:.0f} | {row['peak_load'] / 1000:.3f} | {row['peak_deflection']:.4f} | "
               f"{row['steps']:.0f} | {row['rejected_steps']:.0f} | {iterations:.0f} | {row['relaxation_iterations']:.0f} | "
               f"{row['factorisations']:.0f} | {row['seconds']:.2f} | {row['exit_code']:.0f} |")


def biases(rows):
    """{(law, blocks): peaks over that of the straight crack, minus one}."""
    out = {}
    for row in rows:
        out.setdefault((row["name"], int(row["blocks"])), []).append(row["peak_load"] / 1000 / REFERENCE[100, 0.1] - 1)
    return out


def bias_table(rows):
    yield "| shear | blocks | meshes | mean bias of the peak | smallest | largest |"
    yield "|---|---|---|---|---|---|"
    for (law, blocks), found in biases(rows).items():
        mean, low, high = (f"{100 * value:+.1f} %" for value in (statistics.mean(found), min(found), max(found)))
        yield f"| {law} | {blocks} | {len(found)} | {mean} | {low} | {high} |"


def draw_curves(curves, file):
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 4.2), gridspec_kw={"width_ratios": (1.6, 1)})
    styles = {STRAIGHT: ("black", "-", "one straight crack"), "fracture energy, fine": ("C0", "-", None),
              "fracture energy, coarse": ("C1", "-", None), "release, events, fine": ("C2", "-", None),
              "release, events, coarse": ("C3", "-", None)}
    for name, (colour, line, label) in styles.items():
        points = [(row["deflection"], row["load"] / 1000) for row in curves if row["name"] == name]
        for panel in (left, right) if name.startswith("release") else (left,):
            panel.plot(*zip(*points) if points else ((), ()), color=colour, linestyle=line, linewidth=1.4, label=label or name)
    for mesh, colour in (("coarse", "C3"), ("fine", "C2")):
        name = f"release, increments, dynamic relaxation, {mesh}"
        points = [(row["deflection"], row["load"] / 1000) for row in curves if row["name"] == name]
        if points:
            right.plot(*zip(*points), linestyle="", marker="o", markersize=3.5, fillstyle="none", color=colour, label=f"dynamic relaxation, {mesh}")
    left.axhline(REFERENCE[100, 0.1], color="black", linestyle=":", linewidth=0.9, label="peak of the reference")
    right.axhspan(*sorted(FIRST_CRACK.values()), color="0.85", label="first cracking, reference")
    left.set_title("fracture energy (and release)", fontsize=10)
    right.set_title("instantaneous release", fontsize=10)
    for panel in (left, right):
        panel.set_xlabel("deflection at midspan [mm]")
        panel.set_xlim(left=0)
        panel.set_ylim(bottom=0)
        panel.grid(True, linewidth=0.3)
        panel.legend(fontsize=7, frameon=False, loc="upper right" if panel is left else "lower right")
    left.set_xlim(0, 0.2)
    right.set_xlim(0, 0.04)
    left.set_ylabel("load [kN]")
    save(figure, file)


def draw_bias(rows, file):
    figure, panel = plt.subplots(figsize=(5.2, 3.6))
    found = biases(rows)
    laws, sizes = list(dict.fromkeys(law for law, _ in found)), list(dict.fromkeys(blocks for _, blocks in found))
    for i, law in enumerate(laws):
        for j, blocks in enumerate(sizes):
            values, x = [100 * value for value in found.get((law, blocks), [])], j + 0.2 * (i - 0.5)
            panel.plot([x] * len(values), values, "o", markersize=4, fillstyle="none", color=f"C{i}", label=law if j == 0 else None)
            if values:
                panel.plot([x - 0.07, x + 0.07], [statistics.mean(values)] * 2, color=f"C{i}", linewidth=2)
    panel.set_xticks(range(len(sizes)), [f"{blocks} blocks" for blocks in sizes])
    panel.set_xlim(-0.5, len(sizes) - 0.5)
    panel.set_ylim(bottom=0)
    panel.set_ylabel("peak against the straight crack [%]")
    panel.grid(True, axis="y", linewidth=0.3)
    panel.legend(fontsize=8, frameon=False)
    save(figure, file)


def save(figure, file):
    figure.tight_layout()
    study.save(figure, file)


def text(rows):
    out = ["### One straight crack", *straight_table(of_group(rows, "straight")), "", "### Voronoi blocks",
           *beam_table(of_group(rows, "beam")), "", "Why the runs under force control ended:\n"]
    out += [f"* {row['name']}: {row['reason']}" for row in of_group(rows, "beam") if row["exit_code"] == 3]
    if of_group(rows, "bias"):
        out += ["", "### Bias of the mesh", *bias_table(of_group(rows, "bias"))]
    return "\n".join(out)


def write(output):
    rows, curves = (study.read_rows(output / "results" / f"{name}.csv") for name in ("runs", "curves"))
    draw_curves(curves, output / "results" / "curve.svg")
    if of_group(rows, "bias"):
        draw_bias(of_group(rows, "bias"), output / "results" / "bias.svg")
    study.write_region(output / "README.md", text(rows))
