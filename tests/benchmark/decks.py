"""Decks that are timed and stand in no study, and the beams of studies/scaling."""

import sys
from pathlib import Path

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES / "scaling"))

import beams  # noqa: E402, F401


def voronoi(blocks, depth_over_notch, **law):
    """A beam of Voronoi cells, D = 100, S = 300 mm, in three-point bending, every interface able to crack.

    The notch is D / depth_over_notch; `law` is what the linear softening has beside strength and fracture energy.
    """
    return {
        "scene": {"regions": [{"material": "concrete", "vertices": [[0, 0], [300, 0], [300, 100], [0, 100]]}],
                  "slits": {"notch": [[150, 0], [150, 100 / depth_over_notch]]},
                  "subdivision": {"type": "voronoi", "blocks": blocks, "seed": 1}},
        "thickness": 100,
        "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"any": {"between": ["concrete", "concrete"], "law": {
            "type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.1} | law}},
        "supports": {"left": {"at": [0, 0], "fix": "xy"}, "right": {"at": [300, 0], "fix": "y"}},
        "stages": [{"loads": [{"type": "point_load", "at": [150, 100], "force": [0, -1]}]}],
        "path": {"stop": {"load_below": 0.1}},
    }
