"""The schema that editors judge decks by: every deck of the studies obeys it, and mistakes are told where they are.

    test_schema.py DDA
"""

import copy
import json
import subprocess
import sys
import unittest
from pathlib import Path

import jsonschema

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

from ddapath import deck as decks  # noqa: E402

PROGRAM = sys.argv.pop(1)


BOOLEANS = {"y", "n", "yes", "no", "on", "off", "true", "false"}  # of YAML 1.1, in any case


def keys_of(schema):
    """Names of all keys that a schema knows."""
    if isinstance(schema, list):
        return {key for part in schema for key in keys_of(part)}
    if not isinstance(schema, dict):
        return set()
    own = set(schema.get("properties", {})) if isinstance(schema.get("properties", {}), dict) else set()
    return own.union(*(keys_of(part) for part in schema.values()))


def is_deck(tree):
    return isinstance(tree, dict) and ("scene" in tree or "extends" in tree)


def complaints(schema, deck):
    """(path, message) of all that is wrong."""
    return [(".".join(map(str, error.absolute_path)), error.message)
            for error in jsonschema.Draft7Validator(schema).iter_errors(deck)]


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        said = subprocess.run([PROGRAM, "explain", "--json"], capture_output=True, text=True, check=True)
        cls.schema = json.loads(said.stdout)
        cls.deck = decks.load((ROOT / "studies/softening-bar/deck.yaml").read_text(encoding="utf-8"))

    def test_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(self.schema)

    def test_no_key_is_a_boolean_to_readers_of_yaml_1_1(self):
        keys = keys_of(self.schema)
        self.assertIn("boundary", keys)
        self.assertEqual({key for key in keys if key.lower() in BOOLEANS}, set())

    def test_decks_of_the_studies_obey_it(self):
        count = 0
        for file in sorted((ROOT / "studies").rglob("*.yaml")):
            if file.name == "expect.yaml":
                continue
            tree = decks.load(file.read_text(encoding="utf-8"))
            if not is_deck(tree) or "extends" in tree:  # what a deck extends has the keys it needs
                continue
            count += 1
            self.assertEqual(complaints(self.schema, tree), [], file)
        self.assertGreater(count, 30)

    def test_the_first_line_of_every_deck_of_the_studies_names_it(self):
        """The link leads there from a clone that has been built, and from an installation."""
        self.assertEqual((ROOT / "deck.schema.json").readlink(), Path("build/release/share/ddapath/deck.schema.json"))
        for file in sorted((ROOT / "studies").rglob("*.yaml")):
            if file.name == "expect.yaml" or file.parent.name == "templates":  # `dda new` puts it before those
                continue
            text = file.read_text(encoding="utf-8")
            if is_deck(decks.load(text)):
                self.assertEqual(text.partition("\n")[0], "# yaml-language-server: $schema=../../deck.schema.json", file)

    def changed(self, change):
        deck = copy.deepcopy(self.deck)
        change(deck)
        return complaints(self.schema, deck)

    def test_a_misspelt_key_of_a_law_is_told_as_such(self):
        def misspell(deck):
            law = next(iter(deck["interfaces"].values()))["law"]
            law["tensil_strength"] = law["tensile_strength"]

        [(place, message)] = self.changed(misspell)
        self.assertTrue(place.endswith(".law"), place)
        self.assertIn("'tensil_strength'", message)

    def test_an_unknown_kind_of_law_is_told_with_those_there_are(self):
        def rename(deck):
            next(iter(deck["interfaces"].values()))["law"]["type"] = "softning"

        found = [message for place, message in self.changed(rename) if place.endswith("law.type")]
        self.assertEqual(len(found), 1)
        self.assertIn("linear_softening", found[0])

    def test_keys_that_hold_anchors(self):
        self.assertEqual(self.changed(lambda deck: deck.update({"x-law": {"any": "thing"}})), [])

    def test_what_is_missing_is_told(self):
        found = self.changed(lambda deck: deck.pop("thickness"))
        self.assertIn(("", "'thickness' is a required property"), found)


if __name__ == "__main__":
    unittest.main()
