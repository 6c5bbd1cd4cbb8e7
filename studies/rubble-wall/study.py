"""A wall of rubble from a picture, pushed sideways until it fails: how much it bears, against statics.

    study.py --program DDA [--quick] [--output FOLDER]

wall.jpg, wall.yaml, wall.svg, results/limits.csv and the marked region of README.md into FOLDER: this folder, or with --quick
runs/rubble-wall. Exit code 1 where a number is beyond its bound.
"""

import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "python"), str(HERE.parent / "masonry-in-motion")]

import figures  # noqa: E402
import picture  # noqa: E402
import statics  # noqa: E402
from ddapath import deck as decks  # noqa: E402
from ddapath import scenes, study  # noqa: E402
from ddapath.scenes.image import Wishes  # noqa: E402

WIDTH, SHAPE, STONES, SEED = 1.2, (320, 240), 24, 1  # m; pixels
COLOURS = {"mortar": "#dcd4c4", "stone": "#706860"}
WISHES = Wishes(smooth=0.005, least_area=0.005, tolerance=0.012)
STONE = {"type": "linear_elastic", "young_modulus": 1e10, "poisson_ratio": 0.2, "density": 2200}
GRAVITY = 9.81
FRICTIONS = (0.3, 0.7, 1.0, 2.0)
SHOWN = 0.7
BOUND = 1e-3


def wall_of(file):
    """The stones of the picture on a ground that is half a metre broader."""
    scene = scenes.scene_of_image(file, WIDTH, materials=COLOURS, joint="mortar", wishes=WISHES)
    low, high = -0.5, WIDTH + 0.5
    ground = {"name": "ground", "material": "ground", "vertices": [[low, -0.3], [high, -0.3], [high, 0], [low, 0]]}
    return {**scene, "regions": [ground, *scene["regions"]], "boundaries": {"ground": [[low, -0.3], [high, -0.3]]}}


def deck_of(scene):
    """Weight, then a push of λ times the weight on every stone; where the path ends the wall is let go under it."""
    weight = STONE["density"] * GRAVITY
    law = {"type": "friction", "friction_angle": "atan(mu)*180/pi"}
    joints = {name: {"between": ["stone", other], "law": law, "points": "vertices"} for name, other in (("joints", "stone"), ("foot", "ground"))}
    top = max((corner for region in scene["regions"] for corner in region["vertices"]), key=lambda corner: (corner[1], corner[0]))
    loads = [[{"type": "body_force", "materials": ["stone"], "force": force}] for force in ([0, -weight], [weight, 0])]
    return {"title": "A wall of rubble, pushed sideways", "units": {"length": "m", "force": "N"}, "variables": {"mu": SHOWN},
            "scene": scene, "thickness": 1, "plane": "stress", "materials": {"stone": STONE, "ground": STONE}, "interfaces": joints,
            "supports": {"ground": {"boundary": "ground", "fix": "xy"}},
            "stages": [{"name": "weight", "loads": loads[0]}, {"name": "push", "loads": loads[1]}],
            "gauges": {"top": {"type": "displacement", "at": top, "direction": [1, 0]}},
            "path": {"stop": {"gauges": {"top": 0.01}}, "then": "motion"},
            "motion": {"held": ["ground"], "time": 1, "contact": {"friction": "mu"}}}


def moving_stones(run):
    """Names of the regions of stones that go along with the top at the end of the path."""
    blocks = run.fields(run.steps[-1]).blocks
    names = [region["name"] for region in run.deck["scene"]["regions"]]
    return [names[region] for region, way in zip(blocks.region, blocks.displacement_x) if way > 0.1 * blocks.displacement_x.max()]


def row(run, blocks, friction):
    """What a wall bears by the path, at most by statics, and by a turn of what moves."""
    moving = moving_stones(run)
    return {"friction": friction, "statics": statics.largest_push(blocks, ["ground"], friction), "moving": len(moving),
            "turning": statics.turns_over(blocks, moving), "found": float(run.curve.load_factor.max())}


def is_sound(limit):
    """No more than statics allows; where stones turn as one, as much as that takes, and where they slide, as much as statics
    allows. At the friction that is shown they do some of both, and neither tells what is borne."""
    found = limit["found"]
    nearest = min(abs(found / limit[name] - 1) for name in ("statics", "turning"))
    return found <= limit["statics"] * (1 + BOUND) and (nearest <= BOUND or limit["friction"] == SHOWN)


def table_of(rows, scene):
    lines = [f"{len(scene['regions']) - 1} stones.", "", "| friction μ | at most, by statics | a turn of the stones that move | found |",
             "|---|---|---|---|"]
    lines += [f"| {limit['friction']:g} | {limit['statics']:.4f} | {limit['turning']:.4f} ({limit['moving']} stones) | {limit['found']:.4f} |"
              for limit in rows]
    return "\n".join(lines)


def main():
    asked = study.arguments(study.parser(__doc__), HERE)
    picture.draw(asked.output / "wall.jpg", STONES, SHAPE, SEED)
    scene = wall_of(asked.output / "wall.jpg")
    (asked.output / "wall.yaml").write_text(decks.lines(deck_of(scene), schema="../../deck.schema.json"), encoding="utf-8")
    blocks = {region["name"]: region["vertices"] for region in scene["regions"]}
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch:
        run, rows = study.Runs(scratch), []
        for friction in FRICTIONS[:1] if asked.quick else FRICTIONS:
            is_shown = friction == SHOWN
            done = run(f"mu-{friction}", asked.output / "wall.yaml", {"variables.mu": friction} | ({} if is_shown else {"path.then": "end"}))
            rows.append(row(done, blocks, friction))
            if is_shown:
                figures.draw(asked.output, scene, done)
    study.write_rows(asked.output / "results" / "limits.csv", rows, digits=6)
    study.write_region(asked.output / "README.md", table_of(rows, scene))
    beyond = [limit for limit in rows if not is_sound(limit)]
    for limit in beyond:
        print(f"beyond its bound: {limit}", file=sys.stderr)
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main())
