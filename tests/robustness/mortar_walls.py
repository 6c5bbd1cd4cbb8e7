#!/usr/bin/env python3
"""Random walls of mortar joints, pressed, pushed and pushed back until they rock the other way, each run and verified.

    mortar_walls.py PROGRAM --count 60 --seed 500 [--control arc_length] [--treatment penalty] [--folder DIR]

A seed is a wall: pressure, size of bricks, law and points of the joints (`random_wall` of tests/program/test_mortar_walls.py).
Printed is a line for each that does not arrive, and how many do; where displacement control stops the drift snaps back, which
`--control staged` shows. Exit code 1 when one stops for another reason, or `dda verify` refuses one.
"""
import os
import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS.parent / "python"), str(TESTS / "program")]

import ddapath  # noqa: E402
from campaign import campaign_parser  # noqa: E402
from ddapath.verify import verify  # noqa: E402
from test_mortar_walls import random_wall  # noqa: E402


def arguments():
    parser = campaign_parser(__doc__, count=60, seed=500)
    parser.add_argument("--treatment", help="of the joints")
    return parser.parse_args()


def what_is_wrong(deck, folder):
    """"" for a wall that arrives and that the checker holds with."""
    run = ddapath.run(deck, folder=folder, overwrite=True, check=False)
    refused = [finding.check for finding in verify(run.folder) if not finding.holds]
    if refused:
        return f"refused: {', '.join(refused)}"
    return "" if run.summary["status"] == "goal_reached" else run.summary["reason"]


def main():
    asked = arguments()
    os.environ["DDA"] = asked.program
    arrived, is_broken = 0, False
    with tempfile.TemporaryDirectory() as scratch:
        for seed in range(asked.seed, asked.seed + asked.count):
            deck = random_wall(seed, [asked.control])
            if asked.treatment:
                for joint in deck["interfaces"].values():
                    joint["treatment"] = asked.treatment
            wrong = what_is_wrong(deck, (asked.folder or Path(scratch)) / str(seed))
            arrived += not wrong
            is_broken |= bool(wrong) and not (asked.control == "displacement" and "snaps back" in wrong)
            if wrong:
                print(f"{seed}: {wrong}", flush=True)
    print(f"{arrived} of {asked.count} arrive")
    return 1 if is_broken else 0


if __name__ == "__main__":
    sys.exit(main())
