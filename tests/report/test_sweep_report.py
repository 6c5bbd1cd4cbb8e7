"""Reports of sweeps, looked at in a browser: test_sweep_report.py PROGRAM AXES."""

import json
import unittest

import sweep_folder
from program import PROGRAM, dda
from report_case import ROOT, ReportCase

BAR = ROOT / "studies/softening-bar/deck.yaml"


class SweepReports(ReportCase):
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
        axis = self.saved(page, "scatter")[1]
        for label in (">0.05<", ">0.1<"):  # decades and, of a short range, 2 and 5
            self.assertIn(label, axis)
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
    unittest.main(verbosity=2)
