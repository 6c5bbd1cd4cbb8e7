"""HTML pages of a folder, as far as links go.

    read_site(folder) -> {file: Page(anchors, links, loads)}, files as paths below the folder

`links` are the targets of <a>, `loads` what a browser fetches to show the page: scripts, styles, pictures and frames.
"""

import re
from html.parser import HTMLParser

LOADING = {"script": ["src"], "img": ["src", "srcset"], "link": ["href"], "iframe": ["src"], "source": ["src", "srcset"],
           "object": ["data"], "embed": ["src"], "video": ["src", "poster"], "audio": ["src"],
           "image": ["href", "xlink:href"]}
IN_STYLE = re.compile(r"url\(\s*['\"]?([^'\")]+)|@import\s+['\"]([^'\"]+)")


def loads_of_style(text):
    return [one or other for one, other in IN_STYLE.findall(text)]


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.anchors, self.links, self.loads = set(), [], []
        self.is_style = False
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.anchors |= {given[name] for name in ("id", "name") if given.get(name)}
        self.is_style = tag == "style"
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if tag == "link" and given.get("rel") in ("canonical", "next", "prev"):
            return
        self.loads += [given[name] for name in LOADING.get(tag, []) if given.get(name)]
        self.loads += loads_of_style(given.get("style") or "")

    def handle_endtag(self, tag):
        self.is_style = False

    def handle_data(self, data):
        if self.is_style:
            self.loads += loads_of_style(data)


def read_site(folder):
    return {file.relative_to(folder).as_posix(): Page(file.read_text(encoding="utf-8"))
            for file in sorted(folder.rglob("*.html"))}
