"""Decks that are built on others: from the files to what a user sees.

    test_extends.py      with PYTHONPATH=python, and DDA naming the program
"""

import unittest

import ddapath
from program_case import ProgramCase

BASE = """\
title: A bar
variables: {ft: 3, L: 100}
scene: {type: geo, file: bar.geo, subdivision: triangles}
thickness: L
materials: {concrete: {type: linear_elastic, young_modulus: 3e4, poisson_ratio: 0}}
interfaces: {crack: {law: {type: linear_softening, tensile_strength: ft, fracture_energy: 0.1}}}
supports: {wall: {boundary: left, fix: xy}}
stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]
gauges: {elongation: {type: relative_displacement, from: [0, L/2], to: [L, L/2]}}
path: {stop: {load_below: 0.1}}
"""

GEO = """\
DefineConstant[ L = 50 ];
Point(1) = {0, 0, 0, L/4}; Point(2) = {L/2, 0, 0, L/4}; Point(3) = {L/2, L, 0, L/4}; Point(4) = {0, L, 0, L/4};
Point(5) = {L, 0, 0, L/4}; Point(6) = {L, L, 0, L/4};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {2, 5}; Line(6) = {5, 6}; Line(7) = {6, 3};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, -2}; Plane Surface(2) = {2};
Physical Surface("material:concrete") = {1, 2};
Physical Curve("interface:crack") = {2}; Physical Curve("boundary:left") = {4}; Physical Curve("boundary:right") = {6};
"""


class Extends(ProgramCase):
    def setUp(self):
        super().setUp()
        (self.folder / "base").mkdir()
        self.write("base/bar.geo", GEO)
        self.write("base/bar.yaml", BASE)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def peak(self, *options):
        self.dda("run", "deck.yaml", "--folder", "run", "--overwrite", "--quiet", *options)
        return ddapath.read_run(self.folder / "run").summary["peak"]["load"]

    def test_keys_add_up_and_files_are_found_beside_the_base(self):
        self.write("deck.yaml", "extends: base/bar.yaml\nvariables: {ft: 2}\nthickness: 10\n")
        self.assertAlmostEqual(self.peak() / (2 * 100 * 10), 1, delta=1e-9)
        self.assertAlmostEqual(self.peak("--set", "variables.ft=1") / (1 * 100 * 10), 1, delta=1e-9)
        effective = (self.folder / "run/effective_deck.yaml").read_text(encoding="utf-8")
        self.assertNotIn("extends", effective)
        self.assertIn("title: A bar\n", effective)

    def test_errors_name_the_file_in_which_they_stand(self):
        self.write("deck.yaml", "extends: base/bar.yaml\ninterfaces: {crack: {law: {tensile_strenght: 2}}}\n")
        said = self.dda("run", "deck.yaml", code=2)
        self.assertIn("deck.yaml:2:28: unknown parameter 'tensile_strenght'", said)
        self.write("base/bar.yaml", BASE.replace("thickness: L", "thickness: LL"))
        said = self.dda("run", "deck.yaml", code=2)
        self.assertIn("base/bar.yaml:4:12: thickness: expected a number, found 'LL': 'LL' is no variable; did you mean 'L'?", said)

    def test_variables_that_only_the_base_has_used_are_none_too_many(self):
        self.write("deck.yaml", "extends: base/bar.yaml\ninterfaces: {crack: {law: {tensile_strength: 1}}}\n")
        self.assertAlmostEqual(self.peak() / (1 * 100 * 100), 1, delta=1e-9)

    def test_a_base_that_is_not_there_is_refused(self):
        self.write("deck.yaml", "extends: base/bra.yaml\n")
        self.assertIn("deck.yaml:1:10: extends: no such file 'base/bra.yaml'", self.dda("check", "deck.yaml", code=2))
        self.write("deck.yaml", "extends: base/bar.yaml\n")
        self.assertIn("cannot be set", self.dda("check", "deck.yaml", "--set", "extends=base/bar.yaml", code=2))

    def test_are_swept(self):
        self.write("deck.yaml", "extends: base/bar.yaml\nsweep: {variables.ft: [1, 2], thickness: [L, ft]}\n")
        self.dda("run", "deck.yaml", "--quiet", "--folder", "all")
        loads = [round(load) for load in ddapath.read_sweep(self.folder / "all")["peak.load"]]
        self.assertEqual(loads, [10000, 100, 20000, 400])
        self.write("sweep.yaml", "sweep: {deck: deck.yaml, variables.ft: [1, 2]}\n")
        self.write("deck.yaml", "extends: base/bar.yaml\nthickness: 1\n")
        self.dda("sweep", "sweep.yaml", "--quiet", "--folder", "named")
        loads = [round(load) for load in ddapath.read_sweep(self.folder / "named")["peak.load"]]
        self.assertEqual(loads, [100, 200])

    def test_a_run_goes_on(self):
        self.write("deck.yaml", "extends: base/bar.yaml\n")
        self.dda("run", "deck.yaml", "--folder", "whole", "--quiet")
        self.dda("run", "deck.yaml", "--folder", "part", "--quiet", "--set", "path.stop.after_steps=4")
        self.dda("resume", "part", "--quiet", "--set", "path.stop.after_steps=0")
        curves = [(self.folder / name / "curve.csv").read_bytes() for name in ("whole", "part")]
        self.assertEqual(*curves)


if __name__ == "__main__":
    unittest.main()
