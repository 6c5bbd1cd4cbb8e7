"""The motion behind a path: blocks at true scale at even intervals of time, and the energy book up to then."""

import math
from functools import lru_cache

import numpy as np

from ..errors import NothingStored
from .outlines import Outlines, between, materials_of, names_of
from .stage import PALETTE, YET_TO_COME, Blocks, fills, together

ENERGIES = {"external_work": "external work", "kinetic_energy": "kinetic", "stored_energy": "stored", "friction": "friction",
            "fracture": "fracture", "viscous_damping": "viscous damping", "impact": "impact",
            "numerical_damping": "numerical damping"}
SECONDS = 8         # of film about, unless a speed is wished
TRUE_IF = (3, 20)   # motions that last so long are shown as fast as they are [s]


def round_number(number):
    """The 1, 2 or 5 times a power of ten that a positive number is nearest to, by their ratio."""
    power = 10.0 ** math.floor(math.log10(number))
    return min((digit * power for digit in (1, 2, 5, 10)), key=lambda near: abs(math.log(near / number)))


def usual_speed(duration):
    return 1.0 if TRUE_IF[0] <= duration <= TRUE_IF[1] else round_number(duration / SECONDS)


def speed_text(speed):
    if speed == 1:
        return "in real time"
    return f"slowed down {1 / speed:.4g} times" if speed < 1 else f"speeded up {speed:.4g} times"


def decimals_for(step):
    """Digits behind the point that tell instants apart."""
    return max(0, math.ceil(-math.log10(step) - 1e-9))


class MotionReel:
    """count pictures; box: around all that moves, and what of the rest is near."""

    def __init__(self, run, speed, fps):
        self._run, self._motion = run, run.motion
        self._curve, self._steps = self._motion.curve, self._motion.steps
        if len(self._steps) < 2 or self._curve.empty:
            raise NothingStored(f"{run.folder}: of the motion only its beginning is stored (yet)")
        self._outlines = lru_cache(maxsize=2)(lambda step: Outlines.of(self._motion.fields(step).polygons()))
        self._survey()
        duration = self._times[-1] - self._times[0]
        self._speed = speed or usual_speed(duration)
        self._interval = self._speed / fps
        self.count = math.ceil(duration / self._interval - 1e-9) + 1

    def _survey(self):
        """Goes through the stored states once: their times, what never moves, and where the rest gets."""
        first = self._outlines(self._steps[0])
        moves = np.zeros(len(first.offsets) - 1, dtype=bool)
        for step in self._steps[1:]:
            moves |= first.sums((self._outlines(step).z != first.z).astype(int)) > 0
        self.held = ~moves
        self._times = np.concatenate([[0.0], self._curve.set_index("step")["time"].reindex(self._steps[1:]).to_numpy()])
        of_all = [self._outlines(step).box(None if self.held.all() else moves) for step in self._steps]
        around = together(of_all)
        margin = 0.1 * (around[2:] - around[:2]).max()
        room = together([around, first.box()])
        self.box = np.concatenate([np.maximum(room[:2], around[:2] - margin), np.minimum(room[2:], around[2:] + margin)])

    def time_of(self, k):
        return min(self._times[0] + k * self._interval, self._times[-1])

    def outlines_at(self, time):
        """Of all blocks at any instant of the motion."""
        after = int(np.clip(np.searchsorted(self._times, time), 1, len(self._times) - 1))
        start, end = self._times[after - 1], self._times[after]
        states = self._outlines(self._steps[after - 1]), self._outlines(self._steps[after])
        return between(*states, (time - start) / (end - start))

    def colours(self):
        """Of every block, by material."""
        region = self._motion.fields(self._steps[0]).mesh.region
        materials = materials_of(self._run)
        return fills(names_of(region, materials), self.held, materials or ())

    def begin(self, stage):
        stage.clear()
        self._blocks = Blocks(stage.scene, self.colours(), self.held)
        self._blocks.hold(self._outlines(self._steps[0]).polygons)
        time, units = self._curve["time"].to_numpy(), self._curve.attrs["units"]
        self._lines = []
        there = [(name, self._curve[column].to_numpy()) for column, name in ENERGIES.items() if self._curve[column].any()]
        for i, (name, values) in enumerate(there):
            look = {"color": PALETTE[i % len(PALETTE)], "linestyle": "-" if i < len(PALETTE) else "--"}
            stage.book.plot(time, values, linewidth=1, alpha=YET_TO_COME, **look)
            self._lines.append((stage.book.plot([], [], linewidth=1.5, label=name, **look)[0], values))
        self._now = stage.book.axvline(0, color="#808080", linewidth=0.8)
        stage.book.set_xlim(self._times[0], self._times[-1])
        stage.label(f"time [{units['time']}]", f"energy [{units['external_work']}]")
        stage.book.legend(loc="upper left", bbox_to_anchor=(1.0, 1.03), fontsize=8, frameon=False, handlelength=1.4)
        stage.moves(self._blocks.moving, self._now, *(line for line, _ in self._lines))

    def show(self, stage, k):
        time = self.time_of(k)
        self._blocks.show(self.outlines_at(time).polygons)
        times = self._curve["time"].to_numpy()
        until = np.append(times[times < time], time)
        for line, values in self._lines:
            line.set_data(until, np.interp(until, times, values))
        self._now.set_xdata([time, time])
        instant = f"{time:.{decimals_for(self._interval)}f} {self._curve.attrs['units']['time']}"
        stage.say(f"Motion, {instant}, {speed_text(self._speed)}; true scale")
