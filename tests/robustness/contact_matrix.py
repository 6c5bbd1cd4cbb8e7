#!/usr/bin/env python3
"""The contact matrix: meshes x treatments x friction angles x scenes, with default settings; see README.md.

    contact_matrix.py --write DIR [--only TEXT]            write all decks as DIR/NAME.yaml, with expected.json
    contact_matrix.py --run PROGRAM [--only TEXT] [...]    run them and print a row per case
"""
import argparse
import json
import sys
import tempfile
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(__file__).resolve().parent))

from contact_scenes import ANGLES, MESHES, TREATMENTS, block_pressed, block_pushed, plate_inclined, plate_pressed  # noqa: E402
from contact_structures import (  # noqa: E402
    FADING_MORTAR, SLENDER, brittle_wall, dry_wall, dry_wall_of_bricks, end_notched_flexure, plates_on_beam, slender, wall_of_mortar)
from masonry_structures import ARCHES, TRILITHS, arch_leaning, arch_loaded, trilith, wall_with_door  # noqa: E402
from matrix_runner import print_rows, run_cases  # noqa: E402

SCENES = (block_pushed, block_pressed, plate_pressed, plates_on_beam, dry_wall, end_notched_flexure)
COEFFICIENTS = (0.2, 0.4, 0.75, 1.2, 1.5)
UNITS = (1e-3, 1e3)
MORTAR_WALLS = (*((rows, "consistent", 0.3, mu) for rows in (5, 8, 15) for mu in (0.4, 0.75)),
                *((rows, "consistent", 1.0, 0.75) for rows in (8, 15)), *((rows, "penalty", 0.3, 0.75) for rows in (5, 8, 15)))


def all_cases():
    """Every case, those that end soonest first."""
    grid = [(mesh, treatment, angle) for mesh in MESHES for treatment in TREATMENTS for angle in ANGLES]
    cases = [dry_wall_of_bricks(t, mu) for t in TREATMENTS for mu in COEFFICIENTS]
    cases += [trilith(height, t) for height in TRILITHS for t in TREATMENTS]
    cases += [arch(*shape, t) for arch in (arch_loaded, arch_leaning) for shape in ARCHES for t in TREATMENTS]
    cases += [wall_of_mortar(*wall) for wall in MORTAR_WALLS]
    cases += [wall_of_mortar(3, "consistent", 0.069, 0.84, FADING_MORTAR, "mortar_wall_fading"),
              brittle_wall(), wall_with_door()]
    cases += [block_pushed("given", t, a, unit) for t in TREATMENTS for a in ANGLES for unit in (1.0, *UNITS)]
    cases += [scene(*place) for scene in SCENES for place in grid]
    cases += [plate_inclined(*place) for place in grid if place[2] >= 10]
    return cases + [slender(*place, cells) for cells in SLENDER for place in grid]


def chosen(texts, without=()):
    """Cases whose name holds every one of `texts` and none of `without`."""
    return [case for case in all_cases()
            if all(text in case.name for text in texts) and not any(text in case.name for text in without)]


def write(cases, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for case in cases:
        text = yaml.safe_dump(case.deck, sort_keys=False, default_flow_style=None, width=120)
        (folder / f"{case.name}.yaml").write_text(text, encoding="utf-8")
    expected = {case.name: {"expected": case.expected, "rejected": case.rejected} for case in cases}
    (folder / "expected.json").write_text(json.dumps(expected, indent=1) + "\n", encoding="utf-8")


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", type=Path, metavar="DIR", help="write the decks and expected.json")
    parser.add_argument("--run", metavar="PROGRAM", help="run the decks with this program")
    parser.add_argument("--only", action="append", default=[], metavar="TEXT", help="cases whose name holds it, and each further one given")
    parser.add_argument("--without", action="append", default=[], metavar="TEXT",
                        help="no cases whose name holds it; may be repeated")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--time-limit", type=float, default=300, help="processor seconds that a run may take")
    parser.add_argument("--folder", type=Path, help="where runs are kept; nowhere if not given")
    parser.add_argument("--csv", type=Path, help="the rows as a file")
    arguments = parser.parse_args()
    if not arguments.write and not arguments.run:
        parser.error("give --write DIR or --run PROGRAM")
    return arguments


def main():
    arguments = read_arguments()
    cases = chosen(arguments.only, arguments.without)
    if arguments.write:
        write(cases, arguments.write)
        print(f"{len(cases)} decks in {arguments.write}")
    if not arguments.run:
        return 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.folder or Path(scratch)
        write(cases, folder)
        rows = run_cases(cases, folder, arguments)
    return print_rows(rows, arguments.csv)


if __name__ == "__main__":
    sys.exit(main())
