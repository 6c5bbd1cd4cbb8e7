"""The path: a point that goes along the curve of load against deflection, and the blocks with displacements magnified."""

from functools import lru_cache

import numpy as np

from ..errors import NothingStored
from .motion_reel import round_number
from .outlines import Outlines, materials_of, names_of
from .stage import CRACK, PALETTE, YET_TO_COME, Blocks, fills, together

SECONDS = 6     # of film
SHOWN = 0.06    # the largest displacement, of the structure's size, unless a magnification is wished
DISPLACEMENTS = ("displacement", "relative_displacement")


def deflection_of(run):
    """The column that stands for the deflection: the first displacement gauge of the deck; else the step."""
    gauges = run.deck.get("gauges") or {}
    for kind in DISPLACEMENTS:
        for name, gauge in gauges.items():
            if gauge["type"] == kind and name in run.curve:
                return name
    return "step"


def cracked(fields, scale):
    """Lines where interfaces and blocks have cracked, k × 2 × 2, and how much of each is spent."""
    lines, spent = [np.zeros((0, 2, 2))], [np.zeros(0)]
    for points, ends in ((fields.points, fields.point_ends), (fields.cracks, fields.crack_ends)):
        if "damage" in points and len(points):
            moved = ends[["x", "y"]].to_numpy() + scale * ends[["displacement_x", "displacement_y"]].to_numpy()
            damage = points["damage"].to_numpy()
            lines.append(moved.reshape(-1, 2, 2)[damage > 0])
            spent.append(damage[damage > 0])
    return np.concatenate(lines), np.concatenate(spent)


def along(x, y, count):
    """Places between the rows of a curve, `count` of them evenly along its line as it is drawn."""
    extent = [np.ptp(values) or 1.0 for values in (x, y)]
    way = np.concatenate([[0], np.cumsum(np.hypot(np.diff(x) / extent[0], np.diff(y) / extent[1]))])
    if way[-1] == 0:
        return np.zeros(count)
    kept = np.concatenate([[True], np.diff(way) > 0])
    return np.interp(np.linspace(0, way[-1], count), way[kept], np.flatnonzero(kept))


class PathReel:
    """count pictures; box: around the undeformed structure and the deformed one as it is drawn."""

    def __init__(self, run, magnification, fps):
        if not run.deck.get("stages") or len(run.curve) < 2 or not run.steps:
            raise NothingStored(f"{run.folder}: there is no path to be shown with stored fields (yet)")
        self._run, self._curve, self._steps = run, run.curve, np.array(run.steps)
        self._fields = lru_cache(maxsize=2)(run.fields)
        self.scale = magnification or self._usual_scale()
        self._places = along(*self._columns(), count=max(2, round(SECONDS * fps)))
        self.count = len(self._places)
        self.box = together([Outlines.of(self._fields(self._steps[-1]).polygons(scale)).box(self._moves())
                             for scale in (0, self.scale)])

    def _moves(self):
        """Polygons that move at the last stored step."""
        fields = self._fields(self._steps[-1])
        still, moved = (Outlines.of(fields.polygons(scale)) for scale in (0, 1))
        far = still.sums(np.abs(moved.z - still.z)) / np.diff(still.offsets)
        return far > 1e-2 * far.max() if far.max() > 0 else np.ones(len(far), dtype=bool)

    def _usual_scale(self):
        vertices = self._fields(self._steps[-1]).mesh.vertices
        largest = max(self._fields(step).vertices[["displacement_x", "displacement_y"]].abs().max().max() for step in self._steps)
        return round_number(SHOWN * np.ptp(vertices, axis=0).max() / largest) if largest > 0 else 1.0

    def _columns(self):
        return self._curve[deflection_of(self._run)].to_numpy(dtype=float), self._curve["load"].to_numpy(dtype=float)

    def step_near(self, place):
        """The stored step nearest to a place along the curve."""
        return int(self._steps[np.argmin(np.abs(self._steps - place))])

    def begin(self, stage):
        stage.clear()
        self._shown, self._blocks = None, []
        x, y = self._columns()
        units, name = self._curve.attrs["units"], deflection_of(self._run)
        stage.book.plot(x, y, color=PALETTE[0], linewidth=1, alpha=YET_TO_COME)
        self._line = stage.book.plot([], [], color=PALETTE[0], linewidth=1.8)[0]
        self._point = stage.book.plot([], [], "o", color=CRACK, markersize=6)[0]
        stage.label(f"{name} [{units[name]}]" if units.get(name) else name, f"load [{units['load']}]")
        stage.moves(self._line, self._point)

    def show(self, stage, k):
        place = self._places[k]
        x, y = self._columns()
        rows = np.append(np.arange(np.ceil(place)), place)
        here = [np.interp(rows, np.arange(len(x)), values) for values in (x, y)]
        self._line.set_data(*here)
        self._point.set_data(here[0][-1:], here[1][-1:])
        step = self.step_near(place)
        if step != self._shown:
            self._show_blocks(stage, step)
        load = np.format_float_positional(here[1][-1], precision=3, fractional=False, trim="-")
        unit = self._curve.attrs["units"]["load"]
        stage.say(f"Path, load {load} {unit}, blocks of step {step}; displacements × {self.scale:g}")

    def _show_blocks(self, stage, step):
        for collection in self._blocks:
            stage.leaves(collection)
        blocks = self.draw(stage.scene, step)
        self._blocks, self._shown = [blocks.still, blocks.moving, blocks.cracks], step
        stage.moves(*self._blocks)

    def draw(self, axes, step):
        """The Blocks of a stored step, with its cracks."""
        fields = self._fields(step)
        region = fields.polygon_regions
        held, materials = self._is_held(region), materials_of(self._run)
        blocks = Blocks(axes, fills(names_of(region, materials), held, materials or ()), held)
        polygons = fields.polygons(self.scale)
        blocks.show(polygons)
        blocks.hold(polygons)
        blocks.show_cracks(*cracked(fields, self.scale))
        return blocks

    def _is_held(self, region):
        """Blocks of regions that stay where they are when the structure is let go."""
        names = (self._run.deck.get("motion") or {}).get("held") or []
        regions = [one["name"] for one in self._run.deck["scene"].get("regions") or []]
        return np.isin(region, [regions.index(name) for name in names if name in regions])
