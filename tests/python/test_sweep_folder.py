"""Sweeps as tables: cases that reached their goal, failed, or have not run yet."""

import json
import tempfile
import unittest
from pathlib import Path

import ddapath

SWEEP = {"name": "sizes", "title": "Sizes", "units": {"length": "mm", "force": "N"},
         "axes": [{"keys": ["scene.depth"], "values": [50, 100, 200]}],
         "cases": [{"number": 1, "folder": "cases/001", "settings": {"scene.depth": 50, "law": [1, 2]},
                    "status": "goal_reached", "reason": "load below 10 % of its peak", "exit_code": 0},
                   {"number": 2, "folder": "cases/002", "settings": {"scene.depth": 100, "law": [3, 4]},
                    "status": "failed", "reason": "the blocks are too large", "exit_code": 2},
                   {"number": 3, "folder": "cases/003", "settings": {"scene.depth": 200, "law": [5, 6]},
                    "status": "pending"}]}
CSV = """case,folder,scene.depth,status,exit_code,peak.load,steps
1,cases/001,50,goal_reached,0,0.30000000000000004,12
2,cases/002,100,failed,2,,
"""


class Sweep(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.write("sweep.json", json.dumps(SWEEP))
        self.write("sweep.csv", CSV)
        self.write("sweep.units.json", json.dumps({"peak.load": "N"}))

    def write(self, name, text):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(text, encoding="utf-8")

    def test_every_case_has_a_row(self):
        table = ddapath.read_sweep(self.folder)
        self.assertEqual(table.index.tolist(), [1, 2, 3])
        self.assertEqual(table["status"].tolist(), ["goal_reached", "failed", "pending"])
        self.assertEqual(table["scene.depth"].tolist(), [50, 100, 200])

    def test_results_are_exact_and_missing_ones_are_missing(self):
        table = ddapath.read_sweep(self.folder)
        self.assertEqual(table["peak.load"][1], 0.1 + 0.2)
        self.assertTrue(table["peak.load"].isna().tolist() == [False, True, True])

    def test_settings_keep_their_types(self):
        self.assertEqual(ddapath.read_sweep(self.folder)["law"][2], [3, 4])

    def test_what_stands_on_the_table(self):
        found = ddapath.read_sweep(self.folder).attrs
        self.assertEqual((found["name"], found["title"], found["axes"]), ("sizes", "Sizes", SWEEP["axes"]))
        self.assertEqual(found["units"], {"peak.load": "N"})

    def test_runs_are_read_when_asked(self):
        self.write("cases/001/curve.csv", "step,load\n0,0\n1,2.5\n")
        runs = ddapath.read_sweep(self.folder)["run"]
        self.assertEqual(runs[1].curve["load"].tolist(), [0, 2.5])
        with self.assertRaisesRegex(ddapath.NothingStored, r"this run has no curve.csv \(yet\)"):
            print(runs[2].curve)

    def test_a_sweep_that_has_just_begun(self):
        (self.folder / "sweep.csv").unlink()
        (self.folder / "sweep.units.json").unlink()
        table = ddapath.read_sweep(self.folder)
        self.assertEqual(len(table), 3)
        self.assertEqual(table["reason"][2], "the blocks are too large")

    def test_what_is_no_sweep(self):
        with self.assertRaisesRegex(ddapath.NotFound, "there is no such folder"):
            ddapath.read_sweep(self.folder / "nowhere")
        (self.folder / "sweep.json").unlink()
        with self.assertRaisesRegex(ddapath.NotFound, "this is no sweep folder, it has no sweep.json$"):
            ddapath.read_sweep(self.folder)
        self.write("effective_deck.yaml", "")
        with self.assertRaisesRegex(ddapath.NotFound, "this is one run: use read_run"):
            ddapath.read_sweep(self.folder)


if __name__ == "__main__":
    unittest.main()
