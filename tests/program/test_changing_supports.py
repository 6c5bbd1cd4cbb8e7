"""Supports that stages take away and put in: what is left is the structure without them, along a path that cracks may follow.

    test_changing_supports.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import sys
import unittest
from pathlib import Path

import numpy as np

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase
from test_stages import PLATE, PULL, stage, with_stages

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "robustness"))

from masonry_structures import arch_blocks, arch_loaded  # noqa: E402

WEIGHT = [{"type": "body_force", "force": [0, -1e-3]}]
PROP = {"over": [[300, 0], [300, 100]], "fix": "y"}
STRUCK = stage("struck", [{"type": "support_removal", "support": "prop"}], {"load_factor": 1})


def propped(*stages, support=PROP):
    """The cantilever of test_stages with a prop under its end."""
    out = with_stages(PLATE, *stages, supports={"prop": support})
    out["gauges"] = PLATE["gauges"] | {"borne": {"type": "reaction", "of": "prop"}}
    return out


def cracking(ft=3.0):
    """The same of two blocks, between which a joint may crack."""
    deck = propped(stage("weight", WEIGHT), STRUCK)
    deck["scene"] |= {"curves": {"middle": [[150, 0], [150, 100]]}, "subdivision": {"type": "grid", "columns": 12, "rows": 6}}
    law = {"type": "linear_softening", "tensile_strength": ft, "fracture_energy": 0.05}
    deck["interfaces"] = {"middle": {"law": law}}
    deck["path"] = {"stop": {"load_below": 0.6}}
    return deck


class ChangingSupports(ProgramCase):
    def followed(self, deck, name="run", status="goal_reached"):
        run = ddapath.run(deck, folder=self.folder / name, check=False)
        self.assertEqual(run.summary["status"], status, run.summary["reason"])
        refused = [f"{found.check}: {found.worst} at {found.place}" for found in verify(run.folder) if not found.holds]
        self.assertEqual(refused, [])
        return run

    def moved(self, run):
        return run.fields(run.steps[-1]).vertices[["displacement_x", "displacement_y"]].to_numpy()

    def test_what_is_left_is_the_structure_without(self):
        free = self.moved(self.followed(with_stages(PLATE, stage("weight", WEIGHT, {"load_factor": 1})), "free"))
        for name, support in (("patch", PROP), ("boundary", {"boundary": "end", "fix": "y"}), ("point", {"at": [300, 0], "fix": "y"})):
            with self.subTest(name):
                run = self.followed(propped(stage("weight", WEIGHT), STRUCK, support=support), name)
                np.testing.assert_allclose(self.moved(run), free, atol=1e-9 * np.abs(free).max())
                curve = run.curve
                borne = curve["borne"].iloc[0]
                self.assertGreater(borne, 0.3 * 300 * 100 * 10 * 1e-3)
                np.testing.assert_allclose(curve["borne"], borne * (1 - curve["load_factor"]), atol=1e-9 * borne)
                if name != "boundary":
                    np.testing.assert_allclose(curve["load"], borne * curve["load_factor"], atol=1e-9 * borne)
                self.assertLess(run.summary["energy_balance_error"], 1e-8)

    def test_stages_go_on_without_it(self):
        """Half of it is let go, a load comes, and the rest of the prop is not there to bear it."""
        half = copy.deepcopy(STRUCK) | {"until": {"load_factor": 0.5}}
        run = self.followed(propped(stage("weight", WEIGHT), half, stage("pull", PULL, {"load_factor": 1})), "half")
        borne = run.curve["borne"]
        np.testing.assert_allclose(borne[run.curve["stage"] == 3], borne[0] / 2, rtol=1e-9)
        force = [{"type": "point_load", "over": PROP["over"], "force": [0, float(borne[0]) / 2]}]
        same = with_stages(PLATE, stage("weight", WEIGHT), stage("held", force), stage("pull", PULL, {"load_factor": 1}))
        expected = self.moved(self.followed(same, "same"))
        np.testing.assert_allclose(self.moved(run), expected, atol=1e-9 * np.abs(expected).max())

    def test_a_support_is_put_in_and_goes_again(self):
        """What acted before moved the structure without it; what it bears of a load comes back when it goes."""
        weight, pull = stage("weight", WEIGHT), stage("pull", PULL, {"load_factor": 1})
        late = PROP | {"from": "pull"}
        free = self.moved(self.followed(with_stages(PLATE, weight | {"until": {"load_factor": 1}}), "free"))
        pulled = self.moved(self.followed(with_stages(PLATE, pull), "pulled"))
        held = self.moved(self.followed(propped(pull), "held"))
        run = self.followed(propped(weight, pull, support=late), "late")
        np.testing.assert_allclose(self.moved(run), free + held, atol=1e-9 * np.abs(free).max())
        self.assertAlmostEqual(run.curve["borne"].iloc[0], 0, delta=1e-7 * np.abs(run.curve["borne"]).max())
        run = self.followed(propped(weight, pull, STRUCK, support=late), "again")
        np.testing.assert_allclose(self.moved(run), free + pulled, atol=1e-9 * np.abs(free).max())
        self.assertLess(run.summary["energy_balance_error"], 1e-8)

    def test_a_joint_cracks_as_the_prop_goes(self):
        """Elastic up to a strength that is enough; a weak joint opens, and past its peak too little is let go."""
        strong, weak = self.followed(cracking(), "strong"), self.followed(cracking(0.12), "weak")
        self.assertEqual(strong.summary["dissipated_energy"], 0)
        self.assertAlmostEqual(strong.curve["load_factor"].iloc[-1], 1, delta=1e-12)
        self.assertLess(weak.curve["load_factor"].max(), 0.6)
        self.assertGreater(weak.summary["dissipated_energy"], 0)
        self.assertIn("load below 60 % of its peak", weak.summary["reason"])

    def arch(self, treatment, thickness=75):
        """Of nine voussoirs on a centring that is struck before it is loaded, and the load of its collapse with 75 mm."""
        case, blocks = arch_loaded(9, 75, treatment), arch_blocks(9, thickness)
        deck = case.deck
        for region, (_, corners) in zip(deck["scene"]["regions"], blocks):
            region["vertices"] = corners
        deck["scene"]["boundaries"] = {"right": blocks[0][1][:2], "left": blocks[-1][1][2:],
                                       "intrados": [corners[0] for _, corners in blocks][1:]}
        deck["supports"]["centring"] = {"boundary": "intrados", "fix": "normal"}
        deck["stages"].insert(1, stage("struck", [{"type": "support_removal", "support": "centring"}], {"load_factor": 1}))
        return deck, case.expected["peak"]

    def test_an_arch_too_thin_falls(self):
        """What is left of a centring that an arch cannot do without is let go with the motion."""
        deck, _ = self.arch("consistent", thickness=8)
        deck |= {"path": {"then": "motion"}, "motion": {"time": 0.4}}
        for material in deck["materials"].values():
            material["density"] = 2.4e-9
        run = self.followed(deck, "thin", status="stopped_early")
        self.assertIn("mechanism", run.summary["reason"])
        self.assertLess(run.curve["load_factor"].max(), 1)
        self.assertGreater(np.abs(run.motion.curve["drift"].iloc[-1]), 50)

    def test_an_arch_on_its_own(self):
        """Voussoirs that only touch find their thrust as the centring goes, and bear as much as limit analysis says."""
        for treatment in ("consistent", "penalty", "lagrange", "augmented_lagrangian"):
            with self.subTest(treatment):
                deck, (expected, tolerance) = self.arch(treatment)
                run = self.followed(deck, treatment)
                self.assertAlmostEqual(run.curve["load"][run.curve["stage"] == 3].max(), expected, delta=tolerance)

    def test_goes_on_where_it_was_killed(self):
        deck = cracking(0.12)
        whole = self.followed(deck, "whole")
        for steps in (1, 2, 5):
            part = ddapath.run(deck, folder=self.folder / f"part-{steps}", check=False, settings={"path.stop.steps": steps})
            run = ddapath.resume(part.folder, settings={"path.stop.steps": 1000}, check=False)
            self.assertEqual(run.curve.to_csv(), whole.curve.to_csv())

    def test_a_wall_over_an_opening_carries_on(self):
        """Joints open and close while they slide: one that wants to open when it is closed and to close when it is open leaves the
        path to others, which unload there."""
        run = self.followed(Path(__file__).parent / "wall_over_opening.yaml", "opening")
        left, right = run.curve["left.y"].iloc[-1], run.curve["right.y"].iloc[-1]
        self.assertAlmostEqual(left / right, 1, delta=1e-6)  # it is symmetric
        self.assertAlmostEqual(run.curve["sag"].iloc[-1], 5, delta=1e-9)
        self.assertEqual(run.summary["rescues"], 0)

    def test_wrong_decks(self):
        weight = stage("weight", WEIGHT)
        known = {
            "unknown support 'porp'; did you mean 'prop'?": [weight, stage("s", [{"type": "support_removal", "support": "porp"}], {"load_factor": 1})],
            "the stage needs `until: {load_factor: 1}`": [weight, STRUCK | {"until": {"borne": 0}}],
            "bears nothing before the first stage": [STRUCK],
            "has been taken away before": [weight, STRUCK, STRUCK | {"name": "again"}],
            "is put in by no stage before this one": [weight, STRUCK],
            "no support holds": [weight, stage("s", [{"type": "support_removal", "support": "wall"}], {"load_factor": 1})],
        }
        for message, stages in known.items():
            support = PROP | {"from": "struck"} if "put in" in message else PROP
            with self.subTest(message), self.assertRaises(ddapath.InputError) as raised:
                ddapath.run(propped(*stages, support=support), folder=self.folder / "wrong")
            self.assertIn(message, str(raised.exception))


if __name__ == "__main__":
    unittest.main()
