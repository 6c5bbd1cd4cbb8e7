"""Cracks through blocks: the same beams and curved cracks on every pattern of blocks.

    study.py --program DDA [--quick] [--jobs N] [--only PART ...] [--report] [--output FOLDER]

Parts: beams, curved, second-order, paper. Writes results/*.csv, the figures and the marked region of README.md into FOLDER: this
folder, or with --quick runs/crack-paths.
"""

import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import patterns  # noqa: E402
import report  # noqa: E402
from ddapath import study  # noqa: E402

DIRECTIONS = ("nonlocal_stress", "released_energy")
CURVED = 1250  # blocks of structures whose cracks curve
PAPER = {"coarse": 130, "fine": 455}  # blocks of the paper's meshes
PAPER_SEEDS = range(1, 6)
THROUGH = {"cracks": [{"through_blocks": ["beam"], "begin": "automatic"}]}
PLACE = re.compile(r"crack (\d+) (?:has grown to|ends at) \(([^,]+), ([^)]+)\)")


def paths(run):
    """Places that each crack has grown to, by its number."""
    out = {}
    for line in run.log:
        found = PLACE.match(line.get("text", "")) if line["event"] == "grown" else None
        if found:
            out.setdefault(int(found[1]), []).append((float(found[2]), float(found[3])))
    return out


def row_of(done, **what):
    """What is kept of a run: its peak, the work put in and not stored over the dissipated energy, where it ended."""
    if done.exit_code not in (0, 3) or not done.run.summary.get("peak"):
        raise SystemExit(f"{what}: {done.said}")
    summary, last = done.run.summary, done.run.curve.iloc[-1]
    spent = last["external_work"] - last["stored_energy"]
    return what | {"blocks": summary["blocks"], "peak": summary["peak"]["load"], "steps": summary["steps"],
                   "work_over_spent": spent / last["dissipated_energy"], "dissipated": last["dissipated_energy"],
                   "end": last["load"] / summary["peak"]["load"], "status": summary["status"],
                   "reason": summary["reason"], "seconds": done.processor}


def run(job, folder):
    """One row of the results and the paths of its cracks."""
    what, deck, settings = job
    name = re.sub(r"\W+", "-", "-".join(str(value) for value in what.values()))
    done = study.measured(HERE / deck, Path(folder) / name, {"record.fields_every": 0} | settings)
    row = row_of(done, **what)
    places = [what | {"crack": crack, "x": x, "y": y} for crack, line in paths(done.run).items() for x, y in line]
    print(f"{what}: {row['peak']:.6g} N, {row['status']}, {row['seconds']:.1f} s", file=sys.stderr)
    return row, places


def beam_jobs(quick):
    for structure in patterns.BEAMS[:1] if quick else patterns.BEAMS:
        for size, blocks in list(patterns.SIZES.items())[:1 if quick else None]:
            for pattern in patterns.PATTERNS[::4] if quick else patterns.PATTERNS:
                what = {"structure": structure.name, "size": size, "pattern": pattern}
                yield what, f"{structure.name}.yaml", {
                    "scene.subdivision": patterns.subdivision(pattern, structure.area, blocks)}


def curved_jobs(quick):
    for structure in patterns.CURVED[:1] if quick else patterns.CURVED:
        for direction in DIRECTIONS:
            for pattern in patterns.FIVE[:1] if quick else patterns.FIVE:
                what = {"structure": structure.name, "direction": direction, "pattern": pattern}
                settings = {"scene.subdivision": patterns.subdivision(pattern, structure.area, 330 if quick else CURVED)}
                settings["cracks.0.direction"] = direction
                yield what, f"{structure.name}.yaml", settings


def second_order_jobs(quick):
    """The middle size, and curved cracks by stress, with blocks of second order."""
    structures = patterns.BEAMS + patterns.CURVED
    for structure in structures[:1] if quick else structures:
        chosen, blocks = (patterns.PATTERNS, patterns.SIZES["middle"]) if structure.reference else (patterns.FIVE, CURVED)
        for pattern in chosen[:1] if quick else chosen:
            what = {"structure": structure.name, "direction": DIRECTIONS[0], "pattern": pattern}
            yield what, f"{structure.name}.yaml", {
                "kinematics": "second_order",
                "scene.subdivision": patterns.subdivision(pattern, structure.area, 330 if quick else blocks)}


def paper_jobs(quick):
    """The beam of the paper as it is in kitoh-beam, between blocks and through them."""
    for blocks in list(PAPER.values())[:1 if quick else None]:
        for seed in PAPER_SEEDS:
            for way, settings in (("between blocks", {}), ("through blocks", THROUGH)):
                what = {"way": way, "blocks_asked": blocks, "seed": seed}
                size = {"scene.subdivision": {"type": "voronoi", "blocks": blocks, "seed": seed}}
                yield what, "../kitoh-beam/deck.yaml", size | settings


PARTS = {"beams": beam_jobs, "curved": curved_jobs, "second-order": second_order_jobs, "paper": paper_jobs}


def run_part(part, asked):
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(asked.jobs) as pool:
        done = list(pool.map(lambda job: run(job, folder), PARTS[part](asked.quick)))
    study.write_rows(asked.output / "results" / f"{part}.csv", [row for row, _ in done], digits=8)
    study.write_rows(asked.output / "results" / f"{part}-paths.csv", [place for _, line in done for place in line], digits=7)


def main():
    parser = study.parser(__doc__)
    parser.add_argument("--jobs", type=int, default=1, help="runs at a time")
    parser.add_argument("--only", nargs="*", choices=PARTS, default=list(PARTS), help="these parts; others as they are")
    parser.add_argument("--report", action="store_true", help="run nothing; figures and README from results/*.csv")
    asked = study.arguments(parser, HERE)
    for part in [] if asked.report else asked.only:
        run_part(part, asked)
    report.write(asked.output)


if __name__ == "__main__":
    main()
