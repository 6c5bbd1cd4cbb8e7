"""One run on several ranks: the same path as on one, the same bits each time, one voice, an end when a rank dies.

    test_ranks.py        with DDA naming the program and DECKS the folder of the studies
"""

import csv
import json
import math
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

DDA = os.environ["DDA"]
PROGRAM = Path(__file__).resolve().parent
STUDIES = PROGRAM.parents[1] / "studies"
BEAM = PROGRAM / "beam.yaml"
SLIDING = "interfaces.any.law={type: linear_softening, tensile_strength: 3, fracture_energy: 0.05, friction_angle: 40}"
RELEASING = "interfaces.any.law={type: mohr_coulomb, tensile_strength: 3, cohesion: 3, friction_angle: 30}"
LAGRANGE = "interfaces.any.treatment=lagrange"
SMALL = "path.stop.after_steps=12"
PATHS = {
    "notched beam": (STUDIES / "notched-beam" / "deck.yaml", ("record.at={cmod: [0.005, 0.01, 0.02]}",)),
    "snap-back": (STUDIES / "snap-back-beam" / "deck.yaml", ("record.at={cmod: [0.005, 0.01, 0.02]}",)),
    "friction": (BEAM, (SLIDING,)),
    "release": (BEAM, (RELEASING, "path.stop.after_steps=170")),
    "all unknowns": (BEAM, ("path.update=refactorise", SMALL)),
    "multipliers": (BEAM, (LAGRANGE, SMALL)),
    "dead load": (BEAM, ("stages=[{loads: [{type: body_force, force: [0, -2.4e-5]}]}, "
                         "{loads: [{type: point_load, at: [150, 100], force: [0, -1]}]}]",)),
    "held loads": (BEAM, ("stages=[{loads: [{type: point_load, at: [150, 100], force: [0, -1]}], until: {cmod: 0.01}}, "
                          "{loads: [{type: point_load, at: [150, 100], force: [0.1, -1]}]}]",
                          "path.stop={load_below: 0, gauges: {cmod: 0.05}}")),
    "eigenvalues": (BEAM, ("record.eigenvalues={count: 3}", SMALL)),
}
# The first point of a crack is reached in a step whose size hangs on last digits: such paths have other points in common.
CRACKED = (PROGRAM / "cracked_beam.yaml", ("record.at={cmod: [0.005, 0.01, 0.015]}", "path.stop.gauges={cmod: 0.016}"))
# A run that lasts long enough to be broken off, of PROGRAM / "fine_beam.yaml".
LONG = ("path.stop.after_steps=40", "scene.subdivision.blocks=2500", "record.fields_every=1")
# Where both paths land on the same value they agree to the tolerance of Newton's method. Elsewhere points stand
# where the size of a step puts them, which follows from how far off a tangent was: a small difference of large numbers.
CLOSE = "path.newton.tolerance=1e-12"
AGREE, ELSEWHERE = 1e-8, 1e-5


def mpirun(ranks):
    """A line that starts ranks on a machine with fewer processors, also as root in a container."""
    return ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)]


def environment():
    return {**os.environ, "OMP_NUM_THREADS": "1"}


def rows(folder):
    with open(folder / "curve.csv", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def numbers(table, name):
    try:
        return [float(row[name]) for row in table]
    except ValueError:
        return None  # words


def sizes(folder):
    """The largest number of each unit: a reaction that is zero is no more than rounding beside the others."""
    units = json.loads((folder / "curve.units.json").read_text())
    out = {}
    for name, values in ((name, numbers(rows(folder), name)) for name in units):
        for value in values or ():
            if math.isfinite(value):
                out[units[name]] = max(out.get(units[name], 0), abs(value))
    return {name: out.get(unit, 0) or 1 for name, unit in units.items()}


def landings(folder):
    """Steps that stand on a wanted value, or at the end of the path."""
    events = map(json.loads, (folder / "log.jsonl").read_text().splitlines())
    return {event["step"] for event in events if event["event"] == "step" and "landed" in event}


def farthest(one, other, steps=None):
    """The largest difference of the curves of two runs, at some steps or at all, beside the largest number of that unit, and
    its column. A count of negative eigenvalues may differ in a row, or in one of forty, where one of them passes zero."""
    worst, size = (0.0, ""), sizes(one)
    left, right = ([row for row in rows(run) if steps is None or int(row["step"]) in steps] for run in (one, other))
    for name in left[0] if left else ():
        ours, theirs = numbers(left, name), numbers(right, name)
        if ours is None or "iterations" in name or (steps and name in ("external_work", "current_stiffness")):
            continue  # a sum over steps, and what follows from where the next one begins
        if name.startswith("negative"):
            off = sum(x != y for x, y in zip(ours, theirs) if math.isfinite(x))
            worst = max(worst, (float(off > max(1, len(ours) / 40)), name))
            continue
        for x, y in zip(ours, theirs):
            if math.isfinite(x) or math.isfinite(y):
                worst = max(worst, (abs(x - y) / size.get(name, 1) if math.isfinite(x - y) else math.inf, name))
    return worst


def is_running(process):
    """Not gone, nor waiting to be forgotten."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


class Ranks(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def dda(self, *words, ranks=1, code=0):
        line = [*(mpirun(ranks) if ranks > 1 else ()), DDA, *map(str, words)]
        done = subprocess.run(line, capture_output=True, text=True, cwd=self.folder, env=environment(), timeout=600,
                              check=False)
        self.assertEqual(done.returncode, code, f"{line}\n{done.stdout}{done.stderr}")
        return done

    def run_deck(self, deck, name, ranks=1, settings=(), code=0):
        sets = [word for setting in (*settings, CLOSE) for word in ("--set", setting)]
        self.dda("run", deck, "--folder", name, "--quiet", "--overwrite", *sets, ranks=ranks, code=code)
        return self.folder / name

    def expect_same_path(self, one, other):
        self.assertEqual([(row["step"], row["control"]) for row in rows(one)],
                         [(row["step"], row["control"]) for row in rows(other)])
        self.assertEqual(landings(one), landings(other))
        for bound, steps in ((AGREE, landings(one)), (ELSEWHERE, None)):
            difference, column = farthest(one, other, steps)
            self.assertLess(difference, bound, column)

    def test_paths_are_those_of_one_rank(self):
        for name, (deck, settings) in PATHS.items():
            with self.subTest(name):
                self.expect_same_path(self.run_deck(deck, "one", 1, settings), self.run_deck(deck, "two", 2, settings))

    def test_cracks_through_blocks_are_those_of_one_rank(self):
        deck, settings = CRACKED
        one, two = (self.run_deck(deck, str(ranks), ranks, settings) for ranks in (1, 2))
        lasting = [[{name: row[name] for name in ("load", "deflection", "cmod", "dissipated_energy", "stored_energy")}
                    for row in rows(run) if int(row["step"]) in landings(run)] for run in (one, two)]
        self.assertEqual([len(landed) for landed in lasting], [4, 4])
        for ours, theirs in zip(*lasting):
            for name, value in ours.items():
                self.assertAlmostEqual(float(theirs[name]) / float(value), 1, delta=AGREE, msg=name)

    def test_more_ranks_than_strips(self):
        bar = STUDIES / "softening-bar" / "deck.yaml"
        one = self.run_deck(bar, "one")
        for ranks in (3, 4):
            self.expect_same_path(one, self.run_deck(bar, "many", ranks))

    def test_a_run_repeats_bit_for_bit(self):
        for ranks in (2, 3):
            for deck, settings in (PATHS["snap-back"], PATHS["friction"]):
                self.run_deck(deck, "first", ranks, settings)
                self.run_deck(deck, "second", ranks, settings)
                first, second = ((self.folder / name / "curve.csv").read_bytes() for name in ("first", "second"))
                self.assertEqual(first, second)

    def test_resumes_on_another_number_of_ranks(self):
        whole = self.run_deck(BEAM, "whole")
        for before, after in ((1, 2), (2, 1), (2, 3)):
            self.run_deck(BEAM, "half", before, (SMALL,))
            self.dda("resume", "half", "--quiet", "--set", "path.stop.after_steps=0", ranks=after)
            self.expect_same_path(whole, self.folder / "half")

    def test_resumes_with_the_same_bits_on_as_many(self):
        self.run_deck(BEAM, "whole", 2)
        self.run_deck(BEAM, "half", 2, (SMALL,))
        self.dda("resume", "half", "--quiet", "--set", "path.stop.after_steps=0", ranks=2)
        self.assertEqual(*((self.folder / name / "curve.csv").read_bytes() for name in ("whole", "half")))

    def test_one_rank_speaks_and_writes(self):
        self.run_deck(BEAM, "one", 1, (SMALL,))
        said = self.dda("run", BEAM, "--folder", "two", "--set", SMALL, "--quiet", ranks=2)
        self.assertEqual(len(said.stdout.splitlines()), 1)
        self.assertEqual(said.stderr, "")
        files = [sorted(str(p.relative_to(self.folder / n)) for p in (self.folder / n).rglob("*")) for n in ("one", "two")]
        self.assertEqual(*files)
        summary = json.loads((self.folder / "two" / "summary.json").read_text())
        self.assertEqual(summary["ranks"]["count"], 2)
        self.assertEqual(len(summary["ranks"]["peak_memory_mib"]), 2)
        self.assertTrue(all(mib > 1 for mib in summary["ranks"]["peak_memory_mib"]))
        self.assertGreater(summary["ranks"]["exchanges"], summary["factorisations"])
        self.assertGreater(summary["ranks"]["received_mib"], 0)
        self.assertNotIn("ranks", json.loads((self.folder / "one" / "summary.json").read_text()))

    def test_a_plain_run_loads_nothing_of_it(self):
        line = [DDA, "run", str(BEAM), "--folder", "one", "--quiet", "--set", SMALL]
        loaded = subprocess.run(line, capture_output=True, text=True, cwd=self.folder, check=True,
                                env={**environment(), "LD_DEBUG": "files"}).stderr
        self.assertIn("dda_loca.so", loaded)
        self.assertNotIn("dda_ranks.so", loaded)

    def expect_refused(self, wanted, *words, ranks=2):
        said = self.dda(*words, ranks=ranks, code=2)
        self.assertIn(wanted, said.stderr)
        self.assertEqual(said.stderr.count(wanted), 1, said.stderr)

    def test_what_ranks_cannot_do_is_refused_by_name(self):
        self.expect_refused("several ranks share 'cholmod', not 'mumps'", "run", BEAM, "--set", "path.linear=mumps")
        self.expect_refused("`dda check` is for one", "check", BEAM)
        (self.folder / "sweep.yaml").write_text(f"sweep: {{deck: {BEAM}, thickness: [50, 100]}}\n")
        self.expect_refused("`dda sweep`", "run", "sweep.yaml")
        self.expect_refused("unknown parameter 'thicknes'", "run", BEAM, "--set", "thicknes=3")
        self.assertFalse((self.folder / "runs").exists())

    def test_check_tells_the_memory_of_each_rank(self):
        said = self.dda("check", STUDIES / "snap-back-beam" / "deck.yaml", "--ranks", 3).stdout
        found = dict(re.findall(r"rank (\d) +at least (\d+) MiB", said))
        self.assertEqual(sorted(found), ["0", "1", "2"])

    def test_runs_of_a_sweep_have_ranks(self):
        (self.folder / "sweep.yaml").write_text(f"sweep: {{deck: {BEAM}, thickness: [50, 100]}}\n")
        allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_rmaps_base_oversubscribe": "1"}
        line = [DDA, "sweep", "sweep.yaml", "--ranks", "2", "--jobs", "1", "--quiet", "--folder", "two", "--set", SMALL]
        done = subprocess.run(line, cwd=self.folder, env={**environment(), **allowed}, capture_output=True, text=True,
                              timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for case in ("001", "002"):
            summary = json.loads((self.folder / "two" / "cases" / case / "summary.json").read_text())
            self.assertEqual(summary["ranks"]["count"], 2)
        self.expect_refused("--ranks", "sweep", "sweep.yaml", "--ranks", 2, "--launcher", "slurm", ranks=1)

    def begin(self, name, ranks=2):
        """A run that takes long enough, when it has written a restart file."""
        line = [*mpirun(ranks), DDA, "run", str(PROGRAM / "fine_beam.yaml"), "--folder", name, "--quiet",
                *(word for setting in LONG for word in ("--set", setting))]
        run = subprocess.Popen(line, cwd=self.folder, env=environment(), text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE)
        self.addCleanup(run.kill)
        wanted = self.folder / name / "restart.h5"
        end = time.monotonic() + 60
        while not wanted.exists() and run.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        self.assertTrue(wanted.exists() and run.poll() is None, "the run has not lasted")
        return run

    def processes_of(self, run):
        """The ranks, by their numbers."""
        children = Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text().split()
        out = {}
        for child in children:
            text = Path(f"/proc/{child}/environ").read_bytes().decode()
            found = re.search(r"OMPI_COMM_WORLD_RANK=(\d+)", text)
            if found:
                out[int(found.group(1))] = int(child)
        return out

    def expect_whole_after_resume(self, name):
        """Some steps farther than to where the run was broken off."""
        end = f"path.stop.after_steps={len(rows(self.folder / name)) + 4}"
        self.dda("resume", name, "--quiet", "--set", end, ranks=2)
        self.run_deck(PROGRAM / "fine_beam.yaml", "whole", 1, (*LONG, end))
        self.expect_same_path(self.folder / "whole", self.folder / name)

    def test_a_signal_to_mpirun_writes_the_restart(self):
        for number in (signal.SIGUSR1, signal.SIGTERM):
            with self.subTest(number):
                run = self.begin(f"by_{number.name}")
                run.send_signal(number)
                said = run.communicate(timeout=30)
                summary = self.folder / f"by_{number.name}" / "summary.json"
                self.assertTrue(summary.exists(), said)
                self.assertEqual(json.loads(summary.read_text())["status"], "interrupted")
                self.assertNotEqual(run.returncode, 0)
                self.expect_whole_after_resume(f"by_{number.name}")

    def test_a_rank_short_of_address_space_is_named(self):
        run = [DDA, "run", BEAM, "--folder", "short", "--quiet"]
        line = [*mpirun(1), *run, ":", "-n", "1", "bash", "-c", 'ulimit -v 300000 && exec "$@"', "rank", *run]
        done = subprocess.run(list(map(str, line)), capture_output=True, text=True, cwd=self.folder, env=environment(),
                              timeout=120, check=False)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertRegex(done.stderr, r"rank 1 on .*of address space are left by `ulimit -v`")

    def test_a_rank_that_dies_ends_the_run(self):
        for rank in (1, 0):
            with self.subTest(rank=rank):
                run = self.begin(f"without_{rank}")
                ranks = self.processes_of(run)
                os.kill(ranks[rank], signal.SIGKILL)
                begun = time.monotonic()
                said = run.communicate(timeout=20)
                while any(map(is_running, ranks.values())) and time.monotonic() < begun + 10:
                    time.sleep(0.01)
                self.assertLess(time.monotonic() - begun, 10)
                self.assertNotEqual(run.returncode, 0)
                self.assertIn("signal 9", said[1])
                self.expect_whole_after_resume(f"without_{rank}")


if __name__ == "__main__":
    unittest.main()
