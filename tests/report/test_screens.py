"""Reports on every screen: narrow and wide, light and dark, all that can be clicked is clicked: test_screens.py PROGRAM.

Pictures of the pages are left in the folder that the environment's PICTURES names, if there is one.
"""

import tempfile
import unittest
from pathlib import Path

import appearance
import sweep_folder
from browser import Browser
from program import PROGRAM, dda

ROOT = Path(__file__).resolve().parents[2]
# Everything that a page may have: cracks through blocks, eigenvalues, energies, a motion.
DECK = ROOT / "tests/program/cracked_beam.yaml"
SETTINGS = ("scene.subdivision={type: voronoi, blocks: 60, seed: 3}", "record.eigenvalues.count=2", "path.then=motion",
            "motion={time: 0.001, frame_every: 0.0001}", "materials.concrete.density=2.4e-9")
PLOTS = ("curve", "overlay", "scatter", "energies", "balance", "ratios", "eigenvalues", "stiffness", "counts", "motion-energies")


class EveryScreen(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.work = Path(folder.name)
        cls.browser = cls.enterClassContext(Browser(patience=240))
        dda("run", DECK, "--folder", cls.work / "run", "--quiet", *(word for one in SETTINGS for word in ("--set", one)))
        sweep_folder.make(PROGRAM, ROOT / "studies/softening-bar/deck.yaml", cls.work / "sweep")
        for name in ("run", "sweep"):
            dda("report", cls.work / name)

    def open(self, name, width, dark):
        page = self.browser.open(self.work / name / "report.html", width, dark=dark, before=appearance.RECORDER)
        page.wait("document.body.dataset.ready === 'true'")
        page.drawn()
        return page

    def assert_lines_are_visible(self, page):
        """In the dark, of the plots; the net behind them is to be seen faintly, and empty marks are of the paper's colour."""
        paper, faint = page.run("[PAPER, FAINT]")
        count = 0
        for figure, verbs in page.run("drawnColours").items():
            for verb in ("stroke", "fill") if figure in PLOTS else ():
                for colour in set(verbs.get(verb, ())) - {faint, paper}:
                    self.assertGreaterEqual(appearance.contrast(colour, paper), appearance.VISIBLE, f"{figure}: {verb} {colour}")
                    count += 1
        self.assertGreater(count, 5)

    def assert_figures_are_legible(self, page, dark):
        paper = page.run("PAPER")
        for figure, verbs in page.run("drawnColours").items():
            for colour in verbs.get("fillText", ()):
                self.assertGreaterEqual(appearance.contrast(colour, paper), appearance.LEGIBLE, f"{figure}: {colour}")
        block, edge, widest = page.run("[SCREEN.block, SCREEN.edge, CRACK_COLOURS.at(-1)]")
        self.assertGreaterEqual(appearance.contrast(widest, block), appearance.VISIBLE)
        if dark:
            self.assertGreaterEqual(appearance.contrast(edge, paper), appearance.VISIBLE)
            self.assert_lines_are_visible(page)

    def look_at(self, name, least):
        for number, (width, dark) in enumerate(appearance.COMBINATIONS):
            with self.subTest(page=name, width=width, dark=dark):
                page = self.open(name, width, dark)
                appearance.keep_a_picture(page, name, width, dark)
                appearance.assert_it_fits(self, page)
                self.assertGreaterEqual(appearance.assert_all_can_be_clicked(self, page, number), least)
                appearance.assert_it_fits(self, page)
                appearance.assert_words_are_legible(self, page)
                self.assert_figures_are_legible(page, dark)
                self.assertEqual(page.errors(), [])
                page.close()

    def test_words_of_the_model_are_never_small(self):
        for width, _ in appearance.COMBINATIONS[::2]:
            page = self.open("run", width, False)
            self.assertGreater(page.run("(() => { const one = document.getElementById('model-picture');"
                                        "return one.clientWidth / one.naturalWidth; })()"), 0.9)
            page.close()

    def test_a_run(self):
        self.look_at("run", 60)

    def test_a_sweep(self):
        self.look_at("sweep", 30)


if __name__ == "__main__":
    unittest.main(verbosity=2)
