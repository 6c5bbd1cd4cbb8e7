"""Loads that vary, couples and masonry: from the deck to what a user sees, against closed forms.

    test_varying_loads.py      with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

DAM = """\
title: A dam on two bearings, water up to a level within a side of a block
units: {length: m, force: kN}
variables: {rho_g: 10, H: 8, B: 6, level: 7.3}
scene:
  regions: [{material: concrete, vertices: [[0, 0], [B, 0], [B/3, H], [0, H]]}]
  boundaries: {upstream: [[0, 0], [0, H]]}
  subdivision: {type: voronoi, blocks: 40}
thickness: 1
materials: {concrete: {type: linear_elastic, young_modulus: 3e7, poisson_ratio: 0.2}}
supports:
  heel: {at: [0, 0], fix: xy}
  toe: {at: [B, 0], fix: y}
stages: [{name: water, loads: [{type: edge_traction, boundary: upstream, pressure: "rho_g*max(0, level - y)"}]}]
gauges: {crest: {type: displacement, at: [0, H], direction: [1, 0]}}
path: {control: load, stop: {load_factor_above: 1}, step: {first: 1}}
"""

CANTILEVER = """\
title: A cantilever that a couple bends
variables: {L: 400, h: 40, b: 20, E: 20000, M: 3e5}
scene:
  regions: [{material: steel, vertices: [[0, 0], [L, 0], [L, h], [0, h]]}]
  boundaries: {wall: [[0, 0], [0, h]]}
  subdivision: {type: grid, columns: 80, rows: 8}
thickness: b
materials: {steel: {type: linear_elastic, young_modulus: E, poisson_ratio: 0}}
supports: {wall: {boundary: wall, fix: xy}}
stages: [{loads: [{type: moment, over: [[L, 0], [L, h]], moment: M}]}]
gauges:
  turn: {type: rotation, over: [[L, 0], [L, h]]}
  turn_of_a_block: {type: rotation, at: [L/2, h/2]}
  rise: {type: displacement, over: [[L, 0], [L, h]], direction: [0, 1]}
path: {control: load, stop: {load_factor_above: 1}, step: {first: 1}}
"""

BENT = """\
title: Two blocks of second order that tractions bend which have no resultant
scene:
  regions:
    - {name: left, material: c, vertices: [[0, 0], [100, 0], [100, 40], [0, 40]]}
    - {name: right, material: c, vertices: [[100, 0], [200, 0], [200, 40], [100, 40]]}
  boundaries: {root: [[0, 0], [0, 40]], end: [[200, 0], [200, 40]]}
thickness: 10
kinematics: second_order
materials: {c: {type: linear_elastic, young_modulus: 1000, poisson_ratio: 0.3}}
supports: {root: {boundary: root, fix: xy}}
stages: [{loads: [{type: edge_traction, boundary: end, traction: ["(y-20)/20", 0]}]}]
gauges: {tip: {type: displacement, at: [200, 20], direction: [0, 1]}}
path: {stop: {load_factor_above: 1}}
"""

WALL = """\
title: A wall with an opening, in a bond
units: {length: m, force: N}
variables: {L: 0.25, h: L/3, W: 8*L, H: 9*h}
scene:
  regions:
    - {name: ground, material: stone, undivided: true, vertices: [[-1, -0.2], [W + 1, -0.2], [W + 1, 0], [-1, 0]]}
    - {name: wall, material: brick, vertices: [[0, 0], [W, 0], [W, H], [0, H]]}
  subdivision: {type: bricks, length: L, height: h, bond: BOND}
thickness: 0.1
materials:
  stone: {type: linear_elastic, young_modulus: 1e9, density: 2000}
  brick: {type: linear_elastic, young_modulus: 1e9, density: 2000}
interfaces:
  beds: {between: [brick, brick], law: {type: friction, friction_angle: 35}, points: vertices}
  base: {between: [brick, stone], law: {type: friction, friction_angle: 35}, points: vertices}
gauges: {top: {type: displacement, at: [W/2, H], direction: [0, -1]}}
motion: {time: 2, held: [ground]}
"""


class Computed(ProgramCase):
    def run_deck(self, text, *options, folder="run"):
        (self.folder / "deck.yaml").write_text(text, encoding="utf-8")
        self.dda("run", "deck.yaml", "--folder", folder, "--overwrite", "--quiet", *options)
        return ddapath.read_run(self.folder / folder)

    def refusals(self):
        return [str(finding) for finding in verify(self.folder / "run") if not finding.holds]


class Water(Computed):
    def test_on_a_dam_has_the_resultant_and_moment_of_hydrostatics(self):
        run = self.run_deck(DAM)
        last = run.curve.iloc[-1]
        thrust, overturning = 10 * 7.3**2 / 2, 10 * 7.3**3 / 6
        self.assertAlmostEqual(last["heel.x"] / (-thrust * last.load_factor), 1, delta=1e-9)
        self.assertAlmostEqual(last["toe"] / (overturning / 6 * last.load_factor), 1, delta=1e-9)
        self.assertAlmostEqual(last["load"] / (thrust * last.load_factor), 1, delta=1e-9)
        self.assertEqual(self.refusals(), [])

    def test_starts_again_from_the_effective_deck(self):
        first = self.run_deck(DAM)
        effective = (self.folder / "run/effective_deck.yaml").read_text(encoding="utf-8")
        self.assertIn("10*max(0, 7.3 - y)", effective)
        second = self.run_deck(effective, folder="again")
        self.assertTrue(first.curve.equals(second.curve))

    def test_misspelt_is_told(self):
        (self.folder / "deck.yaml").write_text(DAM.replace("rho_g*max", "rho_q*max"), encoding="utf-8")
        said = self.dda("check", "deck.yaml", code=2)
        self.assertIn("deck.yaml:13:85: pressure: expected a number or an expression of x and y, found the text 'rho_q*max(0, "
                      "level - y)': 'rho_q' is no variable; did you mean 'rho_g'?", said)


class Couples(Computed):
    def test_bend_a_cantilever_into_an_arc(self):
        run = self.run_deck(CANTILEVER)
        last = run.curve.iloc[-1]
        curvature = 3e5 / (20000 * 20 * 40**3 / 12) * last.load_factor
        self.assertAlmostEqual(last.turn / (curvature * 400), 1, delta=0.02)
        self.assertAlmostEqual(last.turn_of_a_block / (curvature * 200), 1, delta=0.02)
        self.assertAlmostEqual(last.rise / (curvature * 400**2 / 2), 1, delta=0.02)
        self.assertEqual(last.load, last.load_factor)
        self.assertIn('"load": ""', (self.folder / "run/curve.units.json").read_text(encoding="utf-8"))
        self.assertEqual(self.refusals(), [])

    def test_of_tractions_alone_bend_few_blocks(self):
        """Their resultant is rounding, the couple of one is 10 · 40²/6 and stretches no block: neither is what weak springs bear."""
        clamped = BENT.replace("poisson_ratio: 0.3", "poisson_ratio: 0")
        on_both = BENT.replace("supports: {root: {boundary: root, fix: xy}}",
                               "supports: {foot: {at: [0, 20], fix: xy}, low: {at: [0, 0], fix: x}, high: {at: [0, 40], fix: x}}")
        on_both = on_both.replace("0]}]}]", '0]}, {type: edge_traction, boundary: root, traction: ["-(y-20)/20", 0]}]}]')
        for text in (clamped, on_both):
            run = self.run_deck(text)
            self.assertEqual(run.summary["status"], "goal_reached", run.summary["reason"])
            self.assertAlmostEqual(run.curve.tip.iloc[-1] / (-200**2 / (2 * 20 * 1000)), 1, delta=2e-3)
            self.assertEqual(self.refusals(), [])


class Masonry(Computed):
    def test_stands_in_every_bond(self):
        for bond, bricks in (("stack", 72), ("running", 76), ("flemish", 103), ("english", 108)):
            with self.subTest(bond):
                run = self.run_deck(WALL.replace("BOND", bond))
                self.assertTrue(run.summary["is_at_rest"] if "is_at_rest" in run.summary else run.summary["motion"]["is_at_rest"])
                self.assertLess(abs(run.motion.curve.top.iloc[-1]), 1e-3)
                said = self.dda("check", "deck.yaml")
                self.assertIn(f"wall: {bricks} blocks of brick", said)
                self.assertEqual(self.refusals(), [])


if __name__ == "__main__":
    unittest.main()
