"""Cracks through blocks, from the deck to what a user sees: independent verification of runs of every kind, grids of run.xdmf,
restarts and threads bit for bit, the same beam turned, mirrored and in other units.

    test_cracks.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import json
import math
import random
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import h5py
import numpy as np

import ddapath
from ddapath.verify import verify

sys.path.insert(0, str(Path(__file__).resolve().parent))
from same_fields import datasets  # noqa: E402

BEAM = ddapath.read_deck(Path(__file__).resolve().parent / "cracked_beam.yaml")
STUDIES = Path(__file__).resolve().parents[2] / "studies"
AREA = 300 * 100
JOINTS = BEAM["interfaces"]["joints"]
WEIGHT = {"name": "weight", "loads": [{"type": "body_force", "force": [0, -2e-5]}]}
PRESTRESS = {"name": "prestress", "loads": [{"type": "initial_stress", "xx": -0.3, "xy": 0.1}]}
DRIVEN = {"name": "driven", "loads": [{"type": "prescribed_displacement", "over": [[140, 100], [160, 100]], "direction": [0, -1]}]}
LEGS = [{**BEAM["stages"][0], "until": {"cmod": 0.04}}, {"name": "unloading", "unload": True, "until": {"load": 0}},
        {"name": "reloading", "until": {"cmod": 0.07}}, {"name": "half", "unload": True, "until": {"load": 800}}, {"name": "last"}]
# Held where the crack arrives, and pushed up at the ends: it runs between the supports, through blocks that they hold.
UPWARD = {"supports": {"top": {"at": [117, 100], "fix": "xy"}, "beside": {"at": [129, 100], "fix": "y"}},
          "stages": [{"loads": [{"type": "point_load", "at": [x, 0], "force": [0, 1]} for x in (0, 300)]}],
          "gauges": {"lift": {"type": "displacement", "at": [0, 0], "direction": [0, 1]}}}
CLAMPED = UPWARD | {"scene.boundaries": {"top": [[90, 100], [150, 100]]}, "supports": {"top": {"boundary": "top", "fix": "xy"}},
                    "path.stop": {"gauges": {"lift": 0.5}}}
VARIANTS = {
    "as it is": {},
    "quads": {"scene.subdivision": {"type": "quads", "size": 10}},
    "triangles": {"scene.subdivision": {"type": "triangles", "size": 16}},
    "under its weight": {"stages": [WEIGHT, *BEAM["stages"]]},
    "with initial stress": {"stages": [PRESTRESS, *BEAM["stages"]]},
    "driven": {"stages": [DRIVEN]},
    "of random strength": {"interfaces.joints.field": {"coefficient_of_variation": 0.15, "correlation_length": 30}},
    "unloaded and loaded again": {"stages": LEGS},
    "cut between its supports": {**UPWARD, "path.stop.load_below": 0.02},
    "cut up to where it is held": CLAMPED,
}


def deck_with(changes):
    deck = copy.deepcopy(BEAM)
    for key, value in changes.items():
        *path, last = key.split(".")
        node = deck
        for name in path:
            node = node[name]
        node[last] = value
    return deck


class InScratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = Path(scratch.name)

    def run_(self, changes=None, name="run", deck=None):
        return ddapath.run(deck or deck_with(changes or {}), folder=self.scratch / name, overwrite=True)


def resume(folder, *settings):
    options = [word for setting in settings for word in ("--set", setting)]
    subprocess.run([str(ddapath.find_program()), "resume", str(folder), "--quiet", *options], check=True, capture_output=True)


class Verified(InScratch):
    def test_runs_of_every_kind(self):
        for name, changes in VARIANTS.items():
            with self.subTest(name):
                run = self.run_(changes)
                self.assertEqual(run.status, "goal_reached")
                refused = [(finding.check, finding.worst, finding.place) for finding in verify(run.folder) if not finding.holds]
                self.assertEqual(refused, [])
                self.assertGreater(len(run.crack_path()), 3)
                self.assertGreater((run.cracks()["damage"] > 0.9).sum(), 4)

    def test_two_cracks_towards_each_other(self):
        """From notches on either side of a plate in tension: both grow, and what is stored is in equilibrium throughout."""
        run = self.run_(deck=ddapath.read_deck(Path(__file__).resolve().parent / "two_notches.yaml"))
        self.assertEqual(run.status, "goal_reached")
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        self.assertGreater(run.summary["peak"]["load"], 0.75 * 3 * 40 * 10)  # strength of what the notches leave

    def test_a_random_field_is_felt_on_cuts(self):
        cracks = self.run_(VARIANTS["of random strength"]).cracks()
        self.assertGreater(cracks["strength_factor"].std(), 0.03)
        self.assertGreater(len(set(cracks["strength_factor"])), len(cracks) // 2)

    def test_unloading_closes_along_the_secant(self):
        """What a crack through blocks carries falls with its opening, in proportion: the damage stays."""
        run = self.run_(VARIANTS["unloaded and loaded again"] | {"record.fields_every": 1})
        control = run.curve["control"]
        steps = [step for step in run.steps if str(control[step]) == "unloading"]
        self.assertGreater(len(steps), 0)
        before, after = (run.fields(step).cracks for step in (steps[0] - 1, steps[0]))
        self.assertEqual(len(before), len(after))
        opened = (before["damage"] > 0.1) & (after["opening_n"] > 0) & (before["opening_n"] > 0)
        self.assertGreater(opened.sum(), 3)
        np.testing.assert_allclose(after["damage"], before["damage"], atol=1e-12)
        secant = [(table["traction_n"] / table["opening_n"])[opened].to_numpy() for table in (before, after)]
        np.testing.assert_allclose(*secant, rtol=1e-6)


class FirstLoad(InScratch):
    def test_a_crack_at_its_strength_before_the_load_sets_out(self):
        """A shear force that stays brings a crack to its strength; that it grows is no loading of the tension that follows."""
        deck = ddapath.read_deck(STUDIES / "crack-paths" / "double-notch.yaml")
        deck["scene"]["subdivision"] = {"type": "voronoi", "size": 5.656854249492381, "seed": 2}
        run = self.run_(deck=deck)
        self.assertEqual(run.status, "goal_reached")
        self.assertLess(run.curve["load"][1:4].min(), 0)
        self.assertGreater(run.summary["peak"]["load"], 15000)  # half of the strength of the section between the notches


class Begun(InScratch):
    def test_the_direction_in_which_a_crack_is_begun_decides_next_to_nothing(self):
        """A notch under shear: from straight on to 45° the peak stays where the blocks' pattern leaves it, within 1.5 %."""
        deck = ddapath.read_deck(STUDIES / "crack-paths" / "shear-beam.yaml")
        peaks = []
        for across in (0, 0.5, 1):
            deck["cracks"][0]["begin"][0]["direction"] = [across, 1]
            peaks.append(self.run_(deck=deck).summary["peak"]["load"])
        self.assertLess(max(peaks) / min(peaks), 1.015)


class Names(InScratch):
    def test_an_interface_that_there_is_not_is_refused_with_the_nearest_name(self):
        for key, value in (("end_at", ["joint"]), ("law", "joint")):
            file = self.scratch / "deck.yaml"
            file.write_text(json.dumps(deck_with({"cracks": [BEAM["cracks"][0] | {key: value}]})), encoding="utf-8")
            done = subprocess.run([str(ddapath.find_program()), "check", str(file)], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, key)
            self.assertIn(f"`{key}`: unknown interface 'joint'; did you mean 'joints'?", done.stdout + done.stderr)


class Friction(InScratch):
    def test_a_crack_that_closes_bears_shear_by_friction_alone(self):
        """Opened by bending, closed again by the load turned round: what slides on the broken cuts is at -t_n tan φ. A crack
        across the tension would close without sliding: this one is kept on a slope."""
        turned = [{**BEAM["stages"][0], "until": {"cmod": 0.1}}, {"name": "reversal", "unload": True, "until": {"load": -2000}}]
        sloping = {"begin": [{"at": [120, 30], "direction": [0.8, 1]}], "direction": {"type": "nonlocal_stress", "largest_turn": 0}}
        run = self.run_({"stages": turned, "path.stop": {}, "cracks": [{"through_blocks": ["beam"], **sloping}]})
        self.assertEqual([finding.check for finding in verify(run.folder) if not finding.holds], [])
        cracks = run.cracks()
        closed = cracks[(cracks["damage"] > 0.999) & (cracks["traction_n"] < -0.01)]
        self.assertGreater(len(closed), 1)
        slope = (closed["traction_s"].abs() / -closed["traction_n"]).max()
        self.assertAlmostEqual(slope, math.tan(math.radians(JOINTS["law"]["friction_angle"])), delta=0.01 * slope)


class Xdmf(InScratch):
    def test_every_grid_is_what_its_datasets_hold(self):
        run = self.run_()
        tree = xml.parse(run.folder / "run.xdmf")
        grids = [grid for grid in tree.iter("Grid") if grid.get("GridType") == "Uniform"]
        self.assertEqual({grid.get("Name") for grid in grids}, {"blocks", "parts", "cracks"})
        for item in tree.iter("DataItem"):
            if item.get("Format") == "HDF":
                file, dataset = item.text.split(":")
                with h5py.File(run.folder / file) as store:
                    self.assertEqual([int(n) for n in item.get("Dimensions").split()], list(store[dataset].shape), item.text)

    def test_blocks_and_parts_fill_the_beam(self):
        run = self.run_()
        for step in run.steps:
            with h5py.File(run.folder / "fields/mesh.h5") as mesh, h5py.File(run.folder / f"fields/{step:06}.h5") as store:
                is_cut = "parts" in store
                shown = polygons(mesh["mesh/vertices"][()], store["parts/whole"][()] if is_cut else mesh["mesh/mixed"][()])
                shown += polygons(store["parts/vertices"][()], store["parts/mixed"][()]) if is_cut else []
            self.assertAlmostEqual(sum(map(area, shown)), AREA, places=6)


def polygons(vertices, mixed):
    out, at = [], 0
    while at < len(mixed):
        assert mixed[at] == 3
        count = mixed[at + 1]
        out.append(vertices[mixed[at + 2:at + 2 + count], :2])
        at += 2 + count
    return out


def area(outline):
    x, y = outline.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


class Restart(InScratch):
    def test_from_any_step_bit_for_bit(self):
        """From before, at and after every growth of the crack, and between: the same curve, fields and grids."""
        whole = self.run_(name="whole")
        grown = np.flatnonzero(whole.curve["control"] == "growth")
        self.assertGreater(len(grown), 4)
        last = len(whole.curve) - 1
        steps = {step + k for step in grown for k in (-1, 0, 1)} | set(range(3, last, 27))
        expected = datasets(whole.folder)
        for step in sorted(int(step) for step in steps if 0 < step < last):
            with self.subTest(step=step):
                run = self.run_({"path.stop.after_steps": step}, "part")
                resume(run.folder, "path.stop.after_steps=0")
                self.assertEqual((run.folder / "curve.csv").read_bytes(), (whole.folder / "curve.csv").read_bytes())
                found = datasets(run.folder)
                different = [name for name in expected if "provenance" not in name and found.get(name) != expected[name]]
                self.assertEqual(different, [])
                self.assertEqual(run.summary["peak"], whole.summary["peak"])

    def test_unloading_legs_bit_for_bit(self):
        legs = VARIANTS["unloaded and loaded again"]
        whole = self.run_(legs, "whole")
        for step in range(2, len(whole.curve) - 1, 11):
            with self.subTest(step=step):
                run = self.run_(legs | {"path.stop.after_steps": step}, "part")
                resume(run.folder, "path.stop.after_steps=0")
                self.assertEqual((run.folder / "curve.csv").read_bytes(), (whole.folder / "curve.csv").read_bytes())

    def test_beside_contact_bit_for_bit(self):
        """Contacts are solved on a base of their own, which is made when first they are and grows with the cracks."""
        lintel = ddapath.read_deck(Path(__file__).resolve().parent / "cracked_lintel.yaml")
        whole = self.run_(deck=lintel, name="whole")
        self.assertGreater((whole.curve["control"] == "growth").sum(), 4)
        for step in range(2, len(whole.curve) - 1, 20):
            with self.subTest(step=step):
                run = self.run_(deck=lintel | {"path": lintel["path"] | {"stop": {"load_below": 0.2, "after_steps": step}}}, name="part")
                resume(run.folder, "path.stop.after_steps=0")
                self.assertEqual((run.folder / "curve.csv").read_bytes(), (whole.folder / "curve.csv").read_bytes())

    def test_a_crack_that_is_stuck_stays_stuck(self):
        """Without inertia a crack curls where a beam is all but broken; a resumed run says the same and adds nothing."""
        deck = ddapath.read_deck(STUDIES / "crack-paths" / "l-panel.yaml")
        deck["scene"]["subdivision"] = {"type": "voronoi", "size": 25, "seed": 1}
        deck["cracks"][0]["direction"] = {"type": "nonlocal_stress", "inertia": 0}
        with self.assertRaises(ddapath.StoppedEarly) as stopped:
            self.run_(deck=deck)
        run = stopped.exception.results
        self.assertIn("turns back", run.summary["reason"])
        before = (run.folder / "curve.csv").read_bytes()
        self.assertEqual(subprocess.run([str(ddapath.find_program()), "resume", str(run.folder), "--quiet"], capture_output=True).returncode, 3)
        self.assertEqual((run.folder / "curve.csv").read_bytes(), before)
        self.assertEqual(ddapath.read_run(run.folder).summary["reason"], run.summary["reason"])


class Stability(InScratch):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        wanted = {"record.eigenvalues": {"count": 3}, "scene.subdivision.blocks": 60}
        cls.whole = ddapath.run(deck_with(wanted), folder=Path(scratch.name) / "run")

    def test_one_eigenvalue_is_negative_where_the_load_falls(self):
        """Three that are found apart: the lowest mode, the pivots' signs, and the rate of the load along the path; where a
        crack grows damage is frozen and the structure is another one."""
        curve = self.whole.curve[self.whole.curve["control"] == "dissipation"]
        falls = curve["current_stiffness"] < 0
        self.assertTrue(10 < falls.sum() < len(curve) - 10)
        self.assertEqual((curve["mu_1"] < 0).tolist(), falls.tolist())
        self.assertEqual(curve["negative_eigenvalues"].tolist(), falls.astype(int).tolist())
        self.assertTrue((curve["mu_2"] > 0).all(), "one crack, one direction in which the load falls")

    def test_modes_go_on_where_a_crack_grows(self):
        """Damage frozen before as after, a closed cut ahead changes next to nothing, however many unknowns it brings."""
        curve = self.whole.curve
        is_frozen = curve["control"].isin(["growth", "event"])
        grown = curve.index[(curve["control"] == "growth") & is_frozen.shift(fill_value=False)]
        self.assertGreater(len(grown), 0)
        for name in ("mu_1", "mu_2", "mu_3", "mu_ratio_1", "mu_ratio_2", "mu_ratio_3"):
            np.testing.assert_allclose(curve[name][grown].to_numpy(), curve[name][grown - 1].to_numpy(), rtol=1e-3)
        self.assertFalse(curve[["mu_ratio_2", "mu_ratio_3"]].isna().any(axis=None))

    def test_modes_are_stored_for_parts(self):
        fields = self.whole.fields()
        moved = np.hypot(fields.part_vertices["mode_1_x"], fields.part_vertices["mode_1_y"])
        of_blocks = np.hypot(fields.vertices["mode_1_x"], fields.vertices["mode_1_y"])
        self.assertAlmostEqual(max(moved.max(), of_blocks.max()), 1, places=12)
        self.assertGreater(moved.max(), 0)

    def test_resumed_with_modes_bit_for_bit(self):
        whole = self.whole.folder
        for step in range(4, len(self.whole.curve) - 1, 13):
            part = self.run_({"record.eigenvalues": {"count": 3}, "scene.subdivision.blocks": 60, "path.stop.after_steps": step}, "part")
            resume(part.folder, "path.stop.after_steps=0")
            self.assertEqual((part.folder / "curve.csv").read_bytes(), (whole / "curve.csv").read_bytes())

    def test_the_stiffness_by_contribution_has_the_jumps(self):
        few = {"scene.subdivision": {"type": "voronoi", "blocks": 9, "seed": 2}, "record.stiffness": True, "scene.slits": {},
               "cracks": [{"through_blocks": ["beam"], "begin": [{"at": [120, 0], "direction": [0, 1]}]}], "gauges": {}}
        run = self.run_(few)
        through = (run.fields().cut.cuts["side"] < 0).sum()
        self.assertGreater(through, 0)
        stiffness = json.loads((run.folder / "stiffness.json").read_text())["end"]["physical"]
        for name in ("strain", "contact", "support", "weak"):
            self.assertEqual(np.array(stiffness[name]).shape, 2 * (6 * (run.summary["blocks"] + through),))
        self.assertIn("and jump 1", (run.folder / "stiffness.txt").read_text())


GRID = (24, 8)  # blocks


def corners():
    """Of blocks that are no rectangles, over the beam 300 × 100, and the quads by their corners."""
    chance = random.Random(3)
    nx, ny = GRID
    places = []
    for j in range(ny + 1):
        for i in range(nx + 1):
            inner_x, inner_y = 0 < i < nx, 0 < j < ny
            places.append((300 * (i + inner_x * inner_y * chance.uniform(-0.3, 0.3)) / nx,
                           100 * (j + inner_x * inner_y * chance.uniform(-0.3, 0.3)) / ny))
    quads = [(k, k + 1, k + nx + 2, k + nx + 1) for j in range(ny) for k in range(j * (nx + 1), j * (nx + 1) + nx)]
    return places, quads


class Elsewhere:
    """The beam by a map of the plane: turned by an angle, mirrored first if wanted, and scaled to other units.

    A length l becomes scale · l, a stress σ stress · σ; the thickness is scaled too.
    """

    def __init__(self, angle=0.0, mirrored=False, scale=1.0, stress=1.0):
        self.scale, self.stress, self.sign = scale, stress, -1.0 if mirrored else 1.0
        self.cosine, self.sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))

    def direction(self, x):
        a, b = self.sign * x[0], x[1]
        return [self.cosine * a - self.sine * b, self.sine * a + self.cosine * b]

    def place(self, x):
        return [self.scale * value for value in self.direction(x)]

    def mesh(self, file):
        places, quads = corners()
        out = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1", '2 1 "material:concrete/beam"', "$EndPhysicalNames",
               "$Nodes", str(len(places))]
        out += [f"{i} {x:.17g} {y:.17g} 0" for i, (x, y) in enumerate(map(self.place, places), 1)]
        out += ["$EndNodes", "$Elements", str(len(quads))]
        order = (lambda quad: quad[::-1]) if self.sign < 0 else (lambda quad: quad)
        out += [f"{i} 3 2 1 1 {' '.join(str(k + 1) for k in order(quad))}" for i, quad in enumerate(quads, 1)]
        file.write_text("\n".join([*out, "$EndElements", ""]), encoding="utf-8")

    def deck(self, file):
        self.mesh(file)
        law = {"type": "linear_softening", "tensile_strength": 3 * self.stress, "fracture_energy": 0.1 * self.stress * self.scale}
        begin = self.place([112.5, 0])
        over = [self.place([x, 100]) for x in (137.5, 162.5)]
        return {"scene": {"type": "msh", "file": str(file)}, "thickness": 100 * self.scale, "plane": "stress",
                "materials": {"concrete": {"type": "linear_elastic", "young_modulus": 30000 * self.stress, "poisson_ratio": 0.2}},
                "interfaces": {"joints": {"between": ["concrete", "concrete"], "law": law}},
                "cracks": [{"through_blocks": ["beam"], "begin": [{"at": begin, "direction": self.direction([0.05, 1])}]}],
                "supports": {name: {"at": self.place(at), "direction": self.direction(along)}
                             for name, at, along in (("left_x", [0, 0], [1, 0]), ("left", [0, 0], [0, 1]), ("right", [300, 0], [0, 1]))},
                "stages": [{"loads": [{"type": "point_load", "over": over,
                                       "force": [self.stress * self.scale**2 * value for value in self.direction([0, -1])]}]}],
                "gauges": {"deflection": {"type": "displacement", "at": self.place([150, 100]), "direction": self.direction([0, -1])}},
                "path": {"stop": {"load_below": 0.3}}}


class Invariant(InScratch):
    SAME = 1e-8

    def follow(self, name, where):
        run = self.run_(name=name, deck=where.deck(self.scratch / f"{name}.msh"))
        curve = run.curve
        return (curve["load"].to_numpy() / (where.stress * where.scale**2), curve["deflection"].to_numpy() / where.scale,
                run.crack_path())

    def test_turned_mirrored_and_in_other_units(self):
        load, deflection, path = self.follow("as it is", Elsewhere())
        self.assertGreater(len(path), 6)
        turn = np.abs(np.diff(np.degrees(np.arctan2(*np.diff(path, axis=0).T[::-1])))).max()
        self.assertGreater(turn, 3, "a crack that goes straight on would hide a wrong direction")
        for name, where in {"turned": Elsewhere(angle=37), "mirrored": Elsewhere(mirrored=True),
                            "both": Elsewhere(angle=-101, mirrored=True), "in m and MPa": Elsewhere(scale=1e-3),
                            "in mm and Pa": Elsewhere(stress=1e6)}.items():
            with self.subTest(name):
                other_load, other_deflection, other_path = self.follow(name, where)
                self.assertEqual(len(other_load), len(load))
                np.testing.assert_allclose(other_load, load, rtol=0, atol=self.SAME * load.max())
                np.testing.assert_allclose(other_deflection, deflection, rtol=0, atol=self.SAME * deflection.max())
                expected = np.array([where.place(x) for x in path])
                np.testing.assert_allclose(other_path, expected, rtol=0, atol=self.SAME * 300 * where.scale)


if __name__ == "__main__":
    unittest.main()
