"""Planes of symmetry that may crack: one half of a structure is as good as the whole.

    test_symmetry.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import numpy as np

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

LENGTH, DEPTH, PATCH = 240.0, 60.0, 10.0
LAWS = {
    "linear": {"type": "linear_softening", "tensile_strength": 3, "fracture_energy": 0.03},
    "exponential": {"type": "exponential_softening", "tensile_strength": 3, "fracture_energy": 0.03},
    "at once": {"type": "mohr_coulomb", "tensile_strength": 3, "cohesion": 5, "friction_angle": 30},
    "bonded": "bonded",
}


def beam(law, turn=0.0, half=False, **interface):
    """Three-point bending about x = 0, of which only x > 0 is described if asked, all turned by an angle."""
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    at = lambda *points: [(rotation @ np.array(point, dtype=float)).tolist() for point in points]
    left = 0.0 if half else -LENGTH / 2
    right, down = LENGTH / 2, (rotation @ np.array([0.0, -1.0])).tolist()
    axis = at([0, 0], [0, DEPTH])
    over = at([0 if half else -PATCH, DEPTH], [PATCH, DEPTH])
    side = at([right - PATCH, 0], [right, 0])
    supports = {"right": {"over": side, "direction": down}}
    if not half:
        supports |= {"left": {"over": at([left, 0], [left + PATCH, 0]), "direction": down},
                     "along": {"at": at([left, 0])[0], "direction": (rotation @ np.array([1.0, 0.0])).tolist()}}
    joint = {"law": law} | interface
    return {
        "units": {"length": "mm", "force": "N"},
        "scene": {"regions": [{"name": "beam", "material": "c", "vertices": at([left, 0], [right, 0], [right, DEPTH], [left, DEPTH])}],
                  "boundaries": {"axis": axis[::-1]} if half else {}, "curves": {} if half else {"ligament": axis},
                  "subdivision": {"type": "triangles", "size": 12} if turn else
                                 {"type": "grid", "columns": 12 if half else 24, "rows": 6}},
        "thickness": 10, "plane": "stress",
        "materials": {"c": {"type": "linear_elastic", "young_modulus": 30000, "poisson_ratio": 0.2}},
        "interfaces": {"ligament": joint | ({"boundary": "axis"} if half else {})},
        "supports": supports,
        "stages": [{"name": "load", "loads": [{"type": "point_load", "over": over, "force": [500 * x if half else 1000 * x for x in down]}]}],
        "gauges": {"deflection": {"type": "displacement", "over": over, "direction": down}},
        "path": {"stop": {"gauges": {"deflection": 0.1}, "load_below": 0.05}},
        "record": {"at": {"deflection": [0.02, 0.04, 0.06]}, "fields_every": 1},
    }


class Symmetry(ProgramCase):
    def followed(self, deck, name):
        run = ddapath.run(deck, folder=self.folder / name, check=False)
        self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
        refused = [f"{found.check}: {found.worst} at {found.place}" for found in verify(run.folder) if not found.holds]
        self.assertEqual(refused, [])
        return run

    def assert_half(self, half, whole, tolerance):
        """Load, energies and the loads at given deflections are half as large."""
        self.assertAlmostEqual(2 * half.curve["load"].max() / whole.curve["load"].max(), 1, delta=tolerance)
        self.assertAlmostEqual(2 * half.summary["external_work"] / whole.summary["external_work"], 1, delta=1e-3)
        for deflection in (0.02, 0.04, 0.06):
            loads = [run.curve["load"][np.isclose(run.curve["deflection"], deflection, rtol=1e-9)] for run in (half, whole)]
            if min(map(len, loads)) == 1:
                self.assertAlmostEqual(2 * loads[0].iloc[0] / loads[1].iloc[0], 1, delta=tolerance)

    def test_half_a_beam_cracks_as_the_whole_does(self):
        for name, law in LAWS.items():
            for treatment in ("consistent", "penalty", "augmented_lagrangian"):
                if name == "at once" and treatment == "augmented_lagrangian":
                    continue  # multipliers cannot follow it
                with self.subTest(name, treatment=treatment):
                    half, whole = (self.followed(beam(law, half=half, treatment=treatment), f"{name} {treatment} {half}")
                                   for half in (True, False))
                    self.assert_half(half, whole, 1e-6)

    def test_blocks_of_second_order(self):
        runs = []
        for half in (True, False):
            runs.append(self.followed(beam(LAWS["linear"], half=half) | {"kinematics": "second_order"}, f"second {half}"))
        self.assert_half(*runs, 1e-6)

    def test_planes_in_any_direction(self):
        """Triangles of their own on either side of the plane."""
        upright, turned = (self.followed(beam(LAWS["linear"], half=True, turn=turn), f"{turn}") for turn in (1e-12, 0.7))
        self.assertAlmostEqual(upright.curve["load"].max() / turned.curve["load"].max(), 1, delta=2e-2)
        jump = turned.fields(turned.steps[-1]).points[["jump_n", "jump_s"]].to_numpy()
        self.assertGreater(jump[:, 0].max(), 1e-3)
        self.assertLess(np.abs(jump[:, 1]).max(), 1e-12)

    def test_wrong_decks(self):
        deck = beam(LAWS["linear"], half=True)
        bent = deck["scene"] | {"boundaries": {"axis": [[0, DEPTH], [0, 0], [LENGTH / 2, 0]]}}
        known = {
            "unknown boundary 'axes'; did you mean 'axis'?": {"interfaces": {"ligament": {"boundary": "axes"}}},
            "it is not straight": {"scene": bent},
            "take another treatment": {"interfaces": {"ligament": {"boundary": "axis", "treatment": "lagrange"}}},
            "is another interface already": {"interfaces": {"one": {"boundary": "axis"}, "two": {"boundary": "axis"}}},
            "each is on a plane of symmetry, which nothing else may hold or load": {"supports": deck["supports"] | {"axis": {"boundary": "axis", "fix": "normal"}}},
            "cracks through blocks do not know planes of symmetry": {"cracks": [{"through_blocks": ["beam"], "law": "ligament", "begin": "automatic"}]},
            "`motion` needs the whole structure": {"motion": {"time": 1}},
        }
        for message, changes in known.items():
            with self.subTest(message), self.assertRaises(ddapath.InputError) as raised:
                ddapath.run(deck | changes, folder=self.folder / "wrong")
            self.assertIn(message, str(raised.exception))


if __name__ == "__main__":
    unittest.main()
