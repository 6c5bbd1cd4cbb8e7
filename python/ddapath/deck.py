"""Decks as dictionaries: YAML 1.2 as the program reads it, where `1e-5` is a number and `on` a word."""

import os
import re
from pathlib import Path

import yaml

from .errors import NotFound

# Scalars of YAML 1.2's core schema. PyYAML's own are those of 1.1.
NULL = re.compile(r"(?:~|null|Null|NULL|)\Z")
TRUTH = re.compile(r"(?:true|True|TRUE|false|False|FALSE)\Z")
WHOLE = re.compile(r"[-+]?(?:0|[1-9][0-9]*)\Z")
NUMBER = re.compile(r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?\Z"
                    r"|[-+]?\.(?:inf|Inf|INF)\Z|\.(?:nan|NaN|NAN)\Z")


class _Loader(getattr(yaml, "CSafeLoader", yaml.SafeLoader)):  # libyaml's parser, where PyYAML has it, takes a tenth of the time
    yaml_implicit_resolvers = {}


class _Dumper(yaml.SafeDumper):
    yaml_implicit_resolvers = {}

    def ignore_aliases(self, data):
        return True


for _class in (_Loader, _Dumper):
    _class.add_implicit_resolver("tag:yaml.org,2002:null", NULL, ["~", "n", "N", ""])
    _class.add_implicit_resolver("tag:yaml.org,2002:bool", TRUTH, list("tTfF"))
    _class.add_implicit_resolver("tag:yaml.org,2002:int", WHOLE, list("-+0123456789"))
    _class.add_implicit_resolver("tag:yaml.org,2002:float", NUMBER, list("-+.0123456789"))


def plain(value):
    """The value in Python's own types: numpy scalars and arrays, paths and tuples as a deck can hold them."""
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple, range)):
        return [plain(item) for item in value]
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    return os.fspath(value) if isinstance(value, os.PathLike) else value


def load(text):
    """The tree of a YAML text."""
    return yaml.load(text, _Loader)  # a SafeLoader


def dump(tree):
    """YAML text of a tree; lists of numbers and short maps in one line."""
    return yaml.dump(plain(tree), Dumper=_Dumper, sort_keys=False, default_flow_style=None, width=100, allow_unicode=True)


def lines(tree, precise=7, schema=""):
    """YAML text to be read by people: a region, a material, an interface a line; numbers to so many decimals. With the place of a JSON
    schema its first line tells editors of it."""
    def line(indent, begin, value):
        flow = yaml.dump([_rounded(plain(value), precise)], Dumper=_Dumper, sort_keys=False, default_flow_style=True,
                         width=float("inf"), allow_unicode=True)
        return f"{' ' * indent}{begin} {flow.strip()[1:-1]}"

    out = [f"# yaml-language-server: $schema={schema}"] if schema else []
    for key, value in tree.items():
        if not isinstance(value, dict) or key in ("units", "path"):
            out.append(line(0, f"{key}:", value))
            continue
        out.append(f"{key}:")
        for name, item in value.items():
            if name == "regions":
                out += ["  regions:", *(line(4, "-", region) for region in item)]
            else:
                out.append(line(2, f"{name}:", item))
    return "\n".join(out) + "\n"


def _rounded(value, precise):
    if isinstance(value, dict):
        return {key: _rounded(item, precise) for key, item in value.items()}
    if isinstance(value, list):
        return [_rounded(item, precise) for item in value]
    return round(value, precise) if isinstance(value, float) else value


def read_deck(path):
    """The deck in a YAML file, a dictionary; numbers in the deck's own units.

    `scene.file` and `sweep.deck`, which are relative to the deck, become absolute: it may be written elsewhere.
    """
    file = Path(path)
    if not file.is_file():
        raise NotFound(f"{file}: there is no such deck")
    return with_absolute_files(load(file.read_text(encoding="utf-8")), file.resolve().parent)


def with_absolute_files(deck, folder):
    """A copy whose `scene.file` and `sweep.deck` are absolute; relative ones are taken from `folder`."""
    if not isinstance(deck, dict):
        return deck
    for section, key in (("scene", "file"), ("sweep", "deck")):
        found = deck.get(section)
        if isinstance(found, dict) and found.get(key):
            deck = {**deck, section: {**found, key: absolute(found[key], folder)}}
    return deck


def absolute(names, folder):
    """One name, or a list of them."""
    if isinstance(names, (list, tuple)):
        return [absolute(name, folder) for name in names]
    return str(Path(folder) / names)


def write_deck(deck, path):
    """Writes a dictionary as a deck; folders on the way are made. File names in it are relative to that file."""
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(dump(deck), encoding="utf-8")
    return file
