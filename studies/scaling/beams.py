"""The notched beam of studies/notched-beam in any number of blocks; only its ligament can crack. And a beam without a notch
through whose blocks a crack runs.
"""

from pathlib import Path

GEOMETRY = Path(__file__).resolve().parents[1] / "notched-beam" / "beam.geo"
DEPTH, SPAN, NOTCH, THICKNESS = 100, 400, 50, 100  # mm
NUMBERS = {"triangles": (1000, 3000, 10_000, 30_000, 100_000, 325_000), "voronoi": (1000, 3000, 10_000, 30_000, 100_000),
           "through blocks": (1000, 3000, 10_000, 20_000, 40_000)}
# Sides of the triangles at the ligament and far from it that give about so many blocks [mm].
TRIANGLES = {1000: (3.86, 30.9), 3000: (2.16, 17.3), 10_000: (1.15, 9.2), 30_000: (0.657, 5.26), 100_000: (0.357, 2.86),
             325_000: (0.198, 1.586)}


def deck(scene):
    beside = (0.1, DEPTH - 0.1)
    return {
        "title": "Notched beam in three-point bending",
        "units": {"length": "mm", "force": "N"},
        "scene": scene,
        "thickness": THICKNESS,
        "plane": "stress",
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"ligament": {"law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.03}}},
        "supports": {"left": {"at": [-SPAN / 2, 0], "fix": "xy"}, "right": {"at": [SPAN / 2, 0], "fix": "y"}},
        "stages": [{"name": "bending", "loads": [
            {"type": "point_load", "at": [0, DEPTH], "inside": [side * beside[0], beside[1]], "force": [0, -0.5]}
            for side in (-1, 1)]}],
        "gauges": {"deflection": {"type": "displacement", "at": [0, DEPTH], "inside": [-beside[0], beside[1]],
                                  "direction": [0, -1]}},
        "path": {"stop": {"load_below": 0.1}},
    }


def geometry(ligament, far):
    return {"type": "geo", "file": str(GEOMETRY),
            "parameters": {"depth": DEPTH, "span": SPAN, "notch": NOTCH, "overhang": 20, "ligament_size": ligament,
                           "far_size": far}}


def triangles(number):
    return deck(geometry(*TRIANGLES[number]) | {"subdivision": {"type": "triangles"}})


def voronoi(number):
    return deck(geometry(5, 30) | {"subdivision": {"type": "voronoi", "blocks": number, "seed": 1}})


def through_blocks(number):
    """About √(n/3) cuts from one face to the other."""
    span = 3 * DEPTH
    return {
        "title": "Beam in three-point bending, a crack through its blocks",
        "units": {"length": "mm", "force": "N"},
        "scene": {"regions": [{"name": "beam", "material": "concrete", "vertices": [[0, 0], [span, 0], [span, DEPTH], [0, DEPTH]]}],
                  "subdivision": {"type": "voronoi", "blocks": number, "seed": 1}},
        "thickness": THICKNESS,
        "plane": "stress",
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"joints": {"between": ["concrete", "concrete"],
                                  "law": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.1}}},
        "cracks": [{"through_blocks": ["beam"], "begin": [{"at": [span / 2, 0], "direction": [0, 1]}]}],
        "supports": {"left": {"at": [0, 0], "fix": "xy"}, "right": {"at": [span, 0], "fix": "y"}},
        "stages": [{"name": "bending", "loads": [
            {"type": "point_load", "over": [[span / 2 - 5, DEPTH], [span / 2 + 5, DEPTH]], "force": [0, -1]}]}],
        "path": {"stop": {"load_below": 0.3}},
    }


BEAMS = {"triangles": triangles, "voronoi": voronoi, "through blocks": through_blocks}
