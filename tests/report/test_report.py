"""Reports of real runs, looked at in a browser: test_report.py PROGRAM AXES."""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from random import Random

import sweep_folder
from browser import Browser

ROOT = Path(__file__).resolve().parents[2]
BEAM = ROOT / "tests/program/beam.yaml"
BAR = ROOT / "studies/softening-bar/deck.yaml"
CRACKED = ROOT / "tests/program/cracked_beam.yaml"
THROWN = """
scene: {type: polygons, regions: [{name: block, material: stone, vertices: [[0, 0], [1, 0], [1, 1], [0, 1]]}]}
thickness: 1
materials: {stone: {type: linear_elastic, young_modulus: 1e7, density: 2.5}}
motion: {time: 0.5, gravity: [0, -9.81], contact: {friction: 0}, velocities: [{regions: [block], velocity: [1, 1], spin: 3}]}
"""
ATTACK = "</script><script>window.stolen = 1</script><img src=x onerror=window.stolen=1>"
PROGRAM, AXES = "dda", "axes"


def dda(*arguments, code=0):
    result = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=240, check=False)
    if result.returncode != code:
        raise AssertionError(f"dda {arguments}: {result.returncode} instead of {code}\n{result.stderr}")
    return result.stdout + result.stderr


def parts_of_last_step(folder, scale):
    """Outlines of whole blocks and parts as ddapath reads them: x, y, x, y, ... of each."""
    script = "import json, sys, ddapath; print(json.dumps([outline.ravel().tolist() for outline in " \
             "ddapath.read_run(sys.argv[1]).fields().polygons(float(sys.argv[2]))]))"
    said = subprocess.run(["/usr/bin/python3", "-c", script, str(folder), str(scale)], capture_output=True, text=True, check=True,
                          env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
    return json.loads(said.stdout)


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.work = Path(cls.folder.name)
        cls.browser = cls.enterClassContext(Browser())
        dda("run", BEAM, "--folder", cls.work / "beam", "--quiet", "--set", "record.eigenvalues.count=2", "--set", f"title='{ATTACK}'")
        cls.rows = list(csv.DictReader((cls.work / "beam/curve.csv").read_text(encoding="utf-8").splitlines()))
        cls.summary = json.loads((cls.work / "beam/summary.json").read_text())

    def report(self, folder):
        dda("report", folder)
        return Path(folder) / "report.html"

    def open(self, folder, width=1280):
        page = self.browser.open(self.report(folder), width)
        page.wait("document.body.dataset.ready === 'true'")
        page.drawn()
        return page

    def check(self, page):
        """Nothing went wrong, nothing was loaded, nothing sticks out."""
        self.assertEqual(page.errors(), [])
        asked = [address for address in page.requests() if not address.startswith("data:")]  # the model's picture is in the page
        self.assertEqual([address for address in asked if not address.startswith(("file:", "about:"))], [])
        self.assertEqual(len(asked), 1)
        self.assertLessEqual(page.run("document.documentElement.scrollWidth - window.innerWidth"), 0)

    def text(self, page, selector="body"):
        return page.run(f"document.querySelector({json.dumps(selector)}).innerText")

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

    def pixels(self, page, figure):
        """The drawn picture, to be compared with another."""
        return page.run(f"document.querySelector('#{figure} canvas').toDataURL()")

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

    def choose(self, page, figure, label, value):
        page.run(f"""(() => {{ const one = [...document.querySelectorAll('#{figure} label')].find((l) => l.textContent.startsWith('{label}'))
            .querySelector('select'); one.value = '{value}'; one.dispatchEvent(new Event('change')); }})()""")
        page.drawn()

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

    def saved(self, page, figure):
        """Name and text of the SVG that the figure's button would save."""
        return self.given(page, figure, "SVG", "await blob.text()")

    def given(self, page, figure, kind, what):
        """Name of the file that a figure's button would save, and what a script makes of its `blob`."""
        page.run("window.given = null; "
                 f"window.download = async (name, blob) => {{ const made = {what}; window.given = [name, made]; }}")
        page.run(f"[...document.querySelectorAll('#{figure} button')].find((one) => one.textContent === 'Save {kind}').click()")
        page.wait("window.given !== null")
        return page.run("window.given")

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
        self.check(page)

    def test_a_dark_screen(self):
        page = self.browser.open(self.report(self.work / "beam"), dark=True)
        page.wait("document.body.dataset.ready === 'true'")
        red, green, blue = page.run("getComputedStyle(document.documentElement).backgroundColor.match(/\\d+/g).map(Number)")
        self.assertLess(red + green + blue, 120)
        corner = page.run("[...document.querySelector('#curve canvas').getContext('2d').getImageData(2, 2, 1, 1).data]")
        self.assertEqual(corner[:3], [red, green, blue])
        _, text = self.saved(page, "curve")
        self.assertIn('fill="#fff"', text)
        self.assertNotIn("#e4e6e8", text)  # the ink of the dark: files are for paper
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
                ranges.append([low, low + length, random.randint(2, 9)])
        answer = subprocess.run([AXES], input=json.dumps(ranges), capture_output=True, text=True, check=True)
        of_page = self.open(self.work / "beam").run(f"""{ranges}.map(([low, high, wanted]) => {{
            const {{ticks, scale}} = axisTicks([low, high], wanted);
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

    def test_laws_and_spreads_of_a_sweep(self):
        page = self.open(self.work / "beam")  # the laws come with every page
        sizes = [50, 100, 200, 400]

        def told(law, strengths):
            points = json.dumps(list(zip(sizes, strengths)))
            return page.run(f"fittedLaw(SWEEP_LAWS.{law}, {points}).words")

        self.assertIn("a = 12, b = −0.5;", told("power", [12 / size**0.5 for size in sizes]))
        self.assertIn("B = 3, x₀ = 150;", told("size", [3 / (1 + size / 150) ** 0.5 for size in sizes]))
        self.assertIn("none goes through", told("size", [1, 2, 3, 4]))  # it would grow with size
        groups = page.run("spreads([[1, 2], [1, 4], [1, 6], [2, 5], [3, NaN]])")
        self.assertEqual(groups, [{"x": 1, "mean": 4, "deviation": 2, "count": 3}])

    def test_a_sweep(self):
        folder = self.work / "sweep"
        sweep_folder.make(PROGRAM, BAR, folder)
        dda("report", folder / "cases/001")
        for width in (1280, 400):
            page = self.open(folder, width)
            self.assertEqual(self.text(page, "h1"), "Toughness and <b>control</b>")
            self.assertIn("2 goal reached, 1 stopped early, 1 failed", self.text(page, "#status"))
            self.assertIn("fracture_energy", self.text(page, "#failures"))
            self.check(page)
        for label, value in (("law", "power"), ("divided by", "peak.load")):
            self.choose(page, "scatter", label, value)
        self.assertIn("power law y = a xᵇ", self.text(page, "#scatter-words"))
        page.run("[...document.querySelectorAll('#scatter input')].find((one) => one.type === 'checkbox').click()")
        page.drawn()
        self.assertTrue(page.run("thePage.scatter.plot.content.yLabel").startswith("log₁₀ "))
        self.check(page)
        links = page.run("[...document.querySelectorAll('#cases a')].map((one) => one.getAttribute('href'))")
        self.assertEqual(links, ["./cases/001/report.html", "./cases/002/", "./cases/003/"])
        cases = "[...document.querySelectorAll('#cases tbody tr')].map((one) => one.firstChild.textContent)"
        self.assertEqual(page.run(cases), ["1", "2", "3", "4"])
        page.run("[...document.querySelectorAll('#cases th button')].find((one) => one.textContent.startsWith('peak load')).click()")
        self.assertEqual(page.run(cases)[-1], "4")
        page.run("document.querySelector('#cases th button').click()")
        page.run("document.querySelector('#cases th button').click()")
        self.assertEqual(page.run(cases), ["4", "3", "2", "1"])
        drawn = self.pixels(page, "scatter")
        self.choose(page, "scatter", "up", "steps")
        self.assertNotEqual(self.pixels(page, "scatter"), drawn)
        self.check(page)


if __name__ == "__main__":
    PROGRAM, AXES = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main(verbosity=2)
