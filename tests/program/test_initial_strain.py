"""Strains without stress and rigid platens: from the deck to what a user sees, against closed forms.

    test_initial_strain.py      with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import ddapath
from ddapath.verify import verify
from program_case import ProgramCase

# A bar between two stiff supports that cools by 1e-5 · 40 in full.
COOLED = """\
title: A bar that is held at both ends cools and cracks
units: {length: mm, force: N}
variables: {E: 30000, alpha: 1e-5, cooling: -40}
scene:
  regions:
    - {name: left, material: concrete, vertices: [[0, 0], [100, 0], [100, 100], [0, 100]]}
    - {name: right, material: concrete, vertices: [[100, 0], [200, 0], [200, 100], [100, 100]]}
  curves: {joint: [[100, 0], [100, 100]]}
  boundaries: {west: [[0, 0], [0, 100]], east: [[200, 0], [200, 100]]}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: E, poisson_ratio: 0}}
interfaces: {joint: {law: {type: linear_softening, tensile_strength: 3, fracture_energy: 0.06}}}
supports:
  west: {boundary: west, fix: x}
  east: {boundary: east, fix: x}
  corner: {at: [0, 0], fix: y}
stages: [{name: cooling, loads: [{type: initial_strain, expansion: alpha, temperature: cooling}]}]
gauges:
  opening: {type: relative_displacement, from: [100, 50], from_inside: [99, 50], to: [100, 50], to_inside: [101, 50], direction: [1, 0]}
  stress: {type: stress, regions: [left, right], component: xx}
  strain: {type: strain, at: [50, 50], component: xx}
path: {stop: {load_factor_above: 1}}
"""

# Two columns of different stiffness under one plate that stays level.
PRESSED = """\
title: Two columns under a platen
units: {length: mm, force: N}
scene:
  regions:
    - {name: soft, material: soft, vertices: [[0, 0], [10, 0], [10, 40], [0, 40]]}
    - {name: stiff, material: stiff, vertices: [[10, 0], [30, 0], [30, 40], [10, 40]]}
  boundaries: {foot: [[0, 0], [30, 0]], head: [[0, 40], [30, 40]]}
  slits: {between: [[10, 0], [10, 40]]}
thickness: 2
materials:
  soft: {type: linear_elastic, young_modulus: 100, poisson_ratio: 0}
  stiff: {type: linear_elastic, young_modulus: 400, poisson_ratio: 0}
supports: {foot: {boundary: foot, fix: xy}}
stages: [{loads: [{type: prescribed_displacement, name: platen, boundary: head, direction: [0, -1], displacement: 0.1}]}]
gauges:
  left: {type: displacement, at: [0, 40], direction: [0, -1]}
  right: {type: displacement, at: [30, 40], direction: [0, -1]}
  pressure: {type: stress, regions: [stiff], component: yy}
path: {control: load, stop: {load_factor_above: 1}, step: {first: 1}}
"""

# A free bar of blocks of second order as high as it.
BENT = """\
title: A bar that is strained without stress on one side
units: {length: m, force: N}
thickness: 1
kinematics: second_order
scene:
  regions: [{name: bar, material: c, vertices: [[0, 0], [4, 0], [4, 1], [0, 1]]}]
  boundaries: {left: [[0, 0], [0, 1]], right: [[4, 0], [4, 1]]}
  subdivision: {type: grid, columns: 4, rows: 1}
materials: {c: {type: linear_elastic, young_modulus: 1000, poisson_ratio: 0.25}}
interfaces: {joints: {between: [c, c], treatment: consistent}}
supports: {corner: {at: [0, 0], fix: xy}, above: {at: [0, 1], fix: x}}
stages: [LOADS]
gauges:
  stress: {type: stress, at: [2.1, 0.8], component: xx}
  strain: {type: strain, at: [2.1, 0.8], component: xx}
  across: {type: stress, at: [2.1, 0.8], component: zz}
  drop: {type: displacement, at: [4, 0], direction: [0, -1]}
plane: strain
path: {control: load, stop: {load_factor_above: 1}}
"""


class Computed(ProgramCase):
    def run_deck(self, text, *options, folder="run"):
        (self.folder / "deck.yaml").write_text(text, encoding="utf-8")
        self.dda("run", "deck.yaml", "--folder", folder, "--overwrite", "--quiet", "--threads", "1", *options)
        return ddapath.read_run(self.folder / folder)

    def refusals(self, folder="run"):
        return [str(finding) for finding in verify(self.folder / folder) if not finding.holds]


class InitialStrain(Computed):
    def test_of_a_held_bar_cracks_it_along_the_closed_form(self):
        run = self.run_deck(COOLED)
        curve = run.curve
        of_support = 2 * 1e5 * 30000 * 100  # two springs of support_stiffness · E · thickness each
        flexibility = 200 / 30000 + 2 * 1e4 / of_support
        strength, critical = 3.0, 2 * 0.06 / 3.0
        softened = 0
        for _, row in curve.iterrows():
            shortened = row.load_factor * 1e-5 * 40 * 200
            intact = shortened / flexibility
            if row.dissipated_energy < 1e-9:
                self.assertAlmostEqual(row.stress, intact, delta=1e-9 * strength)
                continue
            cracking = max(0.0, (critical - shortened) / (critical / strength - flexibility))
            self.assertAlmostEqual(row.stress, cracking, delta=1e-7 * strength)
            softened += cracking < 0.9 * strength
        self.assertGreater(softened, 2)
        self.assertAlmostEqual(curve.dissipated_energy.iloc[-1] / (0.06 * 1e4), 1, delta=1e-9)
        self.assertEqual(self.refusals(), [])

    def test_of_a_free_body_leaves_no_stress(self):
        free = COOLED.replace("west: {boundary: west, fix: x}", "west: {at: [0, 0], fix: x}") \
                     .replace("east: {boundary: east, fix: x}", "east: {at: [200, 0], fix: y}")
        for plane, beside, of_all in (("stress", "strain", -4e-4), ("strain", "stress", 30000 * 4e-4)):
            gauges = f"  beside: {{type: {beside}, at: [50, 50], component: zz}}\n"
            run = self.run_deck(free.replace("path:", gauges + "path:") + f"plane: {plane}\n", "--set", "materials.concrete.poisson_ratio=0.2",
                                "--set", "path.control=load")
            last = run.curve.iloc[-1]
            held = 1.2 if plane == "strain" else 1.0  # αT of all directions, of which the third is held
            self.assertAlmostEqual(last.strain / (-held * 4e-4 * last.load_factor), 1, delta=1e-9)
            self.assertLess(abs(last.stress), 1e-9 * 30000 * 4e-4)
            self.assertAlmostEqual(last.beside / (of_all * last.load_factor), 1, delta=1e-9)
            self.assertEqual(self.refusals(), [])

    def bent(self, *loads, options=()):
        """A bar of second order under these loads at a load factor of 1, and the largest stress at its corners."""
        run = self.run_deck(BENT.replace("LOADS", f"{{loads: [{', '.join(loads)}]}}"), *options)
        self.assertEqual(self.refusals(), [])
        return run.curve.iloc[-1], run.fields().vertices["stress_at_vertices_xx"].abs().max()

    def test_linear_in_a_block_of_second_order_bends_it_without_stress(self):
        warmed = "{type: initial_strain, xx: 0.001*y}"
        for treatment in ("consistent", "penalty"):
            last, largest = self.bent(warmed, options=("--set", f"interfaces.joints.treatment={treatment}"))
            self.assertAlmostEqual(last["drop"], 0.001 * 4**2 / 2, delta=1e-9)
            self.assertAlmostEqual(last.strain, 0.0008, delta=1e-9)
            self.assertLess(max(abs(last.stress), abs(last.across), largest), 1e-6)
        last, largest = self.bent("{type: initial_strain, expansion: 0.001, temperature: y}")
        self.assertAlmostEqual(last["drop"], 1.25 * 0.001 * 4**2 / 2, delta=1e-9)
        self.assertLess(max(abs(last.stress), largest), 1e-6)
        self.assertAlmostEqual(last.across, -1000 * 0.001 * 0.8, delta=1e-6)

    def test_linear_stress_bears_linear_tractions_at_rest(self):
        prestress = '{type: initial_stress, xx: 2*y}'
        tractions = [f'{{type: edge_traction, boundary: {side}, traction: ["{sign}*2*y", 0]}}' for side, sign in (("right", 1), ("left", -1))]
        last, largest = self.bent(prestress, *tractions)
        self.assertAlmostEqual(last.stress, 1.6, delta=1e-8)
        self.assertAlmostEqual(largest, 2, delta=1e-8)
        self.assertLess(max(abs(last.strain), abs(last["drop"])), 1e-9)
        last, largest = self.bent(prestress)
        self.assertLess(max(abs(last.stress), largest), 1e-8)
        self.assertAlmostEqual(last.strain, -(1 - 0.25**2) * 1.6 / 1000, delta=1e-10)

    def test_misspelt_or_incomplete_is_told(self):
        for wrong, told in ((COOLED.replace("temperature: cooling", "temprature: cooling"), "temperature"),
                            (COOLED.replace(", temperature: cooling}", ", regions: [wall]}").replace(", cooling: -40", ""), "go together"),
                            (COOLED.replace("temperature: cooling}", "temperature: cooling, regions: [wall]}"), "unknown region 'wall'"),
                            (COOLED.replace("component: xx}\npath", "component: yx}\npath"), "component"),
                            (COOLED.replace("component: xx}\n  strain", "component: zz}\n  strain"), "0 in plane stress"),
                            (COOLED.replace("component: xx}\npath", "component: zz}\npath") + "plane: strain\n", "0 in plane strain")):
            (self.folder / "deck.yaml").write_text(wrong, encoding="utf-8")
            said = self.dda("check", "deck.yaml", code=2)
            self.assertIn(told, said)
            self.assertRegex(said, r"deck\.yaml:\d+")


class Platen(Computed):
    def test_keeps_a_boundary_level_and_bears_what_the_columns_do(self):
        last = self.run_deck(PRESSED).curve.iloc[-1]
        # Springs of supports and platen in series with each column, all as stiff as the length that they stand for.
        self.assertAlmostEqual(last.left / last.right, 1, delta=1e-3)
        self.assertAlmostEqual(last.right / 0.1, 1, delta=1e-3)
        self.assertAlmostEqual(last.platen / (2 * (10 * 100 + 20 * 400) * 0.1 / 40), 1, delta=1e-3)
        self.assertAlmostEqual(last.pressure / (-400 * 0.1 / 40), 1, delta=1e-3)
        self.assertEqual(self.refusals(), [])

    def test_a_boundary_that_there_is_not(self):
        (self.folder / "deck.yaml").write_text(PRESSED.replace("boundary: head", "boundary: hed"), encoding="utf-8")
        said = self.dda("check", "deck.yaml", code=2)
        self.assertIn("'hed'", said)
        self.assertIn("head", said)


if __name__ == "__main__":
    unittest.main()
