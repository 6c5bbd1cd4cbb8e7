"""The same scene in other units, turned, moved, mirrored or renumbered, and the distance of two paths."""

import copy
import math
import random
from dataclasses import dataclass

import numpy

from ddapath import read_run

ENERGIES = ("dissipated_energy", "stored_energy")
IDENTITY = ((1.0, 0.0), (0.0, 1.0))


def outlines(folder):
    """The blocks' polygons of a run."""
    return [polygon.tolist() for polygon in read_run(folder).fields().mesh.polygons]


@dataclass(frozen=True)
class Units:
    """Names of units and how many of them a millimetre and a newton are."""

    length_name: str
    force_name: str
    length: float
    force: float

    def convert(self, deck):
        """The same deck, every number in these units."""
        out = copy.deepcopy(deck)
        out["units"] = {"length": self.length_name, "force": self.force_name}
        out["thickness"] *= self.length
        in_place(out, self.scaled, lambda force: [component * self.force for component in force])
        for material in out["materials"].values():
            material["young_modulus"] *= self.force / self.length**2
        for interface in out["interfaces"].values():
            interface["law"]["tensile_strength"] *= self.force / self.length**2
            interface["law"]["fracture_energy"] *= self.force / self.length
        out["gauges"]["force"]["scale"] *= self.force
        out["record"]["at"]["force"] = [load * self.force for load in deck["record"]["at"]["force"]]
        return out

    def scaled(self, point):
        return [coordinate * self.length for coordinate in point]


@dataclass(frozen=True)
class Motion:
    """x → Q x + c."""

    matrix: tuple = IDENTITY
    shift: tuple = (0.0, 0.0)

    def vector(self, v):
        return [row[0] * v[0] + row[1] * v[1] for row in self.matrix]

    def point(self, x):
        return [turned + moved for turned, moved in zip(self.vector(x), self.shift)]

    def convert(self, deck):
        """The deck after the motion; outlines stay counter-clockwise or turn clockwise, which a deck may."""
        out = copy.deepcopy(deck)
        in_place(out, self.point, self.vector)
        for holder in [*out["gauges"].values(), *out["supports"].values()]:
            if "direction" in holder:
                holder["direction"] = self.vector(holder["direction"])
        return out


def in_place(deck, point, force):
    """Applies one function to every point of a deck, another to every force."""
    scene = deck["scene"]
    for region in scene["regions"]:
        region["vertices"] = [point(x) for x in region["vertices"]]
    for lines in ("slits", "curves"):
        scene[lines] = {name: [point(x) for x in line] for name, line in scene.get(lines, {}).items()}
    for holder in [*deck["supports"].values(), *deck["gauges"].values(), *deck["stages"][0]["loads"]]:
        for key in ("at", "inside", "from", "to", "from_inside", "to_inside"):
            if key in holder:
                holder[key] = point(holder[key])
        if "force" in holder:
            holder["force"] = force(holder["force"])


def rotation(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return Motion(((c, -s), (s, c)))


def renumbered(deck, seed=1):
    """The same regions in another order."""
    out = copy.deepcopy(deck)
    random.Random(seed).shuffle(out["scene"]["regions"])
    return out


def columns(curve, gauges, matrix=IDENTITY):
    """The columns of a path with their scale in the path: forces, energies and every gauge by its largest value.

    The external work is left out: it is a sum over the steps, not a function of the point.
    """
    back = numpy.array(matrix).T
    force = numpy.max(numpy.abs(curve["load"]))
    left = back @ numpy.array([curve["left.x"], curve["left.y"]])
    found = {"load": (curve["load"], force), "load_factor": (curve["load_factor"], None),
             "left.x": (left[0], force), "left.y": (left[1], force), "right": (curve["right"], force)}
    work = numpy.max(numpy.abs(curve["external_work"]))
    found |= {name: (curve[name], work) for name in ENERGIES}
    found |= {name: (curve[name], None) for name in gauges}
    return {name: (numpy.array(values, float), scale or numpy.max(numpy.abs(values)))
            for name, (values, scale) in found.items()}


def distance(reference, other, gauges, units=None, matrix=IDENTITY):
    """Largest difference of two lists of points, relative to the scale of each column, and its column.

    Infinite where the lists do not have the same number of points.
    """
    if not reference or not other or len(reference["load"]) != len(other["load"]):
        return math.inf, "number of points"
    length, force = (units.length, units.force) if units else (1.0, 1.0)
    unit = {name: force for name in ("load", "left.x", "left.y", "right")}
    unit |= {name: force * length for name in ENERGIES} | {name: length for name in gauges}
    mine, theirs = columns(reference, gauges), columns(other, gauges, matrix)
    found = {name: float(numpy.max(numpy.abs(theirs[name][0] / unit.get(name, 1.0) - values)) / scale)
             for name, (values, scale) in mine.items()}
    worst = max(found, key=found.get)
    return found[worst], worst


def landings(outcome, gauge):
    """The points of a path that landed on prescribed values of a gauge."""
    steps = [step["step"] for step in outcome.steps
             if any(name.startswith(f"{gauge}=") for name in step.get("landed", []))]
    if not outcome.curve or not steps:
        return {}
    wanted = [outcome.curve["step"].index(step) for step in steps]
    return {name: [values[i] for i in wanted] for name, values in outcome.curve.items()}
