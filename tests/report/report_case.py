"""What the tests of reports share: a run, and pages of the browser."""

import csv
import json
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser
from program import dda

ROOT = Path(__file__).resolve().parents[2]
BEAM = ROOT / "tests/program/beam.yaml"
ATTACK = "</script><script>window.stolen = 1</script><img src=x onerror=window.stolen=1>"
AXES = sys.argv.pop(1)


class ReportCase(unittest.TestCase):
    """With the run `beam` in the folder `work`."""

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

    def pixels(self, page, figure):
        """The drawn picture, to be compared with another."""
        return page.run(f"document.querySelector('#{figure} canvas').toDataURL()")

    def choose(self, page, figure, label, value):
        page.run(f"""(() => {{ const one = [...document.querySelectorAll('#{figure} label')].find((l) => l.textContent.startsWith('{label}'))
            .querySelector('select'); one.value = '{value}'; one.dispatchEvent(new Event('change')); }})()""")
        page.drawn()

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

    def corner_of_model(self, page):
        """The colour on which the model's picture is drawn: red, green, blue."""
        page.run("document.querySelector('#model-picture').decode()")
        return page.run("""(() => { const canvas = document.createElement('canvas'); const context = canvas.getContext('2d');
            context.drawImage(document.querySelector('#model-picture'), 0, 0);
            return [...context.getImageData(2, 2, 1, 1).data].slice(0, 3); })()""")
