"""A run as an animation, GIF or MP4: `dda animate RUN`, or

    run = ddapath.read_run("runs/falling-beam")
    run.animate("beam.gif")                                     # at a speed that makes some eight seconds of it
    run.animate("beam.mp4", fps=25, speed=0.01, path=True)      # the path first; 100 times slower than true

Blocks are drawn at true scale, by material, what never moves hatched; beside them the energy book, up to the instant that is
shown. Between stored states blocks turn and move evenly. The path goes along the curve of load against deflection; its
blocks are those of the nearest stored step, displacements magnified, cracks as lines.
"""
from dataclasses import dataclass
from pathlib import Path

from ..errors import ToolMissing
from . import film
from .motion_reel import MotionReel
from .path_reel import PathReel
from .stage import Stage, together, used_colours

__all__ = ["ToolMissing", "Wishes", "animate"]

MOST_PICTURES = 3000
REST = 1.5  # how long the last picture of a reel stands [s]


@dataclass(frozen=True)
class Wishes:
    """fps: pictures per second. speed: seconds of motion per second of film. magnification: of displacements on the path,
    1 is true. None: a round number. path: whether the path comes first, or alone where nothing has moved."""

    fps: float = 20
    speed: float | None = None
    path: bool = False
    magnification: float | None = None

    def __post_init__(self):
        if not 1 <= self.fps <= 50:
            raise ValueError(f"fps is from 1 to 50, not {self.fps:g}")
        for name in ("speed", "magnification"):
            value = getattr(self, name)
            if value is not None and not 0 < value < float("inf"):
                raise ValueError(f"{name} is a number above 0, not {value:g}")


def reels_of(run, wishes, fps):
    """What is shown one after another."""
    reels = [PathReel(run, wishes.magnification, fps)] if wishes.path else []
    if not wishes.path or (run.folder / "motion").is_dir():
        reels.append(MotionReel(run, wishes.speed, fps))
    count = sum(reel.count for reel in reels)
    if count > MOST_PICTURES:
        raise ValueError(f"that would be {count} pictures; at most {MOST_PICTURES}: raise the speed or lower fps")
    return reels


def animate(run, file=None, wishes=Wishes()):
    """Writes the animation of a Run, by default as motion.gif in its folder, and gives the file's path.

    Throws NothingStored where nothing has moved, ValueError for a file that is neither .gif nor .mp4 or for wishes that
    cannot be, ToolMissing for an .mp4 without ffmpeg, OSError where the file cannot be written.
    """
    file = Path(file) if file is not None else run.folder / "motion.gif"
    make = film.maker_of(file)
    reels = reels_of(run, wishes, make.true_fps(wishes.fps))
    stage = Stage(together([reel.box for reel in reels]), run.deck.get("title", ""))
    pictures = list(samples(reels, stage))
    with film.replaced(file) as part, make(part, wishes.fps, pictures, used_colours()) as strip:
        for reel in reels:
            reel.begin(stage)
            for k in range(reel.count):
                reel.show(stage, k)
                strip.add(stage.picture())
            strip.hold(REST)
    return file


def samples(reels, stage):
    """The last picture of every reel."""
    for reel in reels:
        reel.begin(stage)
        reel.show(stage, reel.count - 1)
        yield stage.picture()
