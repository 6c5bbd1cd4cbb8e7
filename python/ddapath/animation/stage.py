"""The figure that is filmed: blocks, a plot beside or below them, a title and a line that says what is shown."""

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

# Okabe & Ito, Color Universal Design (2008), as in all figures of the program
PALETTE = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
INK, CRACK = "#222222", "#D55E00"
HELD_FILL, HELD_HATCH = "#efefef", "#b5b5b5"
LIGHT = 0.62   # share of white in the colour of a block
YET_TO_COME = 0.25  # opacity
GREYS = 9      # of edges on white
MARGIN = 0.03  # around what moves, of its size
DPI = 100
WIDTH = 7.6    # of the blocks above a plot [in]
HEIGHT = 4.4   # of the blocks beside a plot [in]
WIDE = 1.5     # scenes that are so much wider than high have the plot below
TOP, EDGE = 0.75, 0.2              # [in]
BOOK, ITS_LEFT, ITS_FOOT = 1.9, 0.75, 0.55  # the plot below: height, room for labels [in]
BESIDE = 3.3                       # the plot beside: width [in]
LEGEND = 1.7                       # [in]


def together(boxes):
    """The box around boxes."""
    boxes = np.asarray(boxes)
    return np.concatenate([boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)])


def with_margin(box):
    size = (box[2:] - box[:2]).max() or 1.0
    return box + MARGIN * size * np.array([-1, -1, 1, 1])


def light(colour):
    return tuple(LIGHT + (1 - LIGHT) * part for part in to_rgb(colour))


def fills(materials, held, in_order=()):
    """A light colour for every block by its material; those that are held have none. `in_order`: materials of the regions,
    in whose order the palette is used, as in the other figures."""
    known = dict.fromkeys([*in_order, *materials])
    of_name = {name: light(PALETTE[i % len(PALETTE)]) for i, name in enumerate(known)}
    return np.array([to_rgb(HELD_FILL) if still else of_name[name] for name, still in zip(materials, held)])


def used_colours():
    """Those of lines, full and as what is yet to come, of blocks, and greys; k × 3 bytes."""
    full = 255 * np.array([to_rgb(colour) for colour in (*PALETTE, INK)])
    tints = [255 - opacity * (255 - full) for opacity in (1, 1 - LIGHT, YET_TO_COME)]
    held = 255 * np.array([to_rgb(colour) for colour in (HELD_FILL, HELD_HATCH)])
    greys = np.repeat(np.linspace(0, 255, GREYS)[:, None], 3, axis=1)
    return np.unique(np.concatenate([held, greys, *tints]).round().astype(np.uint8), axis=0)


def even(inches):
    """The same length in an even number of pixels, as H.264 wants it."""
    return 2 * round(inches * DPI / 2) / DPI


class Blocks:
    """Blocks for axes of matplotlib: `moving`, `cracks`, and `still`, what is held, hatched and behind the rest."""

    def __init__(self, axes, colours, held):
        self._held = held
        self.moving = PolyCollection([], facecolors=colours[~held], edgecolors=INK, linewidths=0.35, zorder=2)
        with matplotlib.rc_context({"hatch.color": HELD_HATCH, "hatch.linewidth": 0.6}):
            self.still = PolyCollection([], facecolors=HELD_FILL, edgecolors=HELD_HATCH, linewidths=0, hatch="////", zorder=1)
        self.cracks = LineCollection([], colors=CRACK, capstyle="round", zorder=3)
        for collection in (self.still, self.moving, self.cracks):
            axes.add_collection(collection, autolim=False)

    def show(self, polygons):
        self.moving.set_verts([polygon for polygon, held in zip(polygons, self._held) if not held])

    def hold(self, polygons):
        self.still.set_verts([polygon for polygon, held in zip(polygons, self._held) if held])

    def show_cracks(self, segments, damage):
        """Lines, k × 2 × 2, the broader the more is spent."""
        self.cracks.set_segments(segments)
        self.cracks.set_linewidths(0.6 + 1.6 * damage)


class Stage:
    """scene: the axes of the blocks, at true scale; book: those of a plot. What changes from picture to picture is handed
    to `moves`, all else is drawn once."""

    def __init__(self, box, title):
        self.figure = Figure(dpi=DPI)
        self._canvas = FigureCanvasAgg(self.figure)
        box = with_margin(np.asarray(box, dtype=float))
        self._lay_out((box[2] - box[0]) / (box[3] - box[1]))
        self._box, self._title = box, title
        self.clear()

    def _lay_out(self, aspect):
        if aspect > WIDE:
            at, scene = (EDGE, ITS_FOOT + BOOK + 0.3), (WIDTH, WIDTH / aspect)
            size = WIDTH + 2 * EDGE, at[1] + scene[1] + TOP
            book = EDGE + ITS_LEFT, ITS_FOOT, WIDTH - ITS_LEFT - LEGEND, BOOK
        else:
            at, scene = (EDGE, ITS_FOOT), (HEIGHT * aspect, HEIGHT)
            book = EDGE + scene[0] + ITS_LEFT, ITS_FOOT, BESIDE, HEIGHT - 0.3
            size = book[0] + BESIDE + LEGEND + EDGE, ITS_FOOT + HEIGHT + TOP
        self._size = even(size[0]), even(size[1])
        self.figure.set_size_inches(self._size)
        share = np.array([*self._size, *self._size])
        self._places = np.array([*at, *scene]) / share, np.array(book) / share

    def clear(self):
        """For another reel."""
        self.figure.clear()
        self._moving, self._background = [], None
        self.scene, self.book = (self.figure.add_axes(place) for place in self._places)
        self.scene.set(xlim=self._box[[0, 2]], ylim=self._box[[1, 3]])
        self.scene.axis("off")
        self.book.spines[["top", "right"]].set_visible(False)
        self.book.tick_params(labelsize=8)
        self.book.ticklabel_format(scilimits=(-4, 5), useMathText=True)
        left, height = EDGE / self._size[0], self._size[1]
        self.figure.text(left, 1 - 0.32 / height, self._title, weight="bold", size=12, color=INK)
        self._caption = self.figure.text(left, 1 - 0.6 / height, "", size=10, color=INK)
        self.moves(self._caption)

    def moves(self, *artists):
        """Are drawn in this order, anew in each picture."""
        for artist in artists:
            artist.set_animated(True)
        self._moving += artists

    def leaves(self, artist):
        """It is drawn no more."""
        self._moving.remove(artist)
        artist.remove()

    def say(self, text):
        self._caption.set_text(text)

    def label(self, x, y):
        self.book.set_xlabel(x, size=9, labelpad=1)
        self.book.set_ylabel(y, size=9, labelpad=2)

    def picture(self):
        """height × width × 3 bytes."""
        with matplotlib.rc_context({"path.simplify": False}):  # which leaves gaps in spikes
            if self._background is None:
                self._canvas.draw()
                self._background = self._canvas.copy_from_bbox(self.figure.bbox)
            self._canvas.restore_region(self._background)
            for artist in self._moving:
                artist.draw(self._canvas.get_renderer())
        return np.asarray(self._canvas.buffer_rgba())[..., :3].copy()
