"""What an evaluation of a law costs that is a plugin's or Python's, over that of the program's own law of the same curve.

    law_cost.py BUILD [--runs N] [--write]

BUILD is a folder of a build; the plugin is examples/plugin, compiled against an installation of it. Prints a Markdown table, which
--write puts into docs/manual/plugins.md. An evaluation is the traction and the tangent at an opening, its acceptance and the damage
(`ddapath.respond`); a path has everything else in it, too. Ratios are those of the shortest of runs that alternate, in one process
with one thread.
"""

import argparse
import os
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("python", "tests/python", "tests/install")]
os.environ["OMP_NUM_THREADS"] = "1"

import numpy as np  # noqa: E402

import ddapath  # noqa: E402
from ddapath import study  # noqa: E402

PAGE = ROOT / "docs/manual/plugins.md"
STRENGTH, ENERGY = 3.0, 0.05  # [N/mm², N/mm]
STIFFNESS = 1e5  # of the trial spring [N/mm³]
STEPS = 20  # of a path; the sizes of later ones follow last digits
COMPARED = ("load_factor", "load", "dissipated_energy", "stored_energy")


@dataclass(frozen=True)
class Candidate:
    """A law of one curve, and how many openings make a measurement of some tenths of a second."""

    told: str
    law: dict
    openings: int


def candidates():
    curve = {"tensile_strength": STRENGTH, "fracture_energy": ENERGY}
    return (Candidate("the program's, `linear_softening`", {"type": "linear_softening", **curve}, 1_000_000),
            Candidate("a plugin's `SofteningShape`", {"type": "straight_softening", **curve}, 1_000_000),
            Candidate("a `SofteningCurve` in Python", {"type": "straight", **curve}, 10_000),
            Candidate("an `InterfaceLaw` in Python", {"type": "whole", "ft": STRENGTH, "energy": ENERGY}, 10_000))


def openings(count):
    """Opened in ten cycles beyond its rupture, sliding beside: n × 2 [mm]."""
    along = np.linspace(0, 1, count)
    normal = 1.2 * 2 * ENERGY / STRENGTH * along * (0.8 + 0.2 * np.cos(20 * np.pi * along))
    return np.column_stack([normal, 0.3 * normal])


def seconds_of(work):
    begin = time.perf_counter()
    result = work()
    return time.perf_counter() - begin, result


def followed(law):
    """A path of the plugin's deck with a law, as rows of the compared columns."""
    deck = ddapath.read_deck(ROOT / "examples/plugin/deck.yaml")
    deck["interfaces"]["joints"]["law"] = law
    return [[getattr(point, name) for name in COMPARED] for point in ddapath.follow(deck, {"path.stop.after_steps": STEPS})]


def difference(mine, theirs):
    """The largest of two curves, over the largest value of its column."""
    mine, theirs = np.array(mine), np.array(theirs)
    return float((np.abs(mine - theirs) / np.abs(theirs).max(axis=0)).max())


def measured(runs, share):
    """Of each candidate seconds an evaluation, seconds a path, and its curve; `share` of the openings are taken."""
    found = [([], [], []) for _ in candidates()]
    for _ in range(runs):
        for (evaluations, paths, curves), one in zip(found, candidates()):
            count = max(100, int(share * one.openings))
            evaluations.append(seconds_of(lambda: ddapath.respond(one.law, openings(count), STIFFNESS))[0] / count)
            seconds, curve = seconds_of(lambda: followed(one.law))
            paths.append(seconds)
            curves.append(curve)
    return found


def table(runs=9, share=1.0):
    """Lines of Markdown; the plugin has been loaded."""
    import test_laws  # noqa: F401  registers the laws in Python

    found = measured(runs, share)
    lines = ["| law | an evaluation | of a path | the curve differs by |", "|---|---|---|---|"]
    own = found[0]
    for one, (evaluations, paths, curves) in zip(candidates(), found):
        ratios = [min(mine) / min(theirs) for mine, theirs in ((evaluations, own[0]), (paths, own[1]))]
        lines.append(f"| {one.told} | {ratios[0]:.2g} | {ratios[1]:.2g} | {difference(curves[0], own[2][0]):.1g} |")
    lines.append(f"\n1 is {1e6 * min(own[0]):.2g} µs an evaluation, {min(own[1]):.2g} s for the first "
                 f"{STEPS} steps of the beam of the example.")
    return "\n".join(lines)


def load(library):
    """Makes the laws of a plugin known to this process."""
    from ddapath.compiled import core

    core().load_plugin(str(library))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="the folder of a build")
    parser.add_argument("--runs", type=int, default=9, help="of each law (default 9)")
    parser.add_argument("--write", action="store_true", help=f"into {PAGE.relative_to(ROOT)}")
    return parser.parse_args()


def main():
    asked = arguments()
    os.environ["BUILD"] = str(asked.build.resolve())
    from installation import built_plugin, install

    with tempfile.TemporaryDirectory(prefix="ddapath-") as folder:
        prefix = install(Path(folder) / "prefix")
        os.environ["DDA"] = str(prefix / "bin/dda")
        load(built_plugin(prefix, Path(folder) / "plugin"))
        text = table(asked.runs)
    print(text)
    if asked.write:
        study.write_region(PAGE, text, "cost of a law")


if __name__ == "__main__":
    sys.exit(main())
