"""Files of code that the pages lead to, each as a page that needs nothing but itself."""

import html

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">
<title>{path}</title>
<style>
body {{ font: 0.9rem/1.4 ui-monospace, "DejaVu Sans Mono", monospace; margin: 1rem; }}
pre {{ overflow-x: auto; }}
a[href^="#L-"] {{ color: inherit; opacity: 0.5; text-decoration: none; }}
{light}
@media (prefers-color-scheme: dark) {{ body {{ background: #1e2129; color: #d5d7de; }} {dark} }}
</style></head>
<body><h1>{path}</h1>{code}</body></html>
"""


def styles(name):
    formatter = HtmlFormatter(style=name)
    return formatter.get_style_defs(".highlight")


def page_of(path, text):
    """The HTML page of a file, by its path in the repository and its text."""
    try:
        lexer = get_lexer_for_filename(path)
    except ClassNotFound:
        lexer = TextLexer()
    return PAGE.format(path=html.escape(path), light=styles("default"), dark=styles("github-dark"),
                       code=highlight(text, lexer, HtmlFormatter(anchorlinenos=True, lineanchors="L", linenos="inline")))
