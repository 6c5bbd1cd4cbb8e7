"""Pictures one after another as a file: .gif by Pillow, .mp4 by ffmpeg. A picture is an array, height × width × 3 bytes."""

import shutil
import subprocess
from contextlib import contextmanager

import numpy as np
from PIL import Image

from ..errors import DdapathError, ToolMissing

COLOURS = 80  # of all pictures of a GIF together
CANDIDATES = 4000
CELL = 8      # of 256, the side of a cell of colours that are stored as one
NEAR = 24     # of 256, in one of red, green and blue
UNCHANGED = (255, 0, 254)  # the entry of the palette behind those; any colour that is in no picture
CENTISECONDS = 100


def most_frequent(pictures, colours):
    """These colours, and those that most pixels of the pictures have and none of the others is near to; k × 3."""
    codes = np.concatenate([(picture.astype(np.uint32) @ (65536, 256, 1)).ravel() for picture in pictures])
    found, count = np.unique(codes, return_counts=True)
    ranked = found[np.argsort(-count, kind="stable")[:CANDIDATES]].astype(int)
    chosen = np.asarray(colours, dtype=int)
    for colour in np.column_stack([ranked >> 16, ranked >> 8 & 255, ranked & 255]):
        if len(chosen) < COLOURS and np.abs(chosen - colour).max(axis=1).min() >= NEAR:
            chosen = np.vstack([chosen, colour])
    return chosen


def nearest(colours):
    """Which of the colours is nearest to the middle of each cell of the cube of all colours."""
    middle = np.arange(CELL // 2, 256, CELL)
    cube = np.stack(np.meshgrid(middle, middle, middle, indexing="ij"), axis=-1)
    distances = [((cube - colour) ** 2).sum(axis=-1) for colour in colours]
    return np.argmin(distances, axis=0).astype(np.uint8)


class Gif:
    """A film whose pictures stand for whole hundredths of a second, as the format has it.

    Its colours are those given and others of the samples. A picture is stored as what differs from the one before.
    """

    def __init__(self, file, fps, samples, colours):
        self._file, self._delay = file, self._delay_of(fps)
        colours = most_frequent(samples, colours)
        self._unchanged = len(colours)
        self._palette = [int(part) for colour in (*colours, UNCHANGED) for part in colour]
        self._nearest, self._last = nearest(colours), None
        self._pictures, self._delays = [], []

    @staticmethod
    def _delay_of(fps):
        """Between pictures [1/100 s]."""
        return round(CENTISECONDS / fps)

    @classmethod
    def true_fps(cls, fps):
        return CENTISECONDS / cls._delay_of(fps)

    def __enter__(self):
        return self

    def add(self, picture):
        cells = picture // CELL
        indices = self._nearest[cells[..., 0], cells[..., 1], cells[..., 2]]
        stored = indices if self._last is None else np.where(indices == self._last, np.uint8(self._unchanged), indices)
        image = Image.fromarray(stored, "P")
        image.putpalette(self._palette)
        self._pictures.append(image)
        self._delays.append(self._delay)
        self._last = indices

    def hold(self, seconds):
        """The last picture stays for so long more."""
        self._delays[-1] += round(CENTISECONDS * seconds)

    def __exit__(self, kind, *_):
        if kind is None:
            self._pictures[0].save(self._file, format="GIF", save_all=True, append_images=self._pictures[1:], loop=0,
                                   duration=[10 * delay for delay in self._delays], optimize=False, disposal=1,
                                   transparency=self._unchanged)


class Mp4:
    """A film in H.264 that any browser plays."""

    def __init__(self, file, fps, samples, _):
        height, width, _ = samples[0].shape
        self._fps, self._last = fps, None
        self._ffmpeg = subprocess.Popen(
            [self.program(), "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}",
             "-r", f"{fps:g}", "-i", "-", "-an", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "20", str(file)],
            stdin=subprocess.PIPE, stderr=subprocess.PIPE)

    @staticmethod
    def program():
        found = shutil.which("ffmpeg")
        if not found:
            raise ToolMissing("an .mp4 is written by ffmpeg, which is not installed: apt-get install ffmpeg; "
                              "or write a .gif, which needs nothing more")
        return found

    @classmethod
    def true_fps(cls, fps):
        cls.program()  # before anything is drawn
        return fps

    def __enter__(self):
        return self

    def add(self, picture):
        self._last = picture.tobytes()
        try:
            self._ffmpeg.stdin.write(self._last)
        except BrokenPipeError:
            raise DdapathError(f"ffmpeg has stopped: {self._said()}") from None

    def hold(self, seconds):
        for _ in range(round(seconds * self._fps)):
            self._ffmpeg.stdin.write(self._last)

    def _said(self):
        return self._ffmpeg.communicate()[1].decode(errors="replace").strip()

    def __exit__(self, kind, *_):
        if kind is not None:
            self._ffmpeg.kill()
            self._ffmpeg.wait()
            return
        said = self._said()
        if self._ffmpeg.returncode != 0:
            raise DdapathError(f"ffmpeg could not write the film: {said}")


MAKERS = {".gif": Gif, ".mp4": Mp4}


def maker_of(file):
    """Gif or Mp4, by what the file is called."""
    if file.suffix.lower() not in MAKERS:
        raise ValueError(f"{file}: an animation is called .gif or .mp4, not '{file.suffix}'")
    return MAKERS[file.suffix.lower()]


@contextmanager
def replaced(file):
    """A file beside, which takes the place of `file` when all is written; nothing is left of it otherwise."""
    part = file.with_name(f"{file.stem}.part{file.suffix}")
    part.touch()
    try:
        yield part
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)
