"""Where the files of the repository stand on the site, and links of Markdown pages led there.

    site_path("docs/manual/deck.md")                -> "manual/deck.md"
    site_path("models/interface/law.hpp")           -> "sources/models/interface/law.hpp.html"
    relinked(text, "studies/two-cracks/README.md", root, generated) -> (text, files of the repository that it leads to)
"""

import posixpath
import re
from pathlib import PurePosixPath

FIGURES = {".svg", ".png", ".gif"}
# Code, in which nothing is a link, and the target of a link or picture.
CODE_OR_TARGET = re.compile(r"^```.*?^```|`[^`\n]*`|\]\(([^)\s]+)\)", re.MULTILINE | re.DOTALL)


def site_path(path):
    """Where a file of the repository, by its path there, stands on the site, before Markdown becomes HTML."""
    if path.startswith("docs/"):
        return path.removeprefix("docs/")
    if path == "README.md":
        return "index.md"
    if PurePosixPath(path).suffix in FIGURES | {".md"}:
        return path
    return f"sources/{path}.html"


def target_of(link, page, root):
    """The file of the repository that a link on a page leads to, by its path there; "" where it leads elsewhere."""
    if re.match(r"[a-z]+:|#", link):
        return ""
    path = posixpath.normpath(posixpath.join(posixpath.dirname(page), link.split("#")[0]))
    if (root / path).is_dir():
        path = posixpath.join(path, "README.md")
    return path


def relinked(text, page, root, generated=()):
    """A page of the repository as it stands on the site, and the files that it leads to. Links to pages that are
    generated there are right as they are. ValueError with the page and the links that lead nowhere."""
    found, lost = set(), []

    def lead(match):
        link = match[1]
        path = target_of(link, page, root) if link else ""
        if not path or path in generated:
            return match[0]
        if not (root / path).is_file():
            lost.append(link)
            return match[0]
        found.add(path)
        there = posixpath.relpath(site_path(path), posixpath.dirname(site_path(page)) or ".")
        anchor = link[link.index("#"):] if "#" in link else ""
        return f"]({there}{anchor})"

    out = CODE_OR_TARGET.sub(lead, text)
    if lost:
        raise ValueError(f"{page}: no such file: {', '.join(lost)}")
    return out, found
