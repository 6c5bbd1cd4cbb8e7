"""run.xdmf and the arrays that it names, against curve.csv, the blocks' displacements and numpy: what ParaView shows of a run.

    test_xdmf.py        with PYTHONPATH=python, and DDA naming the program
"""

import copy
import shutil
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

import h5py
import numpy as np

import ddapath
from program_case import ProgramCase

HERE = Path(__file__).resolve().parent
BEAM = ddapath.read_deck(HERE / "beam.yaml")
CRACKED = ddapath.read_deck(HERE / "cracked_beam.yaml")
FALLING = ddapath.read_deck(HERE.parents[1] / "studies" / "falling-beam" / "deck.yaml")
WEIGHT = {"name": "weight", "loads": [{"type": "body_force", "force": [0, -2e-5]}]}
YOUNG, POISSON = 30000, 0.2
TWO_STAGES = {"stages": [{"name": "half", "loads": BEAM["stages"][0]["loads"], "until": {"load_factor": 300}},
                         {"name": "pull", "loads": [{"type": "point_load", "at": [150, 100], "force": [0, -0.5]}],
                          "until": {"load_factor": 200}}]}


def deck_with(deck, **changes):
    return copy.deepcopy(deck) | changes


class Step:
    """A step of run.xdmf: its time, and of each grid the arrays and numbers by name."""

    def __init__(self, folder, grid):
        self.folder, self.time = folder, float(grid.find("Time").get("Value"))
        self.grids = {part.get("Name"): part for part in grid.findall("Grid")}

    def attributes(self, center, grid="blocks"):
        return {attribute.get("Name"): attribute for attribute in self.grids[grid].findall("Attribute")
                if attribute.get("Center") == center}

    @property
    def field_data(self):
        return {name: float(item.find("DataItem").text) for name, item in self.attributes("Grid").items()}

    def array(self, name, kind, grid="blocks", center="Cell"):
        attribute = self.attributes(center, grid)[name]
        assert attribute.get("AttributeType") == kind, attribute.get("AttributeType")
        return self.content(attribute.find("DataItem"))

    def content(self, item):
        """All that an item has; a reader that takes no part of an array takes this."""
        file, dataset = item.text.split(":")
        with h5py.File(self.folder / file) as store:
            values = store[dataset][()]
        assert [int(n) for n in item.get("Dimensions").split()] == list(values.shape), item.text
        return values


def steps_of(folder):
    grid = xml.parse(folder / "run.xdmf").getroot().find("Domain/Grid")
    return [Step(folder, step) for step in grid.findall("Grid")]


def strains(run, step):
    """(xx, yy, xy) of the blocks from the displacements of their vertices alone: those of a block are linear."""
    out = []
    for _, vertices in run.fields(step).vertices.groupby(level="block"):
        x = np.column_stack([np.ones(len(vertices)), vertices[["x", "y"]]])
        slopes = np.linalg.lstsq(x, vertices[["displacement_x", "displacement_y"]].to_numpy(), rcond=None)[0][1:]
        out.append((slopes[0, 0], slopes[1, 1], (slopes[0, 1] + slopes[1, 0]) / 2))
    return np.array(out)


def tensors(xx, yy, xy, zz=0):
    zero = np.zeros(len(xx))
    return np.column_stack([xx, xy, zero, xy, yy, zero, zero, zero, zero + zz])


def hooke(xx, yy, zz):
    """Normal stresses of an isotropic solid."""
    shear = YOUNG / (2 * (1 + POISSON))
    lame = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    return [2 * shear * strain + lame * (xx + yy + zz) for strain in (xx, yy, zz)]


class XdmfCase(ProgramCase):
    def followed(self, deck, name="run", **changes):
        return ddapath.run(deck_with(deck, **changes), folder=self.folder / name, check=False)

    def assert_close(self, values, expected):
        np.testing.assert_allclose(values, expected, rtol=0, atol=1e-9 * np.abs(expected).max())

    def assert_has_rows_of_curve(self, run, others=()):
        """Each number of a stored step is that of its row, to the last bit."""
        curve = run.curve.set_index("step")
        for step in steps_of(run.folder):
            found = {name: value for name, value in step.field_data.items() if not name.startswith("region ")}
            self.assertLessEqual({"load_factor", "load", "stored_energy", *others}, set(found))
            rows = {name: value for name, value in found.items() if not name.startswith("load_factor_")}
            self.assertEqual(rows, {name: curve[name][step.time] for name in rows})


class Arrays(XdmfCase):
    def test_stresses_and_strains_are_those_of_the_displacements(self):
        run = self.followed(BEAM)
        for step in steps_of(run.folder)[1:]:
            xx, yy, xy = strains(run, int(step.time)).T
            self.assert_close(step.array("strain", "Tensor"), tensors(xx, yy, xy, -POISSON / (1 - POISSON) * (xx + yy)))
            moduli = YOUNG / (1 - POISSON ** 2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, 1 - POISSON]])
            self.assert_close(step.array("stress", "Tensor"), tensors(*(moduli @ [xx, yy, xy])))

    def test_out_of_the_plane_is_what_a_solid_has(self):
        """Free strains and a stress before the load, a warming with it; the solid's Hooke's law in three directions."""
        before = {"name": "before", "loads": [{"type": "initial_strain", "xx": 2e-5, "yy": -1e-5, "zz": 3e-5},
                                              {"type": "initial_stress", "xx": 0.5, "yy": -0.2, "zz": 0.3}]}
        warming = {"type": "initial_strain", "expansion": 1e-5, "temperature": 0.02}
        loaded = {"name": "load", "loads": [*BEAM["stages"][0]["loads"], warming]}
        for kinematics in ("first_order", "second_order"):
            run = self.followed(BEAM, name=kinematics, plane="strain", kinematics=kinematics, stages=[before, loaded],
                                path={"stop": {"after_steps": 3}})
            for step in steps_of(run.folder):
                warm = 1e-5 * 0.02 * step.field_data["load_factor"]
                strain = step.array("strain", "Tensor")
                self.assertFalse(strain[:, 8].any())
                expected = hooke(strain[:, 0] - 2e-5 - warm, strain[:, 4] + 1e-5 - warm, -3e-5 - warm)
                stress = step.array("stress", "Tensor")
                for column, part, prestress in zip((0, 4, 8), expected, (0.5, -0.2, 0.3)):
                    np.testing.assert_allclose(stress[:, column], part + prestress, rtol=0, atol=1e-9)
                np.testing.assert_array_equal(step.array("stress_zz", "Scalar"), stress[:, 8])
        at_vertices, mesh = step.array("stress_at_vertices", "Tensor", center="Node"), run.fields().mesh
        self.assert_close(mesh.means(at_vertices), stress)
        beside = at_vertices - np.repeat(stress, np.diff(mesh.offsets), axis=0)
        self.assert_close(beside[:, 8], POISSON * (beside[:, 0] + beside[:, 4]))

    def test_free_strain_out_of_the_plane_of_a_plate(self):
        free = {"name": "swelling", "loads": [{"type": "initial_strain", "xx": 2e-5, "zz": 3e-5}]}
        run = self.followed(BEAM, stages=[free, *BEAM["stages"]], path={"stop": {"after_steps": 3}})
        step = steps_of(run.folder)[-1]
        stress = step.array("stress", "Tensor")
        self.assertFalse(stress[:, 8].any())
        self.assert_close(step.array("strain_zz", "Scalar"), 3e-5 - POISSON / YOUNG * (stress[:, 0] + stress[:, 4]))

    def assert_principal(self, step, grid):
        larger, smaller = (step.array(f"principal_stress_{i}", "Scalar", grid) for i in (1, 2))
        in_plane = step.array("stress", "Tensor", grid).reshape(-1, 3, 3)[:, :2, :2]
        expected = np.linalg.eigvalsh(in_plane)
        self.assertTrue((larger >= smaller).all())
        np.testing.assert_allclose(np.column_stack([smaller, larger]), expected, rtol=0, atol=1e-12 * max(1, np.abs(expected).max()))
        return len(larger)

    def test_principal_stresses(self):
        steps = steps_of(self.followed(CRACKED).folder)
        for step in steps:
            self.assert_principal(step, "blocks")
        self.assertGreater(self.assert_principal(steps[-1], "parts"), 2)

    def test_stress_of_second_order_varies_about_its_mean(self):
        run = self.followed(BEAM, kinematics="second_order", path={"stop": {"after_steps": 3}})
        step, mesh = steps_of(run.folder)[-1], run.fields().mesh
        at_vertices = step.array("stress_at_vertices", "Tensor", center="Node")
        self.assert_close(mesh.means(at_vertices), step.array("stress", "Tensor"))
        self.assertGreater(np.ptp(at_vertices[:mesh.offsets[1], 0]), 0)

    def test_no_part_of_an_array_is_asked_for(self):
        """ParaView's Xdmf3 takes none; each item names an array of its own size (see Step.content)."""
        run = self.followed(CRACKED)
        self.assertEqual([item for item in xml.parse(run.folder / "run.xdmf").iter("DataItem") if item.get("ItemType")], [])
        for step in steps_of(run.folder):
            for grid in step.grids.values():
                for item in grid.iter("DataItem"):
                    if item.get("Format") == "HDF":
                        step.content(item)

    def test_components_of_cracks(self):
        run = self.followed(CRACKED)
        cracks, last = run.fields().cracks, steps_of(run.folder)[-1]
        for name in ("opening_n", "opening_s", "traction_n", "traction_s"):
            np.testing.assert_array_equal(last.array(name, "Scalar", "cracks"), cracks[name])

    def test_regions(self):
        run = self.followed(CRACKED)
        last = steps_of(run.folder)[-1]
        np.testing.assert_array_equal(last.array("region", "Scalar"), run.fields().mesh.region)
        parts = last.array("region", "Scalar", "parts")
        np.testing.assert_array_equal(parts, run.fields().mesh.region[last.array("block", "Scalar", "parts")])
        for step in steps_of(run.folder):
            self.assertEqual(step.field_data["region 0: beam (concrete)"], 0)


class Numbers(XdmfCase):
    def test_gauges_and_reactions(self):
        run = self.followed(BEAM)
        reactions = [name for name in run.curve if name.startswith(("left", "right"))]
        self.assertEqual(len(reactions), 3)
        self.assert_has_rows_of_curve(run, ("deflection", "cmod", *reactions))

    def test_the_peak_has_its_own(self):
        """Its state is held back until the load falls."""
        run = self.followed(BEAM, record={"fields_every": 0})
        peak = run.summary["peak"]
        self.assertIn(peak["load"], [step.field_data["load"] for step in steps_of(run.folder) if step.time == peak["step"]])
        self.assert_has_rows_of_curve(run)

    def test_stages(self):
        run = self.followed(BEAM, **TWO_STAGES)
        self.assert_has_rows_of_curve(run, ("stage", "load_factor_1", "load_factor_2"))
        first, last = steps_of(run.folder)[0].field_data, steps_of(run.folder)[-1].field_data
        self.assertEqual((first["stage"], last["stage"]), (1, 2))
        self.assertAlmostEqual(last["load_factor_1"], 300)
        self.assertEqual(last["load_factor_2"], last["load_factor"])

    def test_a_gauge_called_time(self):
        run = self.followed(BEAM, gauges={**BEAM["gauges"], "time": BEAM["gauges"]["cmod"]}, path={"stop": {"after_steps": 3}})
        last = steps_of(run.folder)[-1]
        self.assertEqual((last.time, last.field_data["gauge_time"]), (3, run.curve["time"].iloc[-1]))

    def test_a_motion(self):
        motion = self.followed(FALLING).motion
        curve = motion.curve.set_index("step")
        steps = steps_of(motion.folder)
        self.assertEqual(steps[0].time, 0)
        for number, step in list(zip(motion.steps, steps))[1:]:
            self.assertEqual(step.field_data["kinetic_energy"], curve["kinetic_energy"][number])
            for gauge in FALLING["gauges"]:
                self.assertEqual(step.field_data[gauge], curve[gauge][number])
        self.assertTrue([name for name in steps[0].field_data if name.startswith("region 0: ")])


class Start(XdmfCase):
    def test_is_stored_however_seldom_fields_are(self):
        for every in (0, 1000):
            run = self.followed(BEAM, f"every {every}", record={"fields_every": every}, path={"stop": {"after_steps": 3}})
            self.assertEqual([step.time for step in steps_of(run.folder)], [0, 3])
            self.assertEqual(run.steps, [0, 3])
            self.assertEqual(np.abs(steps_of(run.folder)[0].array("stress", "Tensor")).max(), 0)

    def test_carries_the_dead_loads(self):
        run = self.followed(BEAM, stages=[WEIGHT, *BEAM["stages"]], path={"stop": {"after_steps": 2}})
        start = steps_of(run.folder)[0]
        self.assertEqual((start.time, start.field_data["load_factor"]), (0, 0))
        self.assertGreater(start.array("principal_stress_1", "Scalar").max(), 0)
        self.assertEqual(start.field_data["deflection"], run.curve["deflection"][0])

    def test_goes_on_as_if_never_interrupted(self):
        whole = self.followed(BEAM).folder
        part = self.followed(BEAM, "part", path={"stop": {"load_below": 0.1, "after_steps": 12}}).folder
        again = self.folder / "again"
        shutil.copytree(part, again)
        self.dda("resume", str(again), "--quiet", "--set", "path.stop.after_steps=0")
        ours, theirs = ({step.time: step.field_data for step in steps_of(folder)} for folder in (again, whole))
        self.assertEqual({time: ours[time] for time in theirs}, theirs)
        self.assertEqual(min(ours), 0)


if __name__ == "__main__":
    unittest.main()
