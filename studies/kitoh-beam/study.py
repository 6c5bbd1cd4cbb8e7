"""Kitoh's beam: the straight crack, both Voronoi meshes with fracture energy, and instantaneous release.

    study.py --program DDA [--quick] [--only GROUP ...] [--report] [--output FOLDER]

Writes results/runs.csv, results/curves.csv, the figures and the marked region of README.md into FOLDER: this folder, or
with --quick runs/kitoh-beam. The program's own picture of the deformed blocks is the crack pattern of a run.
"""

import argparse
import csv
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import report

HERE = Path(__file__).resolve().parent
MESHES = {"coarse": 130, "fine": 455}  # blocks
SEEDS = range(1, 6)
GROUPS = ["straight", "beam", "bias"]
BRITTLE = {"events": "staged", "increments, Newton": "{type: load_increments, solver: newton}",
           "increments, dynamic relaxation": "{type: load_increments, solver: dynamic_relaxation}"}
# The second without friction and as weak in shear as in tension: against the straight crack, only the mesh differs.
LAWS = {"c = 4.7 MPa, φ = 37°": [], "c = 2.9 MPa, φ = 0": ["interfaces.joints.law={type: linear_softening, tensile_strength: 2.9, fracture_energy: 0.1}"]}


@dataclass
class Run:
    """One run of one deck; `group` and `name` say what it is for."""

    group: str
    name: str
    deck: str
    settings: list = field(default_factory=list)
    seed: int = 1
    picture: str = ""  # name of the crack pattern's file


def scaled(depth):
    """The straight beam in another size: every length but the thickness in similarity."""
    s = depth / 100
    out = [f"scene.parameters={{depth: {depth}, span: {300 * s:g}, overhang: {50 * s:g}, ligament_size: {2 * s:g}, far_size: {16 * s:g}}}"]
    for place, (x, y) in {"supports.left": (-150, 0), "supports.right": (150, 0), "stages.0.loads.0": (-50, 100),
                          "stages.0.loads.1": (50, 100)}.items():
        out.append(f"{place}.at=[{x * s:g}, {y * s:g}]")
    return out


def straight():
    for depth, energy in report.REFERENCE:
        yield Run("straight", f"h = {depth}, Gf = {energy}", "straight.yaml",
                  [*scaled(depth), f"interfaces.ligament.law.fracture_energy={energy}"])


def beams():
    for mesh, blocks in MESHES.items():
        size = f"scene.subdivision.blocks={blocks}"
        yield Run("beam", f"fracture energy, {mesh}", "deck.yaml", [size], picture=f"cracks-{mesh}")
        for name, control in BRITTLE.items():
            picture = f"release-{mesh}" if name == "events" else ""
            yield Run("beam", f"release, {name}, {mesh}", "release.yaml", [size, f"path.control={control}"], picture=picture)


def bias():
    for law, settings in LAWS.items():
        for blocks in MESHES.values():
            for seed in SEEDS:
                sizes = [f"scene.subdivision.blocks={blocks}", f"scene.subdivision.seed={seed}"]
                yield Run("bias", law, "deck.yaml", sizes + settings, seed)


def quick():
    return [next(straight()), *(run for run in beams() if "coarse" in run.name and "relaxation" not in run.name)]


def processor_time():
    """Seconds that finished runs have used so far: on a busy machine the clock would tell something else."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def execute(program, run, output):
    """The row of a run and its curve, a list of (deflection, load)."""
    with tempfile.TemporaryDirectory() as work:
        command = [program, "run", HERE / run.deck, "--folder", Path(work) / "run", "--quiet"]
        for setting in run.settings:
            command += ["--set", setting]
        before = processor_time()
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        seconds = processor_time() - before
        if done.returncode not in (0, 3):
            raise SystemExit(f"{run.name}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        folder = Path(work) / "run"
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        with (folder / "curve.csv").open(newline="", encoding="utf-8") as stream:
            curve = [(float(row["deflection"]), float(row["load"])) for row in csv.DictReader(stream)]
        if run.picture:
            shutil.copy(folder / "deformed.svg", output / "results" / f"{run.picture}.svg")
    return row_of(run, summary, seconds, done.returncode), curve


def row_of(run, summary, seconds, code):
    names = ("blocks", "steps", "rejected_steps", "newton_iterations", "reduced_iterations", "relaxation_iterations",
             "factorisations", "energy_balance_error")
    return {"group": run.group, "name": run.name, "seed": run.seed} | {name: summary[name] for name in names} | {
        "peak_load": summary["peak"]["load"], "peak_deflection": summary["peak"]["gauges"]["deflection"],
        "seconds": seconds, "exit_code": code, "reason": summary["reason"]}


def write_csv(file, rows):
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()})


def kept(file, groups):
    """The rows of groups that are not run again."""
    return [row for row in report.read(file) if row["group"] not in groups] if file.exists() else []


def run_all(program, runs, output):
    groups = {run.group for run in runs}
    files = [output / "results" / f"{name}.csv" for name in ("runs", "curves")]
    rows, points = (kept(file, groups) for file in files)
    for run in runs:
        print(f"{run.group}: {run.name}, seed {run.seed}", file=sys.stderr)
        row, curve = execute(program, run, output)
        rows.append(row)
        if run.group != "bias":
            points += [{"group": run.group, "name": run.name, "deflection": x, "load": y} for x, y in curve]
    for file, table in zip(files, (rows, points)):
        write_csv(file, sorted(table, key=lambda row: GROUPS.index(row["group"])))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="the program dda")
    parser.add_argument("--quick", action="store_true", help="the coarse mesh alone: does it work?")
    parser.add_argument("--only", nargs="+", choices=GROUPS, default=GROUPS, help="groups that are run again")
    parser.add_argument("--report", action="store_true", help="run nothing; figures and README from results")
    parser.add_argument("--output", type=Path, help="where README.md and results/ go")
    return parser.parse_args()


def main():
    asked = arguments()
    output = asked.output or (Path("runs") / HERE.name if asked.quick else HERE)
    (output / "results").mkdir(parents=True, exist_ok=True)
    if not (output / "README.md").exists():
        shutil.copy(HERE / "README.md", output)
    if not asked.report:
        os.environ["OMP_NUM_THREADS"] = "1"
        runs = quick() if asked.quick else [run for run in [*straight(), *beams(), *bias()] if run.group in asked.only]
        run_all(str(Path(asked.program).resolve()), runs, output)
    report.write(output)


if __name__ == "__main__":
    main()
