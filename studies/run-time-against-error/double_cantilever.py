"""F2: two arms on a cohesive ligament, bent apart by pure moments; the crack grows at a known moment.

    M = √(Gf b E I),   I = b h³/12,       whatever the cohesive law (J integral)

The moment is a pair of tractions ±τ on the halves of each arm's end, M = λ τ b h²/4 with τ = 1. It is averaged over the
dissipation from 21 to 64 % of the ligament's, where the cohesive zone is developed and far from both ends.
"""

import math

import blocks

NAME = "double-cantilever"
TITLE = "F2, double cantilever: moment at crack growth"
ARM, WIDTH, LENGTH, CRACK = 10, 10, 100, 30
YOUNG, POISSON, STRENGTH, ENERGY = 30000, 0.2, 3, 0.002
MOMENT = math.sqrt(ENERGY * WIDTH * YOUNG * WIDTH * ARM**3 / 12)

# Rows of blocks through an arm; Voronoi cells have the area of as many squares.
SIZES = {"triangles": (3, 4, 6, 8), "quads": (4, 6, 8, 10), "voronoi": (4, 6, 8, 10)}


SECOND_ORDER_SIZES = {"triangles": (1, 2, 3, 4), "quads": (2, 4, 6), "voronoi": (2, 3, 4, 6)}  # of blocks of second order


def scene_of(polygons, subdivision):
    half = ARM / 2
    return {"regions": blocks.regions(polygons), "subdivision": subdivision,
            "curves": {"ligament": [[CRACK, 0], [LENGTH, 0]]}, "slits": {"notch": [[0, 0], [CRACK, 0]]},
            "boundaries": {"upper_outer": [[0, ARM], [0, half]], "upper_inner": [[0, half], [0, 0]],
                           "lower_inner": [[0, 0], [0, -half]], "lower_outer": [[0, -half], [0, -ARM]]}}


def grid(rows, shape):
    arm = [blocks.rectangle(0, 0, LENGTH, ARM)]
    columns = round(rows * LENGTH / ARM)
    return scene_of(blocks.mirrored(arm, 1), {"type": "grid", "columns": columns, "rows": rows, "shape": shape})


def voronoi(rows):
    cells = blocks.voronoi(blocks.rectangle(0, 0, LENGTH, ARM), ARM / rows)
    for point in ([CRACK, 0], [0, ARM / 2]):
        cells = blocks.with_vertex(cells, point)
    return scene_of(blocks.mirrored(cells, 1), {"type": "given"})


SCENES = {"triangles": lambda rows: grid(rows, "triangles"), "quads": lambda rows: grid(rows, "quads"),
          "voronoi": voronoi}


def deck(scene, treatment):
    law = {"type": "linear_softening", "tensile_strength": STRENGTH, "fracture_energy": ENERGY}
    signs = {"upper_outer": 1, "upper_inner": -1, "lower_inner": -1, "lower_outer": 1}
    return {
        "title": TITLE,
        "scene": scene,
        "thickness": WIDTH,
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": YOUNG, "poisson_ratio": POISSON}},
        "interfaces": {"ligament": {"law": law, "treatment": treatment},
                       "bulk": {"between": ["concrete", "concrete"], "treatment": treatment}},
        "supports": {"pin": {"at": [LENGTH, -ARM], "fix": "xy"}, "roller": {"at": [LENGTH, ARM], "fix": "x"}},
        "stages": [{"loads": [{"type": "edge_traction", "boundary": name, "traction": [sign, 0]}
                              for name, sign in signs.items()]}],
        "path": {"stop": {"load_below": 0.3}},
    }


def error(run):
    """Mean moment relative to the closed form, less 1, signed."""
    whole = ENERGY * WIDTH * (LENGTH - CRACK)
    total = spent = 0
    rows = run.curve.to_dict("records")
    for start, end in zip(rows[:-1], rows[1:]):
        if start["dissipated_energy"] < 0.21 * whole or end["dissipated_energy"] > 0.64 * whole:
            continue
        quantum = end["dissipated_energy"] - start["dissipated_energy"]
        total += quantum * (start["load_factor"] + end["load_factor"]) / 2
        spent += quantum
    if spent < 0.3 * whole:
        raise ValueError("the path ended early")
    return total / spent * WIDTH * ARM**2 / 4 / MOMENT - 1
