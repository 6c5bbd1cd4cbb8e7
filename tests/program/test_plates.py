"""Stiff plates, `fix: straight`: patches stay straight, move and turn freely, and bear nothing in sum.

    test_plates.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import unittest

import numpy as np

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

LEFT, TOP = [[0, 0], [80, 0]], [[180, 100], [260, 100]]

# A block of rubber on two patches, pressed from above, off its middle.
PAD = {
    "units": {"length": "mm", "force": "N"},
    "scene": {"regions": [{"name": "pad", "material": "c", "vertices": [[0, 0], [400, 0], [400, 100], [0, 100]]}],
              "subdivision": {"type": "voronoi", "blocks": 120}},
    "thickness": 10, "plane": "stress",
    "materials": {"c": {"type": "linear_elastic", "young_modulus": 1000, "poisson_ratio": 0.2}},
    "interfaces": {"j": {"between": ["c", "c"], "law": "bonded"}},
    "supports": {"left": {"over": LEFT, "fix": "xy"}, "right": {"over": [[320, 0], [400, 0]], "fix": "y"}},
    "stages": [{"name": "pressed", "loads": [{"type": "point_load", "over": TOP, "force": [0, -1000]}]}],
    "gauges": {f"{name} {i}": {"type": "displacement", "over": [[x0 + i * 20, y], [x0 + (i + 1) * 20, y]], "direction": [0, 1]}
               for name, x0, y in (("left", 0, 0), ("top", 180, 100)) for i in range(4)} | {
        "turn": {"type": "rotation", "over": TOP}},
}


def with_plates(deck, **patches):
    out = copy.deepcopy(deck)
    out["supports"] |= {f"{name} plate": {"over": over, "fix": "straight"} for name, over in patches.items()}
    return out


class Plates(ProgramCase):
    def bare_and_plated(self, deck):
        plates = with_plates(deck, left=LEFT, top=TOP)
        return ddapath.run(deck, folder=self.folder / "bare"), ddapath.run(plates, folder=self.folder / "plated")

    def departures(self, run, name):
        """Of the means of the four quarters of a patch from the straight line closest to them."""
        means = run.curve[[f"{name} {i}" for i in range(4)]].iloc[-1].to_numpy()
        place = np.arange(4)
        return np.abs(means - np.polyval(np.polyfit(place, means, 1), place)).max()

    def test_they_stay_straight_and_turn(self):
        bare, plated = self.bare_and_plated(PAD)
        for name in ("left", "top"):
            self.assertGreater(self.departures(bare, name), 1e-3)
            self.assertLess(self.departures(plated, name), 2e-3 * self.departures(bare, name), name)
        self.assertGreater(abs(plated.curve["turn"].iloc[-1]), 1e-3)
        for name in ("left.x", "left.y", "right"):  # statics
            self.assertAlmostEqual(plated.curve[name].iloc[-1], bare.curve[name].iloc[-1], delta=1e-6)
        self.assertEqual([name for name in plated.curve if "plate" in name], [])
        self.assertTrue(all(finding.holds for finding in verify(plated.folder)))

    def test_what_is_straight_already_stays_what_it_is(self):
        even = copy.deepcopy(PAD)
        even["supports"] = {"left": {"boundary": "end", "fix": "x"}, "corner": {"at": [0, 0], "fix": "y"}}
        even["scene"]["boundaries"] = {"end": [[0, 0], [0, 100]], "other": [[400, 0], [400, 100]]}
        even["stages"] = [{"loads": [{"type": "edge_traction", "boundary": "other", "pressure": 1}]}]
        bare, plated = self.bare_and_plated(even)
        for name in bare.curve:
            if name.startswith(("left ", "top ")):
                self.assertAlmostEqual(plated.curve[name].iloc[-1], bare.curve[name].iloc[-1], delta=1e-9, msg=name)

    def test_it_needs_a_patch(self):
        deck = copy.deepcopy(PAD)
        deck["supports"]["plate"] = {"at": [0, 0], "fix": "straight"}
        with self.assertRaisesRegex(ddapath.InputError, "`fix: straight` needs a patch"):
            ddapath.run(deck, folder=self.folder / "run")


if __name__ == "__main__":
    unittest.main()
