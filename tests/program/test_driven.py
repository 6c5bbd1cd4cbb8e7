"""Places that loads drive, by one stage or several, and what holds them.

    test_driven.py        with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import ddapath

from test_stages import PLATE, PULL, StageCase, stage, with_stages


class Driven(StageCase):
    def test_what_is_driven_is_driven_on_and_back(self):
        """One platen for all stages that move it: displacements add up, whatever the sense of the direction."""
        there = {"type": "prescribed_displacement", "boundary": "end", "direction": [1, 0], "displacement": 0.01, "name": "jack"}
        back = there | {"direction": [-1, 0], "displacement": 0.03}
        up = {key: value for key, value in there.items() if key != "name"} | {"direction": [0, 1]}
        del back["name"]
        deck = with_stages(PLATE, stage("there", [there], {"load_factor": 1}), stage("back", [back], {"load_factor": 1}),
                           stage("up", [up], {"load_factor": 1}))
        run = self.followed(deck)
        ends = [run.curve[run.curve.stage == number].iloc[-1] for number in (1, 2, 3)]
        for end, x, y in zip(ends, (0.01, -0.02, -0.02), (0, 0, 0.01)):
            self.assertAlmostEqual(end.x, x, delta=1e-4 * 0.01)
            self.assertAlmostEqual(end.y, y, delta=1e-4 * 0.01)
        self.assertAlmostEqual(ends[1].jack / ends[0].jack, -2, delta=1e-8)
        self.assertAlmostEqual(ends[1].load, -ends[1].jack, delta=1e-8 * abs(ends[1].jack))
        self.assertAlmostEqual(ends[2].load, ends[2].driven, delta=1e-8 * abs(ends[2].driven))
        self.assertAlmostEqual(ends[2]["wall.x"], -ends[2].jack, delta=1e-8 * abs(ends[2].jack))
        self.assert_energies_balance(run)
        self.assert_verified(run)

    def test_what_fights_is_refused(self):
        drive = {"type": "prescribed_displacement", "boundary": "end", "direction": [1, 0]}
        held = drive | {"boundary": "wall"}
        for loads, said in (([[drive, drive | {"direction": [-2, 0]}]], "another load of the stage"),
                            ([[held]], "support 'wall' holds what this load drives"),
                            ([[drive | {"name": "a"}], [drive | {"name": "b"}]], "goes on as 'a', or without a name")):
            deck = with_stages(PLATE, *(stage(f"s{i}", some, {"load_factor": 1}) for i, some in enumerate(loads)))
            with self.assertRaisesRegex(ddapath.InputError, said):
                self.followed(deck)

    def test_a_held_rotation_takes_a_moment(self):
        deck = with_stages(PLATE, stage("pull", PULL, {"load_factor": 1}))
        deck["supports"] = {"wall": {"over": [[0, 0], [0, 100]], "fix": "xy"}, "turn": {"over": [[0, 0], [0, 100]], "fix": "rotation"}}
        deck["gauges"] = {"moment": {"type": "reaction", "of": "turn"}}
        units = self.followed(deck).curve.attrs["units"]
        self.assertEqual([units[name] for name in ("turn", "moment", "wall.x")], ["N·mm", "N·mm", "N"])


if __name__ == "__main__":
    unittest.main()
