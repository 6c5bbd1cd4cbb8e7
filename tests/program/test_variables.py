"""Decks that compute: variables and expressions from the deck to what a user sees.

    test_variables.py      with PYTHONPATH=python, and DDA naming the program
"""

import json
import shutil
import unittest

import ddapath
from program_case import ProgramCase

BAR = """\
variables: {f: ft, ft: 3, L: 100, b: L/2}
scene:
  regions:
    - {name: left, material: concrete, vertices: [[0, 0], [L/2, 0], [L/2, L], [0, L]]}
    - {name: right, material: concrete, vertices: [[L/2, 0], [L, 0], [L, L], [L/2, L]]}
  curves: {crack: [[L/2, 0], [L/2, L]]}
  boundaries: {left: [[0, 0], [0, L]], right: [[L, 0], [L, L]]}
thickness: 2*b
materials: {concrete: {type: linear_elastic, young_modulus: 3e4, poisson_ratio: 0}}
interfaces: {crack: {law: {type: linear_softening, tensile_strength: f, fracture_energy: "max(0.1, ft/100)"}}}
supports: {wall: {boundary: left, fix: xy}}
stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]
gauges: {elongation: {type: relative_displacement, from: [0, L/2], to: [L, L/2]}}
path: {stop: {load_below: 1/10}}
record: {fields_every: 2*5}
"""

GEO = """\
DefineConstant[ depth = {50, Name "bar/depth"}, size = 20 ];
half = 50;
Point(1) = {0, 0, 0, size}; Point(2) = {half, 0, 0, size}; Point(3) = {half, depth, 0, size}; Point(4) = {0, depth, 0, size};
Point(5) = {2*half, 0, 0, size}; Point(6) = {2*half, depth, 0, size};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {2, 5}; Line(6) = {5, 6}; Line(7) = {6, 3};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, -2}; Plane Surface(2) = {2};
Physical Surface("material:concrete/left") = {1}; Physical Surface("material:concrete/right") = {2};
Physical Curve("interface:crack") = {2}; Physical Curve("boundary:left") = {4}; Physical Curve("boundary:right") = {6};
"""


class Variables(ProgramCase):
    def write(self, text, name="deck.yaml"):
        (self.folder / name).write_text(text, encoding="utf-8")

    def run_deck(self, *options, deck="deck.yaml", folder="run"):
        self.dda("run", deck, "--folder", folder, "--overwrite", "--quiet", *options)
        return ddapath.read_run(self.folder / folder)

    def peak(self, *options):
        return self.run_deck(*options).summary["peak"]["load"]

    def test_stand_for_numbers(self):
        self.write(BAR)
        self.assertAlmostEqual(self.peak() / (3 * 100 * 100), 1, delta=1e-9)
        said = self.dda("check", "deck.yaml")
        self.assertIn("b = 50", said)
        self.assertIn("f = 3", said)

    def test_are_set_from_the_command_line(self):
        self.write(BAR)
        self.assertAlmostEqual(self.peak("--set", "variables.ft=2") / (2 * 100 * 100), 1, delta=1e-9)
        self.assertAlmostEqual(self.peak("--set", "variables.L=200") / (3 * 200 * 200), 1, delta=1e-9)
        self.assertAlmostEqual(self.peak("--set", "thickness=b/4") / (3 * 100 * 12.5), 1, delta=1e-9)
        said = self.dda("run", "deck.yaml", "--set", "variables.fd=2", code=2)
        self.assertIn("--set variables.fd: variables: 'fd' is used nowhere; did you mean 'f'?", said)

    def test_what_a_setting_replaces_has_been_used(self):
        self.write(BAR)
        self.assertAlmostEqual(self.peak("--set", "interfaces.crack.law.tensile_strength=1", "--set",
                                         "interfaces.crack.law.fracture_energy=0.1") / (1 * 100 * 100), 1, delta=1e-9)

    def test_the_effective_deck_has_numbers_and_starts_the_same_run(self):
        self.write(BAR)
        self.run_deck()
        effective = (self.folder / "run/effective_deck.yaml").read_text(encoding="utf-8")
        self.assertNotIn("variables", effective)
        self.assertIn("thickness: 100\n", effective)
        shutil.copy(self.folder / "run/effective_deck.yaml", self.folder / "again.yaml")
        self.run_deck(deck="again.yaml", folder="again")
        curves = [(self.folder / name / "curve.csv").read_bytes() for name in ("run", "again")]
        self.assertEqual(*curves)

    def test_a_run_goes_on_with_the_same_bits(self):
        self.write(BAR)
        self.run_deck(folder="whole")
        self.dda("run", "deck.yaml", "--folder", "part", "--quiet", "--set", "path.stop.after_steps=2*2")
        self.dda("resume", "part", "--quiet", "--set", "path.stop.after_steps=0")
        curves = [(self.folder / name / "curve.csv").read_bytes() for name in ("whole", "part")]
        self.assertEqual(*curves)
        said = self.dda("resume", "part", "--set", "variables.L=200", code=2)
        self.assertIn("'L' is used nowhere", said)

    def test_are_swept(self):
        self.write(BAR)
        self.dda("sweep", "deck.yaml", "--quiet", "--folder", "by", "--set", "sweep.variables.ft=[1, 4/2, L/25]")
        table = ddapath.read_sweep(self.folder / "by")
        self.assertEqual([round(load) for load in table["peak.load"]], [10000, 20000, 40000])
        self.write(BAR + "sweep: {thickness: [t1, t2]}\n".replace("\n", "\n"))
        text = (self.folder / "deck.yaml").read_text(encoding="utf-8").replace("b: L/2}", "b: L/2, t1: 10, t2: 2*t1}")
        self.write(text)
        self.dda("sweep", "deck.yaml", "--quiet", "--folder", "thick")
        table = ddapath.read_sweep(self.folder / "thick")
        self.assertEqual([round(load) for load in table["peak.load"]], [3000, 6000])

    def test_reach_the_geometry(self):
        self.write(GEO, "bar.geo")
        head, tail = BAR[: BAR.index("scene:")], BAR[BAR.index("thickness:"):]
        deck = head.replace("}", ", depth: L/4}") + "scene: {type: geo, file: bar.geo, subdivision: triangles}\n" + tail
        deck = deck.replace("[0, L/2]", "[0, depth/2]").replace("[L, L/2]", "[L, depth/2]")
        self.write(deck)
        run = self.run_deck()
        self.assertAlmostEqual(run.summary["peak"]["load"] / (3 * 25 * 100), 1, delta=1e-6)
        self.assertIn("depth: 25", (self.folder / "run/effective_deck.yaml").read_text(encoding="utf-8"))
        self.write(deck.replace("file: bar.geo,", "file: bar.geo, parameters: {depth: 2*depth, size: depth},"))
        self.assertAlmostEqual(self.peak() / (3 * 50 * 100), 1, delta=1e-6)
        self.write(deck.replace("ft: 3,", "ft: 3, sise: 10,"))
        self.assertIn("'sise' is used nowhere", self.dda("check", "deck.yaml", code=2))

    def test_anchors_have_keys_of_their_own(self):
        law = '{type: linear_softening, tensile_strength: f, fracture_energy: "max(0.1, ft/100)"}'
        self.assertIn(law, BAR)
        self.write("x-law: &law " + law + "\n" + BAR.replace(law, "*law"))
        self.assertAlmostEqual(self.peak() / (3 * 100 * 100), 1, delta=1e-9)
        self.write("y-law: 3\n" + BAR)
        self.assertIn("unknown parameter 'y-law'", self.dda("check", "deck.yaml", code=2))

    def test_misspelt_names_are_told_with_their_place(self):
        self.write(BAR.replace("thickness: 2*b", "thickness: 2*(bb + 1)").replace("tensile_strength: f,", "tensile_strength: ftt/2,"))
        said = self.dda("run", "deck.yaml", code=2)
        self.assertIn("deck.yaml:8:15: thickness: expected a number, found '2*(bb + 1)': 'bb' is no variable; did you mean 'b'?",
                      said)
        self.assertIn("deck.yaml:10:70: tensile_strength: expected a number, found 'ftt/2': 'ftt' is no variable; did you mean "
                      "'ft'?", said)
        self.assertFalse((self.folder / "runs").exists())

    def test_the_manual_and_the_schema_know_them(self):
        said = self.dda("explain", "variables")
        for word in ("sqrt", "atan2", "pi", "--set variables.D=200", "DefineConstant"):
            self.assertIn(word, said)
        schema = json.loads(self.dda("explain", "--json"))
        self.assertEqual(schema["definitions"]["deck"]["properties"]["thickness"]["type"], ["number", "string"])
        self.assertIn("variables", schema["properties"])


if __name__ == "__main__":
    unittest.main()
