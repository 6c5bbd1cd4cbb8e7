"""Loads and controls in Python: what they give is what the built-in ones give, and what they raise comes out."""

import unittest
from pathlib import Path

import numpy as np

import ddapath

ROOT = Path(__file__).resolve().parents[2]
BEAM = ROOT / "tests/program/beam.yaml"
SHORT = {"path.stop.load_below": 0.7}


@ddapath.register_load("block_weights")
class BlockWeights(ddapath.Load):
    """The weight of each block, at its centroid."""

    unit_weight = ddapath.Number("body_force", above=0, text="Weight of a volume.")

    def point_forces(self, blocks):
        weights = self.unit_weight * blocks.thickness * blocks.areas
        return [(place, (0, -weight)) for place, weight in zip(blocks.centroids, weights)]


@ddapath.register_load("astray")
class Astray(ddapath.Load):
    """A force beside the structure."""

    def point_forces(self, blocks):
        return [((1e6, 0), (1, 0))]


@ddapath.register_control("weighted")
class Weighted(ddapath.Control):
    """Half the deflection and the load factor, in its unit."""

    share = ddapath.Number(at_least=0, fallback=0, text="Of the load factor.")

    def prescribed(self, at):
        name = next(name for name in at.values if name != "load_factor")
        assert set(at.rates) == set(at.values)
        return {name: 0.5, "load_factor": self.share}


def deck_with_loads(loads):
    deck = ddapath.read_deck(BEAM)
    deck["stages"] = [{"name": "first", "loads": loads}] + deck["stages"][-1:]
    return deck


class OwnMembers(unittest.TestCase):
    def test_a_load_is_the_built_in_one(self):
        weight = 2.4e-4
        own, built_in = (next(iter(ddapath.follow(deck_with_loads(loads))))
                         for loads in ([{"type": "block_weights", "unit_weight": weight}], [{"type": "body_force", "force": [0, -weight]}]))
        for name, value in built_in.reactions.items():
            self.assertAlmostEqual(own.reactions[name], value, delta=1e-9 * max(map(abs, built_in.reactions.values())))
        np.testing.assert_allclose(own.displacements, built_in.displacements, atol=1e-9 * np.abs(built_in.displacements).max())

    def test_a_load_beside_the_structure_is_told_at_its_place(self):
        with self.assertRaisesRegex(ddapath.InputError, r"stages\.0\.loads\.0.*outside"):
            list(ddapath.follow(deck_with_loads([{"type": "astray"}])))

    def test_a_control_follows_the_same_path(self):
        ends = {}
        for control in ("displacement", "weighted"):
            points = list(ddapath.follow(BEAM, SHORT | {"path.control": control}))
            ends[control] = [max(point.load for point in points), points[-1].load]
        np.testing.assert_allclose(ends["weighted"], ends["displacement"], rtol=2e-3)

    def test_what_a_control_raises_comes_out(self):
        @ddapath.register_control("lost")
        class Lost(ddapath.Control):
            """Names what there is not."""

            def prescribed(self, at):
                return {"deflecton": 1}

        with self.assertRaisesRegex(ValueError, "Lost.prescribed names 'deflecton', which is not among the gauges"):
            list(ddapath.follow(BEAM, SHORT | {"path.control": "lost"}))

    def test_names_and_classes_that_are_no_new_ones(self):
        for register, name in ((ddapath.register_load, "point_load"), (ddapath.register_control, "staged")):
            base = ddapath.Load if register is ddapath.register_load else ddapath.Control
            with self.assertRaisesRegex(ValueError, f"'{name}' is one of the program's"):
                register(name)(type("Mine", (base,), {}))
            with self.assertRaisesRegex(TypeError, "derive it from ddapath"):
                register("another")(int)

        class Other(ddapath.Control):
            weight = ddapath.Number("length", fallback=1)

        with self.assertRaisesRegex(ValueError, "control 'weighted' is registered with other parameters"):
            ddapath.register_control("weighted")(Other)


if __name__ == "__main__":
    unittest.main()
