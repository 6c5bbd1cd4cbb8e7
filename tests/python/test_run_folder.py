"""Reading the folder of a real run: as it is, and as a program that is still at it, or was killed, leaves it."""

import json
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np

import ddapath

DECK = Path(__file__).resolve().parents[1] / "program" / "beam.yaml"


class Folder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.original = Path(cls.scratch.name) / "run"
        ddapath.run(DECK, {"path.stop.load_below": 0.6, "record.fields_every": 4}, folder=cls.original)

    def setUp(self):
        self.folder = Path(self.scratch.name) / "copy"
        shutil.copytree(self.original, self.folder)
        self.addCleanup(shutil.rmtree, self.folder)

    def read(self):
        return ddapath.read_run(self.folder)


class Finished(Folder):
    def test_summary_and_curve_agree(self):
        run = self.read()
        self.assertEqual(run.status, "goal_reached")
        self.assertEqual(run.curve["load"].max(), run.summary["peak"]["load"])
        self.assertEqual(len(run.curve), run.summary["steps"] + 1)
        self.assertEqual(run.curve.attrs["units"]["load"], "N")

    def test_whole_numbers_longer_than_64_bits_are_numbers(self):
        file = self.folder / "curve.csv"
        header, *rows = file.read_text(encoding="utf-8").splitlines()
        last = rows[-1].split(",")
        last[header.split(",").index("load")] = "1249999999999999475712"
        file.write_text("\n".join([header, *rows[:-1], ",".join(last)]) + "\n", encoding="utf-8")
        curve = self.read().curve
        self.assertEqual(curve["load"].iloc[-1], 1249999999999999475712.0)
        self.assertEqual(curve["control"].dtype, object)

    def test_deck_is_the_effective_one(self):
        self.assertEqual(self.read().deck["path"]["stop"]["load_below"], 0.6)
        self.assertEqual(self.read().deck["path"]["control"], "staged")

    def test_log(self):
        events = [entry["event"] for entry in self.read().log]
        self.assertEqual(events.count("step"), self.read().summary["steps"])

    def test_fields_are_those_of_the_curve(self):
        run = self.read()
        self.assertIn(4, run.steps)
        fields = run.fields(4)
        self.assertEqual(fields.load_factor, run.curve["load_factor"][4])
        for name in ("load", "cmod", "right", "dissipated_energy"):
            self.assertEqual(fields.numbers[name], run.curve[name][4])
        self.assertEqual(len(fields.blocks), run.summary["blocks"])
        self.assertEqual(len(fields.points), run.summary["crackable_points"])
        self.assertAlmostEqual(fields.blocks["area"].sum(), 300 * 100, places=6)
        lips = fields.vertices[np.hypot(fields.vertices["x"] - 150, fields.vertices["y"]) < 1e-9]["displacement_x"]
        self.assertEqual(len(lips), 2)
        self.assertAlmostEqual(lips.max() - lips.min(), run.curve["cmod"][4], places=12)

    def test_the_last_fields_by_default(self):
        self.assertEqual(self.read().fields().step, self.read().steps[-1])

    def test_a_step_that_is_not_stored(self):
        with self.assertRaisesRegex(ddapath.NothingStored, "step 3 are not stored; those of 0, 4, 8"):
            self.read().fields(3)


class Unfinished(Folder):
    def test_no_summary(self):
        (self.folder / "summary.json").unlink()
        run = self.read()
        self.assertEqual((run.status, run.summary), ("unfinished", {}))
        self.assertGreater(len(run.curve), 4)

    def test_half_a_line(self):
        lines = len(self.read().curve), len(self.read().log)
        for name, text in (("curve.csv", "999,1.2"), ("log.jsonl", '{"event": "st')):
            with (self.folder / name).open("a", encoding="utf-8") as stream:
                stream.write(text)
        self.assertEqual((len(self.read().curve), len(self.read().log)), lines)

    def test_nothing_but_the_deck(self):
        for name in ("curve.csv", "fields/mesh.h5", "summary.json"):
            (self.folder / name).unlink()
        run = self.read()
        self.assertEqual(run.deck["title"], "Small notched beam of Voronoi blocks, every interface able to crack")
        for ask in (lambda: run.curve, lambda: run.steps, run.fields):
            with self.assertRaisesRegex(ddapath.NothingStored, r"this run has no (curve.csv|fields/mesh.h5) \(yet\)"):
                ask()

    def test_a_step_that_was_cut_short(self):
        for name in ("000999.h5.part", "999.h5"):
            (self.folder / "fields" / name).write_bytes(b"half a step")
        self.assertNotIn(999, self.read().steps)

    def test_a_step_that_is_damaged(self):
        (self.folder / "fields" / "000004.h5").write_bytes(b"no HDF5")
        with self.assertRaisesRegex(ddapath.NothingStored, "000004.h5: cannot be read"):
            self.read().fields(4)
        self.assertEqual(self.read().fields(8).step, 8)

    def test_a_bit_that_is_wrong(self):
        """HDF5 itself may loop for ever in such a file, so that none is opened."""
        for name in ("fields/mesh.h5", "fields/000004.h5"):
            file = self.folder / name
            whole = file.read_bytes()
            for place in (*range(0, len(whole), len(whole) // 50), len(whole) - 1):
                file.write_bytes(whole[:place] + bytes([whole[place] ^ 4]) + whole[place + 1:])
                with self.assertRaisesRegex(ddapath.NothingStored, f"{name}: cannot be read: its checksum"):
                    self.read().fields(4)
            file.write_bytes(whole)
        self.assertEqual(self.read().fields(4).step, 4)

    def test_a_mesh_and_no_step(self):
        for file in (self.folder / "fields").glob("0*.h5"):
            file.unlink()
        self.assertEqual(self.read().steps, [])
        with self.assertRaisesRegex(ddapath.NothingStored, "no fields are stored"):
            self.read().fields()


class Others(Folder):
    def check(self, folder, message):
        with self.assertRaisesRegex(ddapath.NotFound, message):
            ddapath.read_run(folder)

    def test_no_folder(self):
        self.check(self.folder / "nowhere", "there is no such folder")

    def test_a_file(self):
        self.check(self.folder / "curve.csv", "is a file; the folder that `dda run` wrote is wanted")

    def test_the_folder_above(self):
        self.check(self.folder.parent, "this is no run folder.*these in it are: copy, run")

    def test_a_sweep(self):
        (self.folder / "sweep.json").write_text(json.dumps({}), encoding="utf-8")
        self.check(self.folder, "this is a sweep; use read_sweep")


if __name__ == "__main__":
    unittest.main()
