"""Loads that a loop changes while its path is recorded: the run is that of a deck which has them as a stage."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import ddapath
from ddapath.verify import verify

DECK = Path(__file__).resolve().parents[1] / "program" / "beam.yaml"
CRACKED = Path(__file__).resolve().parents[1] / "program" / "cracked_beam.yaml"
SAME = ("load_factor", "load", "dissipated_energy", "stored_energy", "external_work")
LIMIT = {"path.stop.after_steps": 12, "record.fields_every": 1}

KILLED = """
import os, signal, sys
import ddapath
deck, folder, at, until = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
loads = [load | {"force": [40, -0.5]} for load in ddapath.read_deck(deck)["stages"][-1]["loads"]]
for point in (path := ddapath.follow(deck, {"path.stop.after_steps": 12, "record.fields_every": 1}, folder=folder)):
    if point.step == at:
        path.load(*loads, name="more 3")
    if point.step == until:
        os.kill(os.getpid(), signal.SIGKILL)
"""


def pushed(deck=DECK):
    return [load | {"force": [40, -0.5]} for load in ddapath.read_deck(deck)["stages"][-1]["loads"]]


class ChangedLoads(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def changed(self, name, at, deck=DECK, settings=LIMIT):
        """A run whose loads have changed after the steps `at`."""
        path = ddapath.follow(deck, settings, folder=self.folder / name)
        for point in path:
            if point.step in at:
                path.load(*pushed(deck), name=f"more {point.step}")
        return path.run

    def assert_verified(self, run):
        findings = verify(run.folder)
        self.assertEqual([f"{found.check}: {found.worst} at {found.place}" for found in findings if not found.holds], [])
        self.assertIn("loads of earlier stages are held", [found.check for found in findings])

    def assert_same_rows(self, run, other, rows=slice(None)):
        for name in SAME:
            mine, theirs = run.curve[name].to_numpy()[rows], other.curve[name].to_numpy()[rows]
            self.assertEqual(len(mine), len(theirs))
            for a, b in zip(mine, theirs):
                self.assertAlmostEqual(a, b, delta=1e-9 * max(abs(theirs)), msg=name)

    def test_the_run_is_that_of_a_deck_with_the_stage(self):
        run = self.changed("told", {3})
        self.assertEqual(run.curve["stage"].tolist(), [1] * 4 + [2] * 9)
        self.assertEqual([(stage["number"], stage["end"]) for stage in run.summary["stages"]], [(1, 3), (2, 12)])
        self.assertEqual(run.summary["stages"][0]["reason"], "as told")
        self.assertEqual({event["stage"] for event in run.summary["events"]} - {1, 2}, set())
        self.assertEqual(run.deck["stages"][-1]["name"], "more 3")
        self.assert_verified(run)
        again = ddapath.run(run.folder / "effective_deck.yaml", folder=self.folder / "again")
        self.assertEqual(again.curve["stage"].tolist(), run.curve["stage"].tolist())
        self.assertEqual(list(again.curve.columns), list(run.curve.columns))
        self.assert_same_rows(run, again)
        self.assertIn("more 3", (run.folder / "model.svg").read_text(encoding="utf-8"))
        units = [json.loads((of.folder / "curve.units.json").read_text(encoding="utf-8")) for of in (run, again)]
        self.assertEqual(*map(list, units))

    def test_loads_that_change_behind_the_peak(self):
        """There the load factor has been passed before: the stage ends by a gauge that has not."""
        settings = LIMIT | {"path.stop.after_steps": 50}
        whole = list(ddapath.follow(DECK, settings))
        peak = max(whole, key=lambda point: point.load).step
        run = self.changed("told", {peak + 3}, settings=settings)
        until, = run.deck["stages"][-2]["until"]
        self.assertIn(until, run.deck["gauges"])
        self.assert_verified(run)
        again = ddapath.run(run.folder / "effective_deck.yaml", folder=self.folder / "again")
        held, theirs = (of.summary["stages"][0] for of in (run, again))
        self.assertEqual(held["end"], theirs["end"])
        self.assertAlmostEqual(held["load_factor"], theirs["load_factor"], delta=1e-9 * held["load_factor"])

    def test_again_and_again(self):
        run = self.changed("told", {2, 3, 6})
        self.assertEqual(run.curve["stage"].tolist(), [1] * 3 + [2] + [3] * 3 + [4] * 6)
        self.assert_verified(run)
        last = run.fields(run.steps[-1]).numbers
        held = [stage["load_factor"] for stage in run.summary["stages"][:-1]]
        self.assertEqual([last[f"load_factor_{number}"] for number in (1, 2, 3)], held)

    def test_cracks_through_blocks(self):
        run = self.changed("told", {4}, CRACKED, {"path.stop.after_steps": 8, "record.fields_every": 1})
        self.assertEqual(run.curve["stage"].tolist()[-1], 2)
        self.assertGreater(len(run.fields(4).cracks), 0)
        self.assert_verified(run)

    def test_a_run_that_is_killed_goes_on_with_them(self):
        whole = self.changed("whole", {3})
        for until in (3, 7):  # as soon as the loads have changed, and later
            with self.subTest(until=until):
                folder = self.folder / f"killed-{until}"
                out = subprocess.run([sys.executable, "-B", "-c", KILLED, DECK, folder, "3", str(until)], env=os.environ, check=False)
                self.assertEqual(out.returncode, -signal.SIGKILL)
                self.assertEqual(len((folder / "curve.csv").read_text().splitlines()), until + 2)
                again = ddapath.resume(folder)
                self.assertEqual((folder / "curve.csv").read_bytes(), (whole.folder / "curve.csv").read_bytes())
                self.assert_verified(again)
                self.assertEqual(again.summary["stages"], whole.summary["stages"])

    def test_a_kill_between_the_restart_file_and_the_tables_is_mended(self):
        """The restart file comes first: where the tables are those of before, a restart brings them up to it."""
        before = {}
        path = ddapath.follow(DECK, LIMIT, folder=self.folder / "run")
        for point in path:
            if point.step == 3:
                before = {file: (self.folder / "run" / file).read_bytes() for file in ("curve.csv", "curve.units.json", "fields/mesh.h5")}
                path.load(*pushed(), name="more 3")
                break
        path.close()
        for file, content in before.items():
            (self.folder / "run" / file).write_bytes(content)
        again = ddapath.resume(self.folder / "run")
        self.assertEqual((again.folder / "curve.csv").read_bytes(), (self.changed("whole", {3}).folder / "curve.csv").read_bytes())
        self.assert_verified(again)

    def test_a_run_may_go_on_with_a_stage_more(self):
        run = ddapath.run(DECK, LIMIT | {"path.stop.after_steps": 3}, folder=self.folder / "run")
        self.assertNotIn("stage", run.curve)
        first = run.deck["stages"][-1] | {"until": {"load_factor": 1.1 * run.curve["load_factor"].iloc[-1]}}
        again = ddapath.resume(run.folder, {"stages": [first, {"name": "more", "loads": pushed()}], "path.stop.after_steps": 9})
        self.assertEqual(again.curve["stage"].iloc[0], 1)
        self.assertEqual(again.curve["stage"].iloc[-1], 2)
        self.assert_verified(again)

    def test_what_cannot_be_recorded_is_refused(self):
        path = ddapath.follow(DECK, LIMIT, folder=self.folder / "run")
        with self.assertRaisesRegex(ddapath.InputError, "no step has been taken yet"):
            path.load(*pushed())
        next(path)
        with self.assertRaisesRegex(ddapath.InputError, "did you mean 'point_load'"):
            path.load({"type": "pointload", "at": [0, 0], "force": [1, 0]})
        with self.assertRaisesRegex(ddapath.InputError, "applies no load"):
            path.load(pushed()[0] | {"force": [0, 0]})
        for _ in path:
            pass
        self.assertNotIn("stage", path.run.curve)
        self.assertEqual(len(path.run.deck["stages"]), len(ddapath.read_deck(DECK)["stages"]))
        self.assertEqual([finding.check for finding in verify(path.run.folder) if not finding.holds], [])


if __name__ == "__main__":
    unittest.main()
