#!/usr/bin/env python3
"""Random walls, towers, piers, arches and gates of dry blocks that weight holds and a load brings down, against limit analysis.

    dry_masonry.py PROGRAM --count 40 --seed 1 [--control arc_length] [--windows] [--lifted] [--folder DIR]

With `--windows` walls of bricks around an opening, on Gauss points too. With `--lifted` a part of the load that brings them down is held
while another lifts them, which does no work on what slides level.
Nothing is wanted of a gauge: a path ends where the blocks have become a mechanism. No load beyond that of the linear program
of rigid blocks (`limit_analysis.py`) is in equilibrium; and where in that mechanism nothing slides but what parts as well, no
mechanism goes on under less, so that it is reached, both to 1e-6. What its own weight brings down stops early. Printed is a line
for each that is wrong, and how many are right; exit code 1 when one is wrong.
"""
import math
import os
import random
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS.parent / "python"), str(TESTS / "robustness")]

import numpy as np

import ddapath  # noqa: E402
from campaign import campaign_parser  # noqa: E402
from contact_scenes import TREATMENTS, rectangle, region  # noqa: E402
from ddapath.verify import verify  # noqa: E402
from limit_analysis import collapse_factor, contact_points, weight, wrench  # noqa: E402

TOLERANCE = 1e-6
WEIGHT = 20.0  # per volume [kN/m³]


@dataclass
class Masonry:
    """Blocks, anticlockwise; the first `feet` of them are held."""

    blocks: list
    feet: int
    friction: float
    load: dict
    live: list  # wrenches of the load
    points: str = "vertices"
    held: float = 0  # factor of a load before, which stays

    @property
    def problem(self):
        dead = [weight(block, (0, -WEIGHT), 1) for block in self.blocks]
        if self.held:
            lift = [weight(block, (0, WEIGHT), 1) for block in self.blocks]
            return self.blocks, set(range(self.feet)), ([own + self.held * live for own, live in zip(dead, self.live)], lift), self.friction, self.points
        return self.blocks, set(range(self.feet)), (dead, self.live), self.friction, self.points


def wall(choose):
    rows, width, height = choose.randint(2, 6), choose.uniform(1, 4), choose.uniform(0.2, 0.6)
    blocks = [rectangle(0, -0.3, width, 0)]
    for row in range(rows):
        bricks = choose.randint(1, 4)
        parts = [choose.uniform(0.4, 1) for _ in range(bricks)]
        ends = [width * sum(parts[:i]) / sum(parts) for i in range(bricks + 1)]
        blocks += [rectangle(a, row * height, b, (row + 1) * height) for a, b in zip(ends, ends[1:])]
    return blocks, 1


def pier(choose):
    """Courses that become narrower and lean."""
    left, width, level = 0.0, choose.uniform(0.5, 2), 0.0
    blocks = [rectangle(left, -0.3, left + width, 0)]
    for _ in range(choose.randint(2, 7)):
        height = choose.uniform(0.2, 0.6)
        blocks.append(rectangle(left, level, left + width, level + height))
        level += height
        left += choose.uniform(0, 0.1) * width
        width *= choose.uniform(0.8, 0.9)
    return blocks, 1


def arch(choose, posts=0):
    """Voussoirs between skewbacks, or on posts of square courses."""
    inner, thick = choose.uniform(1, 3), choose.uniform(0.25, 0.7)
    count, lift = choose.randint(5, 13), 0.0 if posts else choose.uniform(0, 0.6)

    def ring(first, last):
        rays = [(math.cos(a), math.sin(a)) for a in (first, last)]
        return [[radius * x, posts + radius * y] for radius, (x, y) in
                ((inner, rays[0]), (inner + thick, rays[0]), (inner + thick, rays[1]), (inner, rays[1]))]

    angles = [lift + (math.pi - 2 * lift) * i / count for i in range(count + 1)]
    voussoirs = [ring(*pair) for pair in zip(angles, angles[1:])]
    if not posts:
        return [ring(lift - 0.2, lift), ring(math.pi - lift, math.pi - lift + 0.2), *voussoirs], 2
    broad = thick + choose.uniform(0.2, 0.9)
    levels = [-0.3, *range(posts + 1)]
    courses = [rectangle(left, low, left + broad, high) for low, high in zip(levels, levels[1:]) for left in (inner, -inner - broad)]
    return courses + voussoirs, 2


def gate(choose):
    return arch(choose, posts=choose.randint(1, 4))


@dataclass
class Opening:
    """Of a wall: between these ends of bricks, from this course on up to the one of the lintel, which rests on a brick on
    either side."""

    first: int
    last: int
    low: int
    lintel: int

    def of_course(self, row):
        """What is left out of a course of bricks."""
        if row == self.lintel:
            return self.first - 1, self.last + 1
        return (self.first, self.last) if self.low <= row < self.lintel else (0, 0)


def running_bond(columns, rows, opening, length, height):
    """Bricks and the lintel of a wall, course by course."""
    blocks = []
    for row in range(rows):
        shift = 0.5 if row % 2 else 0
        ends = [0, *(i + shift for i in range(0 if row % 2 else 1, columns)), columns]
        left, right = opening.of_course(row)
        parts = [(a, b) for start, end in zip(ends, ends[1:]) for a, b in ((start, min(end, left)), (max(start, right), end)) if b > a]
        if row == opening.lintel:
            parts.append((left, right))
        blocks += [rectangle(a * length, row * height, b * length, (row + 1) * height) for a, b in parts]
    return blocks


def windowed(choose):
    """A wall in running bond around an opening under a lintel."""
    length, height = 0.3, 0.1
    columns, rows = choose.randint(5, 7), choose.randint(5, 9)
    first, low = choose.randint(1, columns - 3), choose.randint(1, rows - 3)
    opening = Opening(first, min(columns - 1, first + choose.randint(1, 3)), low, min(rows - 2, low + choose.randint(1, 4)))
    ground = rectangle(-0.5, -0.3, columns * length + 0.5, 0)
    return [ground, *running_bond(columns, rows, opening, length, height)], 1


def loaded(choose, blocks, feet):
    """The load of the deck, and what it is on each block."""
    angle = math.radians(choose.choice([0, 0, 180, choose.uniform(-60, 60), choose.uniform(120, 240)]))
    force = [WEIGHT * math.cos(angle), WEIGHT * math.sin(angle)]
    if choose.random() < 0.6:
        return {"type": "body_force", "force": force, "materials": ["stone"]}, [weight(block, force, 1) for block in blocks]
    sides = [(start, end, i) for i, block in enumerate(blocks[feet:], feet) for start, end in zip(block, block[1:] + block[:1])]
    inner = {(tuple(end), tuple(start)) for start, end, _ in sides}
    outer = [side for side in sides if (tuple(side[0]), tuple(side[1])) not in inner]
    start, end, struck = max(outer, key=lambda side: side[0][1] + side[1][1])
    middle = [(a + b) / 2 for a, b in zip(start, end)]
    live = [wrench(force if i == struck else (0, 0), middle) for i in range(len(blocks))]
    return {"type": "point_load", "over": [start, end], "force": force}, live


def masonry(seed, control="staged", windows=False):
    """A random structure, and the deck of it."""
    choose = random.Random(seed)
    blocks, feet = windowed(choose) if windows else choose.choice([wall, pier, arch, gate])(choose)
    degrees = choose.choice([15, 25, 30, 35, 40, 50, 60])
    load, live = loaded(choose, blocks, feet)
    joint = {"law": {"type": "friction", "friction_angle": degrees}, "points": "vertices", "treatment": choose.choice(TREATMENTS)}
    elastic = {"type": "linear_elastic", "young_modulus": 10 ** choose.uniform(5, 8)}
    if windows:
        joint["points"] = choose.choice(["gauss", "vertices"])
    deck = {"units": {"length": "m", "force": "kN"}, "thickness": 1,
            "scene": {"regions": [region(f"b{i}", "foot" if i < feet else "stone", block) for i, block in enumerate(blocks)],
                      "boundaries": {f"foot{i}": lower_side(blocks[i]) for i in range(feet)}, "subdivision": {"type": "given"}},
            "materials": {"stone": elastic, "foot": elastic},
            "interfaces": {"joint": {"between": ["stone", "stone"], **joint}, "bed": {"between": ["stone", "foot"], **joint}},
            "supports": {f"foot{i}": {"boundary": f"foot{i}", "fix": "xy"} for i in range(feet)},
            "stages": [{"name": "weight", "loads": [{"type": "body_force", "force": [0, -WEIGHT], "materials": ["stone"]}]},
                       {"name": "load", "loads": [load]}],
            "path": {"control": control}, "record": {"fields_every": 1}}
    return Masonry(blocks, feet, math.tan(math.radians(degrees)), load, live, joint["points"]), deck


def lifted(structure, deck, seed):
    """Makes the load a held one, at a share of what brings the structure down, and lifts it; as it was where nothing brings it down."""
    try:
        most = collapse_factor(*structure.problem)
    except ValueError:
        return
    if np.isinf(most) or most == 0:
        return
    structure.held = random.Random(seed).uniform(0.2, 0.9) * most
    deck["stages"][-1]["until"] = {"load_factor": structure.held}
    deck["stages"].append({"name": "lift", "loads": [{"type": "body_force", "force": [0, WEIGHT], "materials": ["stone"]}]})


def lower_side(block):
    """Of a foot the side on which nothing stands."""
    sides = list(zip(block, block[1:] + block[:1]))
    return list(map(list, min(sides, key=lambda side: side[0][1] + side[1][1])))


def motions(run, step):
    """Of every block the coefficients of 1, x, y in its displacement, 3 × 2."""
    out = []
    for _, corners in run.fields(step).vertices.groupby(level="block"):
        places = np.column_stack([np.ones(len(corners)), corners[["x", "y"]]])
        out.append(np.linalg.lstsq(places, corners[["displacement_x", "displacement_y"]].to_numpy(), rcond=None)[0])
    return out


def turns_about_hinges(structure, run):
    """Whether in the last step every contact point that slides parts, too: the flow rule of limit analysis."""
    hardly = 1e-6  # of what moves farthest
    before, after = (motions(run, step) for step in run.steps[-2:])
    moved = [there - here for here, there in zip(before, after)]
    ways = []
    for one, other, place, normal in contact_points(structure.blocks, structure.points):
        way = np.array([1, *place]) @ (moved[other] - moved[one])
        ways.append((way @ normal, abs(way @ [-normal[1], normal[0]])))
    parting, sliding = np.array(ways).T
    farthest = np.abs(ways).max()
    return bool((parting > -hardly * farthest).all() and ((parting >= structure.friction * sliding) | (sliding < hardly * farthest)).all())


def what_is_wrong(structure, run):
    """"" for a run that limit analysis agrees with and the checker holds with."""
    refused = [finding.check for finding in verify(run.folder) if not finding.holds]
    if refused:
        return f"refused: {', '.join(refused)}"
    status, reason = run.summary["status"], run.summary["reason"]
    try:
        most = collapse_factor(*structure.problem)
    except ValueError:
        return "" if status == "stopped_early" and "cannot be carried" in reason else f"stands although its weight is too much: {reason}"
    curve = run.curve
    found = (curve[curve.stage == 3] if structure.held else curve)["load_factor"].max()
    if found > most * (1 + TOLERANCE):
        return f"bears {found:.9g}, more than the {most:.9g} of limit analysis"
    if np.isinf(most):
        return ""
    if status != "goal_reached":
        return reason
    if turns_about_hinges(structure, run) and found < most * (1 - TOLERANCE):
        return f"bears {found:.9g} of the {most:.9g} of limit analysis: {reason}"
    return ""


def main():
    parser = campaign_parser(__doc__, count=40, seed=1)
    parser.add_argument("--windows", action="store_true", help="walls of bricks around an opening")
    parser.add_argument("--lifted", action="store_true", help="a part of the load is held, and they are lifted")
    asked = parser.parse_args()
    os.environ["DDA"] = asked.program
    right = 0
    with tempfile.TemporaryDirectory() as scratch:
        for seed in range(asked.seed, asked.seed + asked.count):
            structure, deck = masonry(seed, asked.control, asked.windows)
            if asked.lifted:
                lifted(structure, deck, seed)
            run = ddapath.run(deck, folder=(asked.folder or Path(scratch)) / str(seed), overwrite=True, check=False)
            wrong = what_is_wrong(structure, run)
            right += not wrong
            if wrong:
                print(f"{seed}: {len(structure.blocks)} blocks, {deck['interfaces']['joint']['treatment']}: {wrong}", flush=True)
    print(f"{right} of {asked.count} are right")
    return 0 if right == asked.count else 1


if __name__ == "__main__":
    sys.exit(main())
