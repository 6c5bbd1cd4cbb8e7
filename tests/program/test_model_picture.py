"""Figures in files, as SVG, PNG and PDF: what the model's picture tells, and that a material has one colour in all of them.

    test_model_picture.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import ddapath

SVG = "{http://www.w3.org/2000/svg}"
DECK = {
    "units": {"length": "m", "force": "kN"},
    "scene": {"regions": [{"name": "ground", "material": "rock", "undivided": True, "vertices": [[-1, -0.5], [3, -0.5], [3, 0], [-1, 0]]},
                          {"name": "wall", "material": "stone", "vertices": [[0, 0], [2, 0], [2, 1], [0, 1]]}],
              "boundaries": {"bottom": [[-1, -0.5], [3, -0.5]]}, "subdivision": {"type": "bricks", "length": 0.5, "height": 0.25}},
    "thickness": 1,
    "materials": {name: {"type": "linear_elastic", "young_modulus": 10e6, "density": 2.3} for name in ("rock", "stone")},
    "interfaces": {"joints": {"between": ["stone", "stone"], "law": {"type": "friction", "friction_angle": 35}},
                   "base": {"between": ["rock", "stone"], "law": {"type": "friction", "friction_angle": 35}}},
    "supports": {"ground": {"boundary": "bottom", "fix": "xy"}},
    "stages": [{"name": "weight", "loads": [{"type": "body_force", "regions": ["wall"], "force": [0, -22.6]}]}],
    "gauges": {"crown": {"type": "displacement", "over": [[0, 1], [2, 1]], "direction": [0, 1]},
               "corner": {"type": "displacement", "at": [2, 1], "direction": [1, 0]},
               "tilt": {"type": "rotation", "over": [[0, 1], [2, 1]]},
               "press": {"type": "stress", "regions": ["wall"], "component": "yy"},
               "stretch": {"type": "strain", "at": [1.1, 0.1], "component": "xx"},
               "share": {"type": "load", "scale": 2},
               "thrust": {"type": "reaction", "of": "ground.y"}},
    "path": {"stop": {"load_factor_above": 1}},
    "motion": {"time": 0.05, "held": ["ground"], "gravity": [0, -1.5],
               "driven": [{"regions": ["ground"], "direction": [1, 0],
                           "displacement": {"type": "harmonic", "amplitude": 0.15, "frequency": 1.5}}],
               "velocities": [{"regions": ["wall"], "velocity": [1, 0], "spin": 0.1}]},
}


def program(*arguments):
    return subprocess.run([ddapath.find_program(), *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False)


def texts(svg):
    """Every text of a picture, with the box that its letters take at the least."""
    out = []
    for one in xml.fromstring(svg).iter(f"{SVG}text"):
        x, y, size = (float(one.get(name)) for name in ("x", "y", "font-size"))
        out.append((one.text, (x, y - 0.7 * size, x + 0.45 * size * len(one.text), y)))
    return out


def fills(svg):
    """Colours in which blocks and the legend's swatches are filled."""
    return set(re.findall(r'fill="(#[0-9a-f]{6})" stroke="#a0a0a0"', svg))


class ModelPicture(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.deck = cls.scratch / "deck.yaml"
        ddapath.write_deck(DECK, cls.deck)
        done = program("check", cls.deck, "--svg", cls.scratch / "model.svg")
        if done.returncode != 0:
            raise AssertionError(done.stderr)
        cls.model = (cls.scratch / "model.svg").read_text(encoding="utf-8")
        cls.run_ = ddapath.run(DECK, folder=cls.scratch / "run")

    def names(self):
        return [text for text, _ in texts(self.model)]

    def test_gauges_of_every_kind(self):
        for name in ("crown", "corner", "tilt", "press (mean of 18 blocks)", "stretch", "thrust"):
            self.assertEqual(self.names().count(name), 1, name)
        for text in ("measured", "rotation measured", "strain or stress measured", "of no one place: share"):
            self.assertIn(text, self.names())

    def test_a_mean_is_a_line_along_its_edge(self):
        """The wall's upper side, on which no interface is; it is half as long as the ground."""
        lines = re.findall(r"M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)", " ".join(re.findall(r'd="(M[^"]*)" fill="none" stroke="#0072B2"', self.model)))
        _, top, left, _, right = min((float(y1), float(y1), float(x1), float(y2), float(x2)) for x1, y1, x2, y2 in lines)
        ground = re.search(r'd="(M[^"]*Z)" fill="#dbe9f4"', self.model)[1]
        places = [[float(number) for number in place] for place in re.findall(r"([\d.]+) ([\d.]+)", ground)]
        width = max(x for x, _ in places) - min(x for x, _ in places)
        self.assertAlmostEqual(abs(right - left) / width, 0.5, delta=0.01)
        self.assertAlmostEqual((min(y for _, y in places) - top) / width, 0.25, delta=0.01)

    def test_what_moves(self):
        for text in ("g", "g = 1.5 m/s², of what moves", "held in the motion, or moved as prescribed", "motion prescribed",
                     "velocity at the beginning"):
            self.assertIn(text, self.names())
        self.assertIn("<pattern", self.model)
        deck = copy.deepcopy(DECK)
        del deck["motion"]
        ddapath.write_deck(deck, self.scratch / "still.yaml")
        self.assertEqual(program("check", self.scratch / "still.yaml", "--svg", self.scratch / "still.svg").returncode, 0)
        still = (self.scratch / "still.svg").read_text(encoding="utf-8")
        self.assertNotIn("<pattern", still)
        self.assertEqual([text for text, _ in texts(still)].count("g"), 1)  # the load that pulls downwards

    def test_no_text_covers_another(self):
        boxes = texts(self.model)
        for i, (text, one) in enumerate(boxes):
            for other_text, other in boxes[:i]:
                is_apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
                self.assertTrue(is_apart, (text, other_text))

    def test_materials_have_one_colour_everywhere(self):
        wanted = fills(self.model)
        self.assertEqual(len(wanted), 2)
        for name in ("deformed.svg", "deformed-sliding.svg", "motion/end.svg"):
            svg = (self.run_.folder / name).read_text(encoding="utf-8")
            self.assertEqual(fills(svg), wanted, name)
            self.assertLessEqual({"rock", "stone"}, {text for text, _ in texts(svg)})

    def test_figures_of_a_run_as_image_and_document(self):
        for name in ("deformed", "end", "energies", "model", "curve"):
            for kind, begin in (("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<svg")):
                file = self.scratch / f"{name}.of.{kind}"
                done = program("plot", self.run_.folder, "--figure", name, "--out", file)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(file.read_bytes().startswith(begin), file.name)
        self.assertTrue(self.run_.motion._repr_svg_().startswith("<svg"))
        done = program("plot", self.run_.folder, "--figure", "modes", "--out", self.scratch / "modes.png")
        self.assertEqual(done.returncode, 2)
        self.assertIn("has no figure 'modes'; there are curve, deformed", done.stderr)
        done = program("plot", self.run_.folder, "--figure", "deformd")
        self.assertEqual(done.returncode, 2)
        self.assertIn("deformed", done.stderr)

    def test_curves_over_logarithms(self):
        pictures = set()
        for axes in ([], ["--log", "y"]):
            file = self.scratch / "curves.svg"
            self.assertEqual(program("plot", self.run_.folder, *axes, "--out", file).returncode, 0)
            pictures.add(file.read_text(encoding="utf-8"))
        self.assertEqual(len(pictures), 2)
        self.assertEqual(program("plot", self.run_.folder, "--log", "z", "--out", file).returncode, 2)


if __name__ == "__main__":
    unittest.main()
