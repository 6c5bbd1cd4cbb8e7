"""The documentation site, built strictly: no page needs the network, every link and anchor leads somewhere, formulas are
set, menu, search and colours work on every screen, opened as files in a browser. `test_site.py PROGRAM`; pictures of
pages are left in the folder that the environment's PICTURES names, if there is one.
"""

import posixpath
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = str(Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(ROOT / "tests/report"))
sys.path.insert(0, str(ROOT / "docs/site"))

import appearance  # noqa: E402
from browser import Browser  # noqa: E402
from html_pages import loads_of_style, read_site  # noqa: E402
from links import relinked  # noqa: E402


def setUpModule():
    """The site is built once, in a folder with a space in its name."""
    folder = tempfile.TemporaryDirectory(prefix="dda site ")
    unittest.addModuleCleanup(folder.cleanup)
    Built.site = Path(folder.name).resolve() / "site"
    Built.said = subprocess.run(
        ["/usr/bin/python3", "-B", ROOT / "docs/site/build.py", "--program", PROGRAM, "--site", Built.site,
         "--pages", Path(folder.name) / "pages"], capture_output=True, text=True, check=False)
    Built.pages = read_site(Built.site)


class Built(unittest.TestCase):
    site, said, pages = None, None, None


class Site(Built):
    def target(self, page, link):
        """The file of the site that a link leads to, and the anchor there."""
        parts = urlsplit(link)
        path = posixpath.normpath(posixpath.join(posixpath.dirname(page), unquote(parts.path))) if parts.path else page
        return path, unquote(parts.fragment)

    def test_it_is_built_and_says_where_it_is(self):
        self.assertEqual(self.said.returncode, 0, self.said.stdout + self.said.stderr)
        self.assertEqual(self.said.stdout, f"{self.site}/index.html\n")
        for page in ("index.html", "first-beam.html", "stopped.html", "reference/deck.html", "reference/law.html",
                     "studies/kitoh-beam/index.html", "api/index.html", "CHANGELOG.html"):
            self.assertIsNotNone(self.pages.get(page), page)

    def test_no_page_needs_the_network(self):
        for page, html in self.pages.items():
            for load in html.loads:
                self.assertNotRegex(load, r"^(?:[a-z]+:)?//", page)
        for style in self.site.rglob("*.css"):
            for load in loads_of_style(style.read_text(encoding="utf-8")):
                self.assertNotRegex(load, r"^(?:[a-z]+:)?//", style.name)

    def test_what_pages_load_is_there(self):
        for page, html in self.pages.items():
            for load in html.loads if page != "404.html" else []:  # which servers give, from their root
                if not urlsplit(load).scheme:  # data, and scripts
                    self.assertTrue((self.site / self.target(page, load)[0]).exists(), f"{page}: {load}")

    def test_links_and_anchors_lead_somewhere(self):
        count = 0
        for page, html in self.pages.items():
            for link in html.links:
                if urlsplit(link).scheme or page == "404.html":
                    continue
                path, anchor = self.target(page, link)
                self.assertTrue((self.site / path).is_file(), f"{page}: {link}")
                if anchor and path in self.pages and not page.startswith("api/"):  # Doxygen makes some in scripts
                    self.assertTrue(anchor in self.pages[path].anchors | {"__top"}, f"{page}: {link}")
                count += 1
        self.assertGreater(count, 5000)

    def test_links_of_the_readme_lead_to_pages_and_headings(self):
        text, found = relinked((ROOT / "README.md").read_text(encoding="utf-8"), "README.md", ROOT)
        self.assertGreater(len(found), 30)
        for link in re.findall(r"\]\(([^)\s]+)\)", text):
            path, anchor = self.target("index.html", re.sub(r"(^|/)README\.md", r"\1index.md", link))
            page = re.sub(r"\.md$", ".html", path)
            self.assertTrue((self.site / page).is_file(), link)
            self.assertTrue(not anchor or anchor in self.pages[page].anchors, link)

    def test_tables_and_lists_are_none_in_text(self):
        for page in self.site.rglob("*.html"):
            if "api" not in page.relative_to(self.site).parts and "sources" not in page.relative_to(self.site).parts:
                found = re.search(r"<p>\s*(?:\||```|\* ).*", page.read_text(encoding="utf-8"))
                self.assertIsNone(found, page)

    def test_every_key_of_the_deck_has_its_row(self):
        text = (self.site / "reference/deck.html").read_text(encoding="utf-8")
        for key in ("thickness", "young_modulus", "load_below"):
            where = text if key != "young_modulus" else (self.site / "reference/material.html").read_text(encoding="utf-8")
            self.assertTrue(f"<code>{key}</code>" in where, key)
        row = re.search(r"<code>largest</code>.*?</tr>", text, re.DOTALL)[0]
        self.assertIn("<code>0.1</code>", row)

    def test_every_study_is_in_the_gallery_with_a_picture(self):
        text = (self.site / "gallery.html").read_text(encoding="utf-8")
        studies = [readme.parent.name for readme in (ROOT / "studies").glob("*/README.md")]
        self.assertEqual(text.count('<img alt='), len(studies))
        for name in studies:
            self.assertTrue(f'href="studies/{name}/index.html"' in text, name)


class InABrowser(Built):
    def test_formulas_are_set_without_a_mistake(self):
        with Browser() as browser:
            for page, html in self.pages.items():
                if "class=\"arithmatex\"" not in (self.site / page).read_text(encoding="utf-8"):
                    continue
                opened = browser.open(self.site / page)
                opened.wait("window.MathJax && MathJax.isReady && MathJax.Hub.queue.pending === 0"
                            " && !MathJax.Hub.queue.running")
                self.assertEqual(opened.run("MathJax.Hub.getAllJax().filter((one) => one.texError).length"), 0, page)
                self.assertEqual(opened.run("document.querySelectorAll('.arithmatex').length"),
                                 opened.run("document.querySelectorAll('.arithmatex svg').length"), page)
                self.assertEqual(opened.errors(), [], page)
                self.assertEqual([url for url in opened.requests() if not url.startswith(("file:", "data:"))], [])
                browser.call("Target.closeTarget", targetId=opened.target)


class EveryScreen(Built):
    """Narrow and wide, light and dark: pages are looked at, and what can be clicked on each of them is clicked."""

    PAGES = ("index.html", "first-beam.html", "gallery.html", "reference/deck.html", "theory/laws.html", "manual/plugins.html",
             "stopped.html", "studies/kitoh-beam/index.html", "sources/tests/program/beam.yaml.html")

    @classmethod
    def setUpClass(cls):
        cls.browser = cls.enterClassContext(Browser())

    def open(self, name, width, dark):
        page = self.browser.open(self.site / name, width, dark=dark)
        page.drawn()
        return page

    def test_pages(self):
        for width, dark in appearance.COMBINATIONS:
            for name in self.PAGES:
                with self.subTest(page=name, width=width, dark=dark):
                    page = self.open(name, width, dark)
                    appearance.keep_a_picture(page, name.replace("/", "-"), width, dark)
                    appearance.assert_it_fits(self, page)
                    appearance.assert_words_are_legible(self, page)
                    self.assertEqual(page.errors(), [])
                    page.close()

    def go_by_the_menu(self, page, width):
        """To the controls' page: by tab and list where there is room for them, else by the menu, section by section."""
        if width < 1220:
            page.click("label.md-header__button[for=__drawer]",
                       until="document.querySelector('.md-sidebar--primary').getBoundingClientRect().left === 0")
            page.click("label.md-nav__link[for=__nav_3]",
                       until="document.querySelector('#__nav_3 ~ nav').getBoundingClientRect().left === 0")
        else:
            page.follow(".md-tabs__link[href='manual/index.html']", "/manual/index.html")
        appearance.assert_words_are_legible(self, page)
        page.follow(".md-sidebar--primary .md-nav__link[href$='controls.html']", "/manual/controls.html")

    def go_by_the_search(self, page, width):
        if width < 960:
            page.click("label.md-header__button[for=__search]",
                       until="document.getElementById('__search').checked && document.getAnimations().every((one) => one.playState !== 'running')")
        page.click(".md-search__input",
                   until="document.activeElement.matches('.md-search__input')")
        page.type("bifurcation")
        page.key("n")
        page.wait("document.querySelectorAll('.md-search-result__link').length > 0")
        found = page.run("[...document.querySelectorAll('.md-search-result__link')].map((one) => one.href)")
        self.assertIn("stability", " ".join(found))
        page.follow(".md-search-result__link", urlsplit(found[0]).path.rsplit("/", 1)[1])

    def change_colours(self, page, dark):
        """There and back again."""
        brightness = "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0)"
        for is_dark in (not dark, dark):
            page.click("[data-md-component=palette] label:not([hidden])",
                       until=f"({brightness} < 382) === {str(is_dark).lower()}")
            appearance.assert_words_are_legible(self, page)

    def test_menu_search_and_colours(self):
        for width, dark in appearance.COMBINATIONS:
            with self.subTest(width=width, dark=dark):
                page = self.open("index.html", width, dark)
                self.change_colours(page, dark)
                self.go_by_the_menu(page, width)
                appearance.assert_it_fits(self, page)
                self.go_by_the_search(page, width)
                appearance.assert_it_fits(self, page)
                appearance.assert_words_are_legible(self, page)
                self.assertEqual(page.errors(), [])
                page.close()


class Links(unittest.TestCase):
    def test_a_link_that_leads_nowhere_is_told(self):
        with self.assertRaisesRegex(ValueError, "docs/page.md: no such file: nowhere.md"):
            relinked("[a](nowhere.md) and `[b](nothing.md)`", "docs/page.md", ROOT)

    def test_where_files_of_the_repository_stand_on_the_site(self):
        text, found = relinked("[a](../README.md#x) [b](../bootstrap) [c](#here) [d](https://example.org)",
                               "docs/manual/../page.md", ROOT)
        self.assertEqual(text, "[a](index.md#x) [b](sources/bootstrap.html) [c](#here) [d](https://example.org)")
        self.assertEqual(found, {"README.md", "bootstrap"})


if __name__ == "__main__":
    unittest.main()
