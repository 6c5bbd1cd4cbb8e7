"""`dda animate RUN`, or `python -m ddapath.animation RUN`: the motion of a run as a GIF or MP4."""
import sys

from ..commands import Parser, exit_code, number
from ..run_folder import read_run
from . import Wishes, animate


def parser():
    out = Parser(prog="dda animate", description=__doc__)
    out.add_argument("run", help="the run folder")
    out.add_argument("--out", "--output", help="the file, .gif or .mp4 (which needs ffmpeg); by default motion.gif in the folder")
    out.add_argument("--fps", type=number, default=20, help="pictures per second, from 1 to 50; by default 20")
    out.add_argument("--speed", type=number, help="seconds of motion per second of film; by default a round number")
    out.add_argument("--path", action="store_true", help="before it the path")
    out.add_argument("--magnify", type=number, help="how many times displacements of the path are magnified")
    return out


def main(arguments):
    asked = parser().parse_args(arguments)

    def work():
        file = animate(read_run(asked.run), asked.out, Wishes(asked.fps, asked.speed, asked.path, asked.magnify))
        return f"{file}: {file.stat().st_size / 1e6:.2g} MB"

    return exit_code("dda animate", work)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
