"""Builds the documentation site: `python3 build.py --program PROGRAM [--site FOLDER] [--pages FOLDER]`.

Gathers the pages of docs/, the READMEs they lead to, and what is generated (the deck reference from `dda explain`, the
gallery from the studies) in the folder of pages, has mkdocs make the site from them, strictly, and Doxygen the
interfaces of the families. Everything a page needs is on the site, so that it can be read offline, from files as well.
Exit code 4 where mkdocs or Doxygen refuse; needs Debian's mkdocs, mkdocs-material, doxygen and libjs-mathjax.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from gallery import gallery
from links import FIGURES, relinked, site_path
from reference import reference_pages
from sources import page_of

ROOT = Path(__file__).resolve().parents[2]
MATHJAX = Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ("MathJax.js", "extensions/tex2jax.js", "extensions/MathEvents.js", "extensions/TeX", "jax/element",
                 "jax/input/TeX", "jax/output/SVG/jax.js", "jax/output/SVG/config.js", "jax/output/SVG/autoload",
                 "jax/output/SVG/fonts/TeX")


def write(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def copy(source, target):
    """A file, or a folder with all that is in it."""
    target.parent.mkdir(parents=True, exist_ok=True)
    (shutil.copytree if source.is_dir() else shutil.copyfile)(source, target)


def gather(pages, generated):
    """Pages of docs/ and all files they lead to, and those that these lead to; `generated` is {path: text}."""
    own = [file.relative_to(ROOT).as_posix() for file in sorted((ROOT / "docs").rglob("*.md"))]
    waiting, known = [*generated, *own], set()
    while waiting:
        path = waiting.pop()
        if path in known:
            continue
        known.add(path)
        there = pages / site_path(path)
        if path.endswith(".md"):
            text = generated[path] if path in generated else (ROOT / path).read_text(encoding="utf-8")
            text, found = relinked(text, path, ROOT, generated)
            write(there, text)
            waiting += found
        elif Path(path).suffix in FIGURES:
            copy(ROOT / path, there)
        else:
            write(there, page_of(path, (ROOT / path).read_text(encoding="utf-8")))


def explained(program, *arguments):
    return subprocess.run([program, "explain", *arguments], capture_output=True, text=True, check=True).stdout


def prepare(pages, program):
    """Everything that mkdocs makes the site from."""
    shutil.rmtree(pages, ignore_errors=True)
    reference = reference_pages(json.loads(explained(program, "--json")), explained(program, "parameters"))
    gather(pages, {**{f"docs/reference/{name}.md": text for name, text in reference.items()},
                   "docs/gallery.md": gallery(ROOT)})
    copy(ROOT / "docs/assets", pages / "assets")
    for part in MATHJAX_PARTS:
        copy(MATHJAX / part, pages / "mathjax" / part)


def index_as_script(site):
    """A page that is opened as a file may not read others, but may run scripts: the index of the search becomes one."""
    index = site / "search/search_index.json"
    write(index.with_suffix(".js"), f"var __search = {{index: Promise.resolve({index.read_text(encoding='utf-8')})}};\n")
    index.unlink()


def build(program, site, pages):
    """The site; CalledProcessError where mkdocs or Doxygen refuse."""
    prepare(pages, program)
    environment = {**os.environ, "DDA_SITE_PAGES": str(pages), "DDA_SITE": str(site), "PYTHONDONTWRITEBYTECODE": "1"}
    subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--config-file", ROOT / "docs/mkdocs.yml"], env=environment,
                   check=True)
    index_as_script(site)
    settings = (ROOT / "docs/Doxyfile").read_text(encoding="utf-8") + f'OUTPUT_DIRECTORY = "{site}"\n'
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, cwd=ROOT, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description="Builds the documentation site.")
    parser.add_argument("--program", required=True, help="dda, which explains the deck")
    parser.add_argument("--site", type=Path, default=ROOT / "build/site", help="where the site goes")
    parser.add_argument("--pages", type=Path, default=ROOT / "build/site-pages", help="where its pages are gathered")
    asked = parser.parse_args()
    try:
        build(asked.program, asked.site.resolve(), asked.pages.resolve())
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(f"site: {error}", file=sys.stderr)
        return 4
    print(asked.site.resolve() / "index.html")
    return 0


if __name__ == "__main__":
    sys.exit(main())
