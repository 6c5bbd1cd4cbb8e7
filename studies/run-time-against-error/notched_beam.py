"""F3: the nominal strength of a notched beam in three-point bending, S/D = 4, a0/D = 0.5, D = l_ch.

    σ_N = 6 M/(b D²),  M = P S/4,      σ_N/ft = 0.34817

ν = 0.2, initially rigid linear softening on the ligament, the bulk bonded. The reference is that of an independent
cohesive-crack solver with an exact Schur complement on the ligament (its own error about 0.1 %).

Penalty springs k = m E/d add 1/(m E) to the compliance 1/E, however small the blocks: l_ch falls by 1/m, and the peak
tends to

    σ_N(D/l_ch = 1 + 1/m)/σ_N(1) − 1 ≈ −0.25/m,

by the slope between the reference's 0.40881 at D/l_ch = 0.5 and 0.28730 at 2.
"""

from pathlib import Path

import blocks

NAME = "notched-beam"
TITLE = "F3, notched beam: peak load"
REFERENCE = 0.34817
DEPTH, SPAN, NOTCH, LENGTH, THICKNESS = 100, 400, 50, 440, 100
STRENGTH, YOUNG, POISSON = 3, 30000, 0.2
ENERGY = STRENGTH**2 * DEPTH / YOUNG  # Gf at D = l_ch
END = 3 * 2 * ENERGY / STRENGTH  # CMOD at which a run ends: the peak is near 2 w_c
GEOMETRY = Path(__file__).resolve().parents[1] / "notched-beam" / "beam.geo"

# Half the beam in bands: (from, to, size of the blocks in units of those on the ligament).
BANDS = ((0, 12.5, 1), (12.5, 37.5, 2), (37.5, LENGTH / 2, 4))
COARSEST = DEPTH / 16  # side of the coarsest blocks on the ligament

# Down to some ten thousand blocks: only there it shows where the lines of soft penalties end.
SIZES = {
    "triangles": (8, 5.6, 4, 2.8, 2, 1.4),
    "quads": (1, 2, 3, 4, 5, 7, 10, 14),
    "voronoi": (6.25, 4, 2.8, 2, 1.4, 0.95, 0.7, 0.5),
}


def triangles(size):
    return {"type": "geo", "file": str(GEOMETRY), "subdivision": {"type": "triangles"},
            "parameters": {"depth": DEPTH, "span": SPAN, "notch": NOTCH, "overhang": (LENGTH - SPAN) / 2,
                           "ligament_size": size, "far_size": 8 * size}}


def ligament():
    return {"curves": {"ligament": [[0, NOTCH], [0, DEPTH]]}, "slits": {"notch": [[0, 0], [0, NOTCH]]}}


def quads(cuts):
    """Coarse squares, graded with T-joints, each cut into cuts × cuts; below one they are so much coarser."""
    half = []
    coarsest = COARSEST / min(cuts, 1)
    cuts = max(cuts, 1)
    for start, end, scale in BANDS:
        rows = round(DEPTH / (scale * coarsest))
        columns = max(1, round((end - start) / (scale * coarsest)))
        width, height = (end - start) / columns, DEPTH / rows
        half += [blocks.rectangle(start + i * width, j * height, start + (i + 1) * width, (j + 1) * height)
                 for i in range(columns) for j in range(rows)]
    return ligament() | {"regions": blocks.regions(blocks.mirrored(half, 0)),
                         "subdivision": {"type": "grid", "columns": cuts, "rows": cuts}}


def voronoi(size):
    """Centroidal cells of the same bands, mirrored about the ligament."""
    half = []
    for start, end, scale in BANDS:
        half += blocks.voronoi(blocks.rectangle(start, 0, end, DEPTH), scale * size)
    half = blocks.with_vertex(half, [0, NOTCH])
    return ligament() | {"regions": blocks.regions(blocks.mirrored(half, 0)), "subdivision": {"type": "given"}}


# Of blocks of second order.
SECOND_ORDER_SIZES = {
    "triangles": (22, 16, 11, 8, 5.6, 4),
    "quads": (0.5, 1, 2, 3, 4, 5),
    "voronoi": (12.5, 9, 6.25, 4, 2.8, 2),
}

SCENES = {"triangles": triangles, "quads": quads, "voronoi": voronoi}


def deck(scene, treatment):
    law = {"type": "linear_softening", "tensile_strength": STRENGTH, "fracture_energy": ENERGY}
    side = {-1: [-0.01, DEPTH - 0.01], 1: [0.01, DEPTH - 0.01]}
    return {
        "title": TITLE,
        "scene": scene,
        "thickness": THICKNESS,
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": YOUNG, "poisson_ratio": POISSON}},
        "interfaces": {"ligament": {"law": law, "treatment": treatment},
                       "bulk": {"between": ["concrete", "concrete"], "treatment": treatment}},
        "supports": {"left": {"at": [-SPAN / 2, 0], "fix": "xy"}, "right": {"at": [SPAN / 2, 0], "fix": "y"}},
        "stages": [{"loads": [{"type": "point_load", "at": [0, DEPTH], "inside": inside, "force": [0, -0.5]}
                              for inside in side.values()]}],
        "gauges": {"deflection": {"type": "displacement", "at": [0, DEPTH], "inside": side[-1], "direction": [0, -1]},
                   "cmod": {"type": "relative_displacement", "from": [0, 0], "from_inside": [-0.01, 0.01], "to": [0, 0],
                            "to_inside": [0.01, 0.01], "direction": [1, 0]}},
        "path": {"stop": {"load_below": 0, "gauges": {"cmod": END}}},
    }


def error(run):
    """σ_N/(ft · reference) − 1, signed."""
    if run.curve["cmod"].iloc[-1] < 0.99 * END:
        raise ValueError("the path ended early")
    strength = 6 * run.summary["peak"]["load"] * SPAN / 4 / (THICKNESS * DEPTH**2) / STRENGTH
    return strength / REFERENCE - 1
