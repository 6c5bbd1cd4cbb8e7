"""Fragments of decks that pages show, made decks that the program can check.

A comment above a fragment names the deck that it is laid over, and where in it it stands if that is not at the top:

    <!-- over: tests/site/bases/dam.yaml -->
    <!-- over: studies/notched-beam/deck.yaml at interfaces.ligament -->

The deck is a file of the repository, or one that the page has shown. Where a fragment leaves something out, `loads: [...]`,
`law: {...}`, `law: {type: friction, ...}`, there stands what the deck has for that key under `x-elided`; its anchors are known.
"""

import json
import re
import shutil
from pathlib import Path

import yaml

ELIDED = re.compile(r"(\w+): (?:\[\.\.\.\]|\{([^{}]*?)(?:, )?\.\.\.\})")


def filled(text, elided):
    """The fragment with what it leaves out."""

    def whole(match):
        name, said = match.groups()
        value = elided[name]
        if said:
            value = value | yaml.safe_load(f"{{{said}}}")
        return f"{name}: {json.dumps(value)}"

    return ELIDED.sub(whole, text)


def nested(text, place):
    """A fragment at a dotted place of a deck."""
    for key in reversed(place.split(".") if place else []):
        text = f"{key}:\n" + "".join(f"  {line}\n" for line in text.splitlines())
    return text


def laid_over(block, base, folder):
    """The file of a deck, in an empty folder, that is the fragment over the deck `base`, a file."""
    for file in base.parent.glob("*.geo"):
        shutil.copy(file, folder)
    stated = base.read_text(encoding="utf-8")
    text = nested(filled(block.text, yaml.safe_load(stated).get("x-elided")), block.place)
    extends = re.search(r"^extends: (\S+)$", text, re.MULTILINE)
    inner = folder / "deck" / "deck.yaml" if extends else folder / "deck.yaml"
    inner.parent.mkdir(exist_ok=True)
    if extends:  # the fragment names its base itself
        (inner.parent / extends[1]).resolve().write_text(f"extends: {base}\n", encoding="utf-8")
        inner.write_text(text, encoding="utf-8")
    else:
        anchors = "".join(line for line in stated.splitlines(keepends=True) if re.match(r"x-\S+: &", line))
        inner.write_text(f"extends: {base}\n{anchors}{text}", encoding="utf-8")
    return inner
