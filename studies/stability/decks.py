"""The decks of the study, as trees that are written as JSON, which YAML accepts."""

import copy
from dataclasses import dataclass


@dataclass(frozen=True)
class Beam:
    """The notched beam in three-point bending that every section varies; lengths in mm, forces in N.

    The notch is a slit from the lower edge at midspan; x is measured from there.
    """

    depth: float = 100.0
    span: float = 300.0
    overhang: float = 20.0
    thickness: float = 100.0
    young: float = 30000.0
    poisson: float = 0.2
    strength: float = 3.0

    @property
    def notch(self):
        return self.depth / 6

    @property
    def half_length(self):
        return self.span / 2 + self.overhang

    @property
    def area(self):
        return 2 * self.half_length * self.depth


BEAM = Beam()

# Area of one block of gmsh in units of the squared size that was asked for, measured on this beam.
AREA_PER_SIZE_SQUARED = {"triangles": 0.36, "quads": 0.66}

CONSISTENT = {"type": "consistent"}
PENALTY = {"type": "penalty", "factor": 100}
LAWS = ("linear", "bilinear", "exponential")
SHAPES = ("triangles", "quads", "voronoi")


def subdivision(shape, blocks, seed=1):
    """About so many blocks of a shape in the beam."""
    if shape == "voronoi":
        return {"type": "voronoi", "blocks": blocks, "seed": seed}
    size = (BEAM.area / blocks / AREA_PER_SIZE_SQUARED[shape]) ** 0.5
    return {"type": shape, "size": round(size, 3)}


def softening(law, fracture_energy, strength=BEAM.strength):
    """A softening law; the fracture energy in N/m, 1 N/m = 1e-3 N/mm."""
    return {"type": f"{law}_softening", "tensile_strength": strength, "fracture_energy": fracture_energy * 1e-3}


def joints(law, treatment=None):
    """Every interface between two blocks of concrete."""
    return {"joints": {"between": ["concrete", "concrete"], "law": law, "treatment": treatment or CONSISTENT}}


def beam(cut, law, treatment=None):
    """The beam under a point load at midspan, cut into blocks, every interface able to crack."""
    right, top = BEAM.half_length, BEAM.depth
    outline = [[-right, 0], [right, 0], [right, top], [-right, top]]
    return {
        "title": "Notched beam in three-point bending, every interface able to crack",
        "units": {"length": "mm", "force": "N"},
        "scene": {
            "regions": [{"name": "beam", "material": "concrete", "vertices": outline}],
            "slits": {"notch": [[0, 0], [0, BEAM.notch]]},
            "subdivision": cut,
        },
        "thickness": BEAM.thickness,
        "plane": "stress",
        "materials": {"concrete": elastic(BEAM.young)},
        "interfaces": joints(law, treatment),
        "supports": {"left": {"at": [-BEAM.span / 2, 0], "fix": "xy"}, "right": {"at": [BEAM.span / 2, 0], "fix": "y"}},
        "stages": [{"name": "bending", "loads": [{"type": "point_load", "at": [0, top], "force": [0, -1]}]}],
        "gauges": {
            "deflection": {"type": "displacement", "at": [0, top], "direction": [0, -1]},
            "cmod": {"type": "relative_displacement", "from": [0, 0], "from_inside": [-0.01, 0.01],
                     "to": [0, 0], "to_inside": [0.01, 0.01], "direction": [1, 0]},
        },
        "path": {"stop": {"load_below": 0.1}},
        "record": {"fields_every": 0},
    }


def elastic(young, poisson=BEAM.poisson):
    return {"type": "linear_elastic", "young_modulus": young, "poisson_ratio": poisson}


def changed(deck, **sections):
    """A copy of a deck with some sections replaced."""
    return copy.deepcopy(deck) | copy.deepcopy(sections)
