"""Reports of real runs, looked at in a browser: test_report.py PROGRAM AXES."""

import json
import os
import shutil
import subprocess
import unittest
from random import Random

from program import dda
from report_case import ATTACK, AXES, BEAM, ROOT, ReportCase

CRACKED = ROOT / "tests/program/cracked_beam.yaml"
THROWN = """
scene: {type: polygons, regions: [{name: block, material: stone, vertices: [[0, 0], [1, 0], [1, 1], [0, 1]]}]}
thickness: 1
materials: {stone: {type: linear_elastic, young_modulus: 1e7, density: 2.5}}
motion: {time: 0.5, gravity: [0, -9.81], contact: {friction: 0}, velocities: [{regions: [block], velocity: [1, 1], spin: 3}]}
"""


def parts_of_last_step(folder, scale):
    """Outlines of whole blocks and parts as ddapath reads them: x, y, x, y, ... of each."""
    script = "import json, sys, ddapath; print(json.dumps([outline.ravel().tolist() for outline in " \
             "ddapath.read_run(sys.argv[1]).fields().polygons(float(sys.argv[2]))]))"
    said = subprocess.run(["/usr/bin/python3", "-c", script, str(folder), str(scale)], capture_output=True, text=True, check=True,
                          env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
    return json.loads(said.stdout)


class Reports(ReportCase):
    def test_what_is_said_of_a_run(self):
        page = self.open(self.work / "beam")
        self.assertIn("Goal reached: load below 10 % of its peak.", self.text(page, "#status"))
        self.assertIn(f"step {self.summary['peak']['step']}", self.text(page, "#numbers"))
        self.assertIn("Dashed: stable under the control only", self.text(page, "#path"))
        self.assertIn("record.eigenvalues.count=2", self.text(page, "#asked"))
        for name in ("path", "stability", "energy", "asked", "events", "time", "provenance"):
            self.assertTrue(page.run(f"document.getElementById('{name}') !== null"), name)
        self.check(page)

    def test_what_the_user_wrote_stays_text(self):
        page = self.open(self.work / "beam")
        self.assertEqual(self.text(page, "h1"), ATTACK)
        self.assertIsNone(page.run("window.stolen"))
        self.assertEqual(page.run("document.querySelectorAll('img:not(#model-picture)').length"), 0)

    def test_the_slider_changes_the_drawn_step(self):
        page = self.open(self.work / "beam")
        step = "document.querySelector('#deformed canvas').dataset.step"
        last, drawn, marked = page.run(step), self.pixels(page, "deformed"), self.pixels(page, "curve")
        page.run("document.getElementById('step-slider').focus()")
        page.key("ArrowLeft")
        self.assertNotEqual(page.run(step), last)
        self.assertIn(f"step {page.run(step)}", self.text(page, "#step-shown"))
        self.assertNotEqual(self.pixels(page, "deformed"), drawn)
        self.assertNotEqual(self.pixels(page, "curve"), marked)
        page.key("Home")
        self.assertEqual(page.run("document.getElementById('step-slider').value"), "0")
        self.check(page)

    def test_playing_ends_at_the_last_step(self):
        page = self.open(self.work / "beam")
        last = page.run("document.querySelector('#deformed canvas').dataset.step")
        page.run("document.querySelector('.player button').click()")
        page.wait("document.getElementById('step-slider').value === '1'")
        page.wait(f"document.querySelector('#deformed canvas').dataset.step === '{last}' && "
                  "document.querySelector('.player button').textContent === '▶'")
        self.check(page)

    def test_fields_and_magnification_change_the_picture(self):
        page = self.open(self.work / "beam")
        pictures = {self.pixels(page, "deformed")}
        for label, value in (("blocks by", "xx"), ("blocks by", "first"), ("cracks by", "damage"), ("displacements", "0")):
            self.choose(page, "deformed", label, value)
            pictures.add(self.pixels(page, "deformed"))
        self.assertEqual(len(pictures), 5)
        self.check(page)

    def test_cracks_through_blocks(self):
        """Path, length and cuts are told; cut blocks are drawn in the parts that the fields have."""
        folder = self.work / "cracked"
        dda("run", CRACKED, "--folder", folder, "--quiet", "--set", "scene.subdivision={type: voronoi, blocks: 150, seed: 3}")
        crack = json.loads((folder / "summary.json").read_text())["cracks"][0]
        page = self.open(folder)
        told = self.text(page, "#cracks")
        for text in (f"{crack['length']:.4g}", crack["ended"], f"{len(crack['cuts'])} cuts", "through it", "along a side"):
            self.assertIn(text, told)
        rows = page.run("[...document.querySelectorAll('#cracks details tbody tr')].map((row) => row.innerText)")
        self.assertEqual(len(rows), len(crack["cuts"]))
        for row, cut in zip(rows, crack["cuts"]):
            self.assertIn(str(cut["step"]), row.split("\t"))
        outlines = page.run("""(() => { const {blocks} = thePage.figures.deformed;
            return blocks.movedOutlines(blocks.steps.length - 1, 100, (places) => places).map(({outline}) => [...outline]); })()""")
        wanted = parts_of_last_step(folder, 100)
        self.assertEqual([len(outline) for outline in outlines], [len(outline) for outline in wanted])
        for outline, expected in zip(outlines, wanted):
            for value, place in zip(outline, expected):
                self.assertAlmostEqual(value, place, delta=0.05)  # of 300, displacements are on 16 bits and magnified
        drawn = self.pixels(page, "crack-paths")
        page.run("[...document.querySelectorAll('#crack-paths button')].find((one) => one.textContent === '+').click()")
        page.drawn()
        self.assertNotEqual(self.pixels(page, "crack-paths"), drawn)
        self.check(page)

    def place_of_row(self, page, row):
        """Where a row of the curve is drawn [px of the window]: the plot is asked, the numbers are those of curve.csv."""
        left, top, _, _ = page.scroll_to("#curve canvas")
        x, y = float(self.rows[row]["deflection"]), float(self.rows[row]["load"])
        px, py = page.run(f"(() => {{ const frame = thePage.figures.curve.plot.frame; return [frame.toX({x}), frame.toY({y})]; }})()")
        return left + px, top + py

    def test_a_point_of_the_curve_tells_its_data(self):
        page = self.open(self.work / "beam")
        hidden = "document.querySelector('#curve .data-box').hidden"
        self.assertTrue(page.run(hidden))
        page.mouse("mouseMoved", *self.place_of_row(page, 5))
        self.assertFalse(page.run(hidden))
        told = page.run("[...document.querySelectorAll('#curve .data-box > *')].map((one) => one.textContent)")
        self.assertEqual(told[told.index("step") + 1], self.rows[5]["step"])
        self.assertEqual(told[told.index("control") + 1], self.rows[5]["control"])
        self.assertIn(" mm", told[told.index("cmod") + 1])
        self.check(page)

    def test_a_click_goes_to_the_nearest_stored_step(self):
        page = self.open(self.work / "beam")
        x, y = self.place_of_row(page, 1)
        for kind in ("mousePressed", "mouseReleased"):
            page.mouse(kind, x, y, button="left", clickCount=1)
        self.assertEqual(page.run("document.getElementById('step-slider').value"), "0")
        self.check(page)

    def test_wheel_and_drag_zoom_and_move(self):
        page = self.open(self.work / "beam")
        frame = "(() => { const one = thePage.figures.curve.plot.frame; return [...one.rangeX, ...one.rangeY]; })()"
        whole, drawn = page.run(frame), self.pixels(page, "curve")
        left, top, width, height = page.scroll_to("#curve canvas")
        x, y = left + width / 2, top + height / 2
        page.mouse("mouseWheel", x, y, deltaX=0, deltaY=-200)
        near = page.run(frame)
        self.assertLess(near[1] - near[0], whole[1] - whole[0])
        self.assertNotEqual(self.pixels(page, "curve"), drawn)
        page.mouse("mousePressed", x, y, button="left", clickCount=1)
        page.mouse("mouseMoved", x + 40, y, button="left", buttons=1)
        page.mouse("mouseReleased", x + 40, y, button="left", clickCount=1)
        moved = page.run(frame)
        self.assertLess(moved[0], near[0])
        self.assertAlmostEqual(moved[1] - moved[0], near[1] - near[0], delta=1e-9 * whole[1])
        page.run("[...document.querySelectorAll('#curve button')].find((one) => one.textContent === 'Reset').click()")
        page.drawn()
        self.assertEqual(page.run(frame), whole)
        self.check(page)

    def test_figures_are_saved_as_vectors(self):
        page = self.open(self.work / "beam")
        for figure in ("curve", "deformed", "energies", "balance"):
            name, text = self.saved(page, figure)
            self.assertTrue(name.endswith(".svg"))
            document = page.run(f"new DOMParser().parseFromString({json.dumps(text)}, 'image/svg+xml').documentElement.nodeName")
            self.assertEqual(document, "svg")
            self.assertIn("<path", text)
            self.assertNotIn("<image", text)
        self.check(page)

    def test_figures_are_saved_as_images(self):
        page = self.open(self.work / "beam")
        size = "await createImageBitmap(blob).then((image) => [image.width, image.height, blob.type])"
        for figure in ("curve", "deformed"):
            name, (width, height, kind) = self.given(page, figure, "PNG", size)
            self.assertTrue(name.endswith(".png"))
            self.assertEqual(kind, "image/png")
            shown = page.run(f"document.querySelector('#{figure} canvas').clientWidth")
            self.assertLess(abs(width - 2 * shown), 3)
            self.assertGreater(height, 200)
        self.check(page)

    def test_the_model_comes_first(self):
        page = self.open(self.work / "beam")
        self.assertEqual(page.run("document.querySelector('section').id"), "model")
        self.assertGreater(page.run("document.querySelector('#model-picture').naturalWidth"), 300)
        self.assertEqual(self.corner_of_model(page), [255, 255, 255])
        self.check(page)

    def test_materials_have_the_colours_of_the_figures_in_files(self):
        deck = self.work / "two.yaml"
        deck.write_text(THROWN.replace("regions: [{", "regions: [{name: ground, material: rock, vertices: [[-1, -1], [2, -1], [2, -0.5], [-1, -0.5]]}, {")
                        .replace("materials: {", "materials: {rock: {type: linear_elastic, young_modulus: 1e7}, ")
                        .replace("motion: {", "motion: {held: [ground], "))
        dda("run", deck, "--folder", self.work / "two", "--quiet")
        end = (self.work / "two/motion/end.svg").read_text(encoding="utf-8")
        page = self.open(self.work / "two")
        self.assertEqual(page.run("thePage.figures.motion.blocks.materials"), ["rock", "stone"])
        colours = page.run("[0, 1].map((block) => thePage.figures.motion.blocks.tintOf(block))")
        self.assertEqual(len(set(colours)), 2)
        for colour in colours:
            self.assertEqual(end.count(f'fill="{colour}"'), 2)  # the blocks and the legend
            self.assertIn(f'fill="{colour}"', self.saved(page, "moving")[1])
        self.assertIn("rock", self.text(page, "#moving figcaption"))
        self.check(page)

    def test_a_dark_screen(self):
        page = self.browser.open(self.report(self.work / "beam"), dark=True)
        page.wait("document.body.dataset.ready === 'true'")
        red, green, blue = page.run("getComputedStyle(document.documentElement).backgroundColor.match(/\\d+/g).map(Number)")
        self.assertLess(red + green + blue, 120)
        corner = page.run("[...document.querySelector('#curve canvas').getContext('2d').getImageData(2, 2, 1, 1).data]")
        self.assertEqual(corner[:3], [red, green, blue])
        self.assertEqual(self.corner_of_model(page), [red, green, blue])
        _, text = self.saved(page, "curve")
        self.assertIn('fill="#fff"', text)
        self.assertNotIn("#e4e6e8", text)  # the ink of the dark: files are for paper
        _, text = self.saved(page, "model")
        self.assertEqual(text, (self.work / "beam/model.svg").read_text(encoding="utf-8"))
        self.assertEqual(page.errors(), [])

    def test_located_events_are_marked(self):
        folder = self.work / "eventful"
        shutil.copytree(self.work / "beam", folder)
        peak = self.summary["peak"]
        event = {"of": "load", "step": 3, "load": 0.5 * peak["load"], "gauges": {"deflection": 0.01}}
        summary = {**self.summary, "events": [{**event, **peak, "kind": "limit_point"}, {**event, "kind": "bifurcation"},
                                              {**event, "kind": "turning_point", "of": "cmod"}, {"kind": "nowhere"}]}
        (folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        page = self.open(folder)
        marks = page.run("thePage.figures.curve.plot.content.marks.map(({ x, y, label }) => [x, y, label])")
        self.assertEqual([label.split(",")[0] for _, _, label in marks], ["peak", "bifurcation", "turning point of cmod"])
        self.assertEqual(marks[1][:2], [0.01, 0.5 * peak["load"]])
        self.assertIn("4 located events", self.text(page, "#path"))
        self.check(page)

    def test_the_magnification_suits_the_largest_displacement(self):
        page = self.open(self.work / "beam")
        moved, size = page.run("[thePage.blocks.largestDisplacement(), thePage.blocks.box.size]")
        shown = page.run("thePage.figures.deformed.options.magnification") * moved / size
        self.assertTrue(0.02 <= shown <= 0.05, shown)

    def test_axes_are_those_of_the_figures_in_files(self):
        random, ranges = Random(1), []
        for _ in range(2000):
            length = random.choice([1, 2, 5, random.uniform(1, 10)]) * 10.0 ** random.randint(-9, 9)
            low = random.choice([0, -length / 2, random.uniform(-1e3, 1e3), 10.0 ** random.randint(-3, 9)])
            if low + length > low + 1e-9 * abs(low):
                ranges.append([low, low + length, random.randint(2, 9), False])
        for _ in range(1000):
            low = random.choice([random.uniform(-12, 12), random.randint(-12, 12)])
            ranges.append([low, low + random.choice([random.uniform(0.01, 2), random.uniform(1, 30), random.randint(1, 9)]), random.randint(2, 9), True])
        answer = subprocess.run([AXES], input=json.dumps(ranges), capture_output=True, text=True, check=True)
        of_page = self.open(self.work / "beam").run(f"""{json.dumps(ranges)}.map(([low, high, wanted, isLogarithmic]) => {{
            const {{ticks, scale}} = (isLogarithmic ? logarithmicTicks : axisTicks)([low, high], wanted);
            const numbers = [...widened([low, high]), roundDown(high - low), ...ticks.map(({{value}}) => value)];
            return {{labels: ticks.map(({{label}}) => label), scale, numbers}}; }})""")
        for given, expected, page in zip(ranges, json.loads(answer.stdout), of_page, strict=True):
            self.assertEqual((page["labels"], page["scale"]), (expected["labels"], expected["scale"]), given)
            for ours, theirs in zip(expected["numbers"], page["numbers"], strict=True):
                self.assertAlmostEqual(ours, theirs, delta=1e-12 * max(map(abs, given)), msg=given)

    def test_a_narrow_window(self):
        page = self.open(self.work / "beam", width=400)
        page.mouse("mouseMoved", *self.place_of_row(page, 5))
        self.check(page)

    def test_an_unfinished_run_says_so(self):
        unfinished = self.work / "unfinished"
        dda("run", BEAM, "--folder", unfinished, "--quiet", "--set", "path.stop.after_steps=6")
        for name in ("summary.json", "fields/mesh.h5", "curve.svg", "deformed.svg"):
            (unfinished / name).unlink()
        page = self.open(unfinished)
        self.assertIn("Unfinished.", self.text(page, "#status"))
        self.assertIn("fields/mesh.h5", self.text(page, ".notice"))
        self.assertIn("highest load so far", self.text(page, "#numbers").lower())
        self.check(page)

    def test_a_motion_without_a_path(self):
        """Its blocks move at true scale, a slider goes through the frames, energies stand beside them."""
        deck = self.work / "thrown.yaml"
        deck.write_text(THROWN)
        dda("run", deck, "--folder", self.work / "thrown", "--quiet")
        page = self.open(self.work / "thrown")
        self.check(page)
        self.assertIn("the time 0.5 is reached", self.text(page, "#motion"))
        self.assertEqual(page.run("thePage.figures.motion.moving.options.magnification"), 1)
        last = int(page.run("document.querySelector('#moving canvas').dataset.step"))
        self.assertGreater(last, 10)
        page.run("thePage.figures.motion.shown.set(0)")
        page.drawn()
        self.assertEqual(page.run("document.querySelector('#moving canvas').dataset.step"), "0")
        self.assertIn("external work", self.text(page, "#motion-energies"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
