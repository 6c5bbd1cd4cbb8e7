"""The beam that cracks, snaps back, breaks and falls: its pictures, one strip and one animation.

    study.py --program DDA [--quick] [--output FOLDER]

collapse.svg and collapse.gif into FOLDER: this folder, or with --quick, on larger blocks, runs/falling-beam. A run that
`dda verify` refuses is not drawn.
"""

import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))

import strip  # noqa: E402
from ddapath import study  # noqa: E402
from ddapath.animation import Wishes, animate  # noqa: E402
from ddapath.verify import verify  # noqa: E402

QUICK = {"scene.subdivision.size": 250, "motion.time": 0.2}


def main():
    asked = study.arguments(study.parser(__doc__), HERE)
    with tempfile.TemporaryDirectory() as scratch:
        done = study.measured(HERE / "collapse.yaml", Path(scratch) / "collapse", QUICK if asked.quick else None)
        if done.exit_code != 0:
            raise SystemExit(f"collapse: exit code {done.exit_code}: {done.said}")
        refused = [finding.check for finding in verify(done.run.folder) if not finding.holds]
        if refused:
            raise SystemExit(f"collapse: refused: {', '.join(refused)}")
        strip.draw(done.run, asked.output / "collapse.svg")
        animate(done.run, asked.output / "collapse.gif", Wishes(fps=5 if asked.quick else 8, path=True))


if __name__ == "__main__":
    main()
