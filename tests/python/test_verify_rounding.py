"""`dda verify` of runs some of whose forces are but rounding: true ones pass, doctored ones are refused."""

import json
import tempfile
import unittest
from pathlib import Path

from test_verify import TESTS, Copies


class Couples(Copies):
    """Loads whose reactions are but rounding."""
    deck = TESTS.parent / "studies" / "double-cantilever" / "deck.yaml"
    settings = {"variables.L": 100, "scene.subdivision": {"type": "grid", "columns": 50, "rows": 2}, "path.stop.gauges": {"crack": 0.05}}

    def test_a_true_run_passes(self):
        self.assertEqual(self.refused(), [])

    def test_a_reaction_altered(self):
        self.change_cell("foot", -1, lambda cell: repr(float(cell) + 1e-3))
        self.assertIn("fields agree with curve.csv", self.refused())


BLOCK = {"regions": [{"name": "dam", "material": "m", "vertices": [[0, 0], [10, 0], [10, 40], [0, 40]]}],
         "boundaries": {"base": [[0, 0], [10, 0]], "head": [[0, 40], [10, 40]]},
         "subdivision": {"type": "grid", "columns": 4, "rows": 16}}
STIFF = {"units": {"length": "m"}, "thickness": 1, "scene": BLOCK, "kinematics": {"type": "second_order"},
         "materials": {"m": {"type": "linear_elastic", "young_modulus": 3e10, "poisson_ratio": 0.2}},
         "path": {"control": "load", "stop": {"load_factor_above": 1}}}


class OfDeck(Copies):
    """A run of a deck that stands here."""

    @classmethod
    def setUpClass(cls):
        file = tempfile.NamedTemporaryFile("w", suffix=".yaml")
        cls.addClassCleanup(file.close)
        json.dump(cls.written, file)
        file.flush()
        cls.deck, cls.settings = Path(file.name), {}
        super().setUpClass()


class HeldFromTurning(OfDeck):
    """A support that takes a moment alone, whose turn is next to nothing beside the displacements."""
    written = STIFF | {
        "supports": {"base": {"boundary": "base", "fix": "xy"}, "lev": {"boundary": "head", "fix": "rotation"}},
        "stages": [{"loads": [{"type": "point_load", "at": [0.1, 40], "force": [0, -1e6]}]}],
        "gauges": {"m": {"type": "reaction", "of": "lev"}}}

    def test_a_true_run_passes(self):
        self.assertEqual(self.refused(), [])

    def test_a_moment_altered(self):
        self.change_cell("m", -1, lambda cell: repr(float(cell) * (1 + 1e-7)))
        self.change_cell("lev", -1, lambda cell: repr(float(cell) * (1 + 1e-7)))
        self.assertIn("fields agree with curve.csv", self.refused())


class FreeCooling(OfDeck):
    """Strain that nothing hinders: every force is what rounding leaves of the initial stress."""
    written = STIFF | {
        "supports": {"a": {"at": [0, 0], "fix": "xy"}, "b": {"at": [10, 0], "fix": "y"}},
        "stages": [{"loads": [{"type": "initial_strain", "expansion": 1e-5, "temperature": -30}]}]}

    def test_every_block_is_in_equilibrium(self):
        self.assertNotIn("block equilibrium", self.refused())

    def test_a_strain_altered(self):
        def strain(values):
            values[0] *= 1 + 1e-7
        self.change_dataset("strain", strain)
        self.assertIn("block equilibrium", self.refused())


class Bimetal(OfDeck):
    """A free beam that bends for one half of it grows: its reactions are rounding beside the forces of initial stress."""
    written = STIFF | {
        "kinematics": "first_order", "scene": {
            "regions": [{"name": name, "material": name, "vertices": [[0, y], [1, y], [1, y + 0.05], [0, y + 0.05]]}
                        for name, y in (("a", 0), ("b", 0.05))],
            "subdivision": {"type": "grid", "columns": 60, "rows": 8}},
        "materials": {name: STIFF["materials"]["m"] for name in "ab"},
        "supports": {"a": {"at": [0, 0], "fix": "xy"}, "b": {"at": [0, 0.1], "direction": [1, 0]}},
        "stages": [{"loads": [{"type": "initial_strain", "expansion": 1e-5, "temperature": 100, "materials": ["b"]}]}]}

    def test_a_true_run_passes(self):
        self.assertEqual(self.refused(), [])

    def test_a_block_moved_against_its_support(self):
        """By what makes a force of a few newtons, a hundred-thousandth of those that initial stress exerts."""
        def move(values):
            values[:4, 0] += 2e-15
        self.change_dataset("displacement", move)
        self.assertIn("reactions carry the load", self.refused())


class Jacked(OfDeck):
    """A row of blocks pressed together by a stiff jack, its far end held, and then loaded until it moves forty times as far."""
    written = {
        "units": {"length": "m"}, "thickness": 1, "plane": "stress", "scene": {
            "regions": [{"name": name, "material": material, "vertices": [[x, y], [x + length, y], [x + length, 0.5], [x, 0.5]]}
                        for name, material, x, y, length in (("al", "abut", -0.5, -0.5, 0.5), ("ar", "abut", 3, -0.5, 0.5),
                                                             ("c0", "odd", 0, 0, 1), ("c1", "even", 1, 0, 1), ("c2", "odd", 2, 0, 1))],
            "boundaries": {"l": [[-0.5, -0.5], [-0.5, 0.5]], "r": [[3.5, -0.5], [3.5, 0.5]]},
            "subdivision": {"type": "grid", "columns": 4, "rows": 1}},
        "materials": {name: STIFF["materials"]["m"] | {"young_modulus": 1e10} for name in ("abut", "odd", "even")},
        "interfaces": {name: {"between": ["odd", name], "law": {"type": "linear_softening", "tensile_strength": 1e5, "fracture_energy": 20,
                                                                "cohesion": 1.5e5, "friction_angle": 35}}
                       for name in ("abut", "even")},
        "supports": {"l": {"boundary": "l", "fix": "xy"}, "ry": {"boundary": "r", "fix": "y"}},
        "stages": [
            {"loads": [{"type": "prescribed_displacement", "boundary": "r", "direction": [-1, 0], "displacement": 3e-5, "name": "jack"}],
             "until": {"load_factor": 3}},
            {"loads": [{"type": "body_force", "materials": ["odd", "even"], "force": [0, -2e4]}], "until": {"load_factor": 0.05}},
            {"loads": [{"type": "point_load", "at": [1.743, 0.5], "inside": [1.743, 0.499], "force": [0, -1000]}]}]}

    def test_a_true_run_passes(self):
        self.assertEqual(self.refused(), [])

    def test_a_reaction_altered(self):
        self.change_cell("jack", -1, lambda cell: repr(float(cell) * (1 + 1e-6)))
        self.assertEqual(self.refused(), ["fields agree with curve.csv"])


if __name__ == "__main__":
    unittest.main()
