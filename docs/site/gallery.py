"""The gallery: every study with its first picture, its title and the sentence it begins with, from its README."""

import posixpath
import re

HEAD = """# Gallery

Every study is a folder with decks, expected numbers and what there is to see. A click on its name leads to its page.

<div class="gallery" markdown>
"""


def first(pattern, text, flags=re.MULTILINE):
    match = re.search(pattern, text, flags)
    return match[1] if match else ""


def sentence_of(text):
    """The first sentence of the first paragraph that is one."""
    for paragraph in re.split(r"\n\s*\n", text):
        if re.match(r"[A-Z*]", paragraph):
            whole = " ".join(paragraph.split())
            whole = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", whole)
            return first(r"(.*?[.:])(?:\s|$)", whole + " ").rstrip(":.") + "."
    return ""


def card(folder):
    """A study's entry, as in a file in docs/."""
    text = (folder / "README.md").read_text(encoding="utf-8")
    title, picture = first(r"^# (.*)$", text), first(r"!\[[^]]*\]\(([^)]+)\)", text)
    home = f"../studies/{folder.name}"
    image = f"![{title}]({posixpath.normpath(f'{home}/{picture}')})\n\n" if picture else ""
    return f"<div markdown>\n\n**[{title}]({home}/README.md)**\n\n{image}{sentence_of(text)}\n\n</div>\n"


def gallery(root):
    """The page, as a file in docs/ would have it."""
    cards = [card(readme.parent) for readme in sorted((root / "studies").glob("*/README.md"))]
    return HEAD + "\n".join(cards) + "\n</div>\n"
