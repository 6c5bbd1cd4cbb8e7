"""Runs random scenes of bodies in motion and judges each: it ends by rest or time, nothing crosses, its books close.

    motion_campaign.py PROGRAM [--count 100] [--seed 1] [--jobs 1] [--time-limit 120] [--keep FOLDER] [--shaken] [--classic]

--shaken has structures stand on a ground that swings, and prints how much energy impacts have given back at most.
--classic has them move by `integrator: classic`, without restitution; bodies may overlap then, by less than contacts reach.
Exit code 1 where some scene fails; each such scene is a line.
"""

import argparse
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

from ddapath import study  # noqa: E402
from ddapath.verify import verify  # noqa: E402
import moving_scenes  # noqa: E402
import shaken_structures  # noqa: E402

REACH = 0.025  # of the contacts of `classic`, in sizes of the smallest body: what is deeper in another passes through it


def moved_by(deck, integrator):
    deck["motion"] |= {"integrator": integrator, "contact": deck["motion"]["contact"] | {"restitution": 0}}


def is_refused(finding):
    return not finding.holds or ("overlap" in finding.check and finding.worst > REACH)


def judged(seed, folder, asked):
    """(seconds, what is wrong or "", what is special about the scene, the energy that impacts have given back over the largest)"""
    deck, what = (shaken_structures if asked.shaken else moving_scenes).scene_of(seed)
    if asked.classic:
        moved_by(deck, "classic")
    done = study.measured(deck, folder / str(seed), limit=asked.time_limit, program=asked.program)
    if done.exit_code != 0:
        return done.seconds, f"exit code {done.exit_code}: {done.said.strip()[-300:]}", what, 0.0
    findings = verify(done.run.folder)
    wrong = [f"{finding.check} {finding.worst:.1e} > {finding.bound:.0e} ({finding.place})" for finding in findings if is_refused(finding)]
    given_back = max((finding.worst for finding in findings if "give nothing back" in finding.check), default=0.0)
    return done.seconds, "; ".join(wrong), what, given_back


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda name: str(Path(name).resolve()))
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--time-limit", type=float, default=120)
    parser.add_argument("--keep", type=Path, help="keeps the runs here")
    parser.add_argument("--shaken", action="store_true", help="structures on a ground that swings")
    parser.add_argument("--classic", action="store_true", help="by discontinuous deformation analysis as it was published")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="ddapath-") as scratch, ThreadPoolExecutor(asked.jobs) as pool:
        folder = asked.keep or Path(scratch)
        seeds = range(asked.seed, asked.seed + asked.count)
        good, most = 0, 0.0
        for seed, (seconds, wrong, what, given_back) in zip(seeds, pool.map(lambda s: judged(s, folder, asked), seeds)):
            good += not wrong
            most = max(most, given_back)
            if wrong or seconds > asked.time_limit / 2:
                print(f"{seed}: {what}, {seconds:.0f} s: {wrong or 'slow'}", flush=True)
    print(f"{good} of {asked.count} scenes good; impacts have given back {most:.1e} of the largest energy at most")
    return 0 if good == asked.count else 1


if __name__ == "__main__":
    sys.exit(main())
