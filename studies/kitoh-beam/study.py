"""Kitoh's beam: the straight crack, both Voronoi meshes with fracture energy, and instantaneous release.

    study.py --program DDA [--quick] [--only GROUP ...] [--report] [--output FOLDER]

Writes results/runs.csv, results/curves.csv, the figures and the marked region of README.md into FOLDER: this folder, or
with --quick runs/kitoh-beam. The program's own picture of the deformed blocks is the crack pattern of a run.
"""

import shutil
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import report  # noqa: E402
from ddapath import study  # noqa: E402

MESHES = {"coarse": 130, "fine": 455}  # blocks
SEEDS = range(1, 6)
GROUPS = ["straight", "beam", "bias"]
BRITTLE = {"events": "staged", "increments, Newton": {"type": "load_increments", "solver": "newton"},
           "increments, dynamic relaxation": {"type": "load_increments", "solver": "dynamic_relaxation"}}
# The second without friction and as weak in shear as in tension: against the straight crack, only the mesh differs.
WEAK_IN_SHEAR = {"interfaces.joints.law": {"type": "linear_softening", "tensile_strength": 2.9, "fracture_energy": 0.1}}
LAWS = {"c = 4.7 MPa, φ = 37°": {}, "c = 2.9 MPa, φ = 0": WEAK_IN_SHEAR}


@dataclass
class Run:
    """One run of one deck; `group` and `name` say what it is for."""

    group: str
    name: str
    deck: str
    settings: dict = field(default_factory=dict)
    seed: int = 1
    picture: str = ""  # name of the crack pattern's file


def scaled(depth):
    """The straight beam in another size: every length but the thickness in similarity."""
    s = depth / 100
    sizes = {"depth": 100, "span": 300, "overhang": 50, "ligament_size": 2, "far_size": 16}
    out = {"scene.parameters": {name: value * s for name, value in sizes.items()}}
    for place, (x, y) in {"supports.left": (-150, 0), "supports.right": (150, 0), "stages.0.loads.0": (-50, 100),
                          "stages.0.loads.1": (50, 100)}.items():
        out[f"{place}.at"] = [x * s, y * s]
    return out


def straight():
    for depth, energy in report.REFERENCE:
        yield Run("straight", f"h = {depth}, Gf = {energy}", "straight.yaml",
                  scaled(depth) | {"interfaces.ligament.law.fracture_energy": energy})


def beams():
    for mesh, blocks in MESHES.items():
        size = {"scene.subdivision.blocks": blocks}
        yield Run("beam", f"fracture energy, {mesh}", "deck.yaml", size, picture=f"cracks-{mesh}")
        for name, control in BRITTLE.items():
            picture = f"release-{mesh}" if name == "events" else ""
            yield Run("beam", f"release, {name}, {mesh}", "release.yaml", size | {"path.control": control}, picture=picture)


def bias():
    for law, settings in LAWS.items():
        for blocks in MESHES.values():
            for seed in SEEDS:
                sizes = {"scene.subdivision.blocks": blocks, "scene.subdivision.seed": seed}
                yield Run("bias", law, "deck.yaml", sizes | settings, seed)


def quick():
    return [next(straight()), *(run for run in beams() if "coarse" in run.name and "relaxation" not in run.name)]


def execute(run, output):
    """The row of a run and its curve, a DataFrame; its time is the processor's: the clock of a busy machine tells something else."""
    with tempfile.TemporaryDirectory() as work:
        done = study.measured(HERE / run.deck, Path(work) / "run", run.settings)
        if done.exit_code not in (0, 3):
            raise SystemExit(f"{run.name}: exit code {done.exit_code}\n{done.said}")
        if run.picture:
            shutil.copy(done.run.folder / "deformed.svg", output / "results" / f"{run.picture}.svg")
        return row_of(run, done.run.summary, done.processor, done.exit_code), done.run.curve


def row_of(run, summary, seconds, code):
    names = ("blocks", "steps", "rejected_steps", "whole_iterations", "reduced_iterations", "relaxation_iterations",
             "factorisations", "energy_balance_error")
    return {"group": run.group, "name": run.name, "seed": run.seed} | {name: summary[name] for name in names} | {
        "peak_load": summary["peak"]["load"], "peak_deflection": summary["peak"]["gauges"]["deflection"],
        "seconds": seconds, "exit_code": code, "reason": summary["reason"]}


def kept(file, groups):
    """The rows of groups that are not run again."""
    return [row for row in study.read_rows(file) if row["group"] not in groups] if file.exists() else []


def run_all(runs, output):
    groups = {run.group for run in runs}
    files = [output / "results" / f"{name}.csv" for name in ("runs", "curves")]
    rows, points = (kept(file, groups) for file in files)
    for run in runs:
        print(f"{run.group}: {run.name}, seed {run.seed}", file=sys.stderr)
        row, curve = execute(run, output)
        rows.append(row)
        if run.group != "bias":
            points += [{"group": run.group, "name": run.name, "deflection": x, "load": y}
                       for x, y in zip(curve["deflection"], curve["load"])]
    for file, table in zip(files, (rows, points)):
        study.write_rows(file, sorted(table, key=lambda row: GROUPS.index(row["group"])), digits=6)


def main():
    parser = study.parser(__doc__)
    parser.add_argument("--only", nargs="+", choices=GROUPS, default=GROUPS, help="groups that are run again")
    parser.add_argument("--report", action="store_true", help="run nothing; figures and README from results")
    asked = study.arguments(parser, HERE)
    if not asked.report:
        runs = quick() if asked.quick else [run for run in [*straight(), *beams(), *bias()] if run.group in asked.only]
        run_all(runs, asked.output)
    report.write(asked.output)


if __name__ == "__main__":
    main()
