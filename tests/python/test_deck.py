"""Decks as dictionaries: what is written reads back, as the program reads it."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import ddapath
from ddapath import deck as decks

STUDIES = Path(__file__).resolve().parents[2] / "studies"


class Yaml(unittest.TestCase):
    def test_numbers_are_those_of_yaml_1_2(self):
        found = decks.load("{a: 1e-5, b: 1.0e+05, c: 010, d: .5, e: -3, f: 1:30, g: .inf}")
        self.assertEqual(found, {"a": 1e-5, "b": 1e5, "c": 10, "d": 0.5, "e": -3, "f": "1:30", "g": float("inf")})
        self.assertIsInstance(found["e"], int)

    def test_words_are_those_of_yaml_1_2(self):
        self.assertEqual(decks.load("[on, yes, n, true, null, ~, 2026-01-01]"),
                         ["on", "yes", "n", True, None, None, "2026-01-01"])

    def test_round_trip(self):
        deck = {"text": "1e5", "word": "on", "truth": True, "nothing": None, "empty": "", "numbers": [1, 2.5, 1e-13, 1e300],
                "nested": {"a": [[0, 0], [1, 0]], "b": {}}, "µ": "a: b # c", "exact": 0.1 + 0.2}
        self.assertEqual(decks.load(decks.dump(deck)), deck)

    def test_lines_read_back_to_their_decimals(self):
        deck = {"title": "a: b", "units": {"length": "m", "force": "N"},
                "scene": {"type": "polygons", "regions": [{"name": "r", "vertices": [[0, 0.25], [1 / 3, 2]]}]},
                "thickness": 1, "materials": {"m": {"type": "linear_elastic", "young_modulus": 1e10}}}
        found = decks.load(decks.lines(deck))
        self.assertEqual(found["scene"]["regions"][0]["vertices"], [[0, 0.25], [0.3333333, 2]])
        self.assertEqual({**found, "scene": None}, {**deck, "scene": None})

    def test_values_of_numpy_and_paths(self):
        deck = {"a": np.float64(0.1), "b": np.arange(3), "c": (1, 2), "d": Path("x/y"), "e": range(2), "f": np.bool_(True)}
        self.assertEqual(decks.load(decks.dump(deck)),
                         {"a": 0.1, "b": [0, 1, 2], "c": [1, 2], "d": "x/y", "e": [0, 1], "f": True})

    def test_the_same_list_twice_is_written_twice(self):
        at = [0, 1]
        self.assertNotIn("&", decks.dump({"a": at, "b": at}))


class Files(unittest.TestCase):
    def test_a_deck_may_be_written_elsewhere(self):
        with tempfile.TemporaryDirectory() as folder:
            deck = ddapath.read_deck(STUDIES / "notched-beam" / "deck.yaml")
            file = ddapath.write_deck(deck, Path(folder) / "below" / "deck.yaml")
            again = ddapath.read_deck(file)
        self.assertEqual(again, deck)
        self.assertEqual(deck["scene"]["file"], str(STUDIES / "notched-beam" / "beam.geo"))

    def test_a_deck_that_is_not_there(self):
        with self.assertRaisesRegex(ddapath.NotFound, "nowhere.yaml: there is no such deck"):
            ddapath.read_deck("nowhere.yaml")

    def test_decks_of_a_sweep(self):
        found = decks.with_absolute_files({"sweep": {"deck": ["a.yaml", "/b.yaml"]}}, "/c")
        self.assertEqual(found["sweep"]["deck"], ["/c/a.yaml", "/b.yaml"])


if __name__ == "__main__":
    unittest.main()
