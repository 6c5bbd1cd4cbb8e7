"""Runs decks as whole processes, several at a time, and keeps what a reader wants to know of each."""

import hashlib
import json
import shutil
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from ddapath import read_run, study

GOAL = "goal_reached"
TOO_LARGE = "too large for the softening"


@dataclass
class Case:
    """One run: its name, its deck, the columns that tell it from its neighbours, the share of the peak it ends at."""

    name: str
    deck: dict
    labels: dict = field(default_factory=dict)
    end_share: float | None = 0.1  # None: ends elsewhere


@dataclass
class Outcome:
    """What became of a case; numbers that were not reached are None."""

    case: Case
    exit: int
    seconds: float
    said: str
    folder: Path
    summary: dict = field(default_factory=dict)
    curve: dict = field(default_factory=dict)
    steps: list = field(default_factory=list)  # the accepted steps of the log

    @property
    def peak(self):
        return self.summary.get("peak", {}).get("load")

    @property
    def end_share(self):
        """Last load in units of the peak."""
        return self.curve["load"][-1] / self.peak if self.curve and self.peak else None

    @property
    def unbalanced(self):
        """Largest |sum of the vertical reactions − load| of an accepted step, in units of the peak."""
        if not self.curve or not self.peak or "left.y" not in self.curve:
            return None
        rows = zip(self.curve["load"], self.curve["left.y"], self.curve["right"])
        return max(abs(left + right - load) for load, left, right in rows) / abs(self.peak)

    @property
    def largest_residual(self):
        """Largest residual of an accepted step in units of the tolerance; None where the log has none."""
        ratios = [step["residual"] / step["tolerance"] for step in self.steps if "residual" in step]
        return max(ratios, default=None)

    @property
    def unconverged(self):
        """Accepted steps whose logged residual exceeds the tolerance; None where the log has none."""
        if not any("residual" in step for step in self.steps):
            return None
        return sum("residual" not in step or not step["residual"] <= step["tolerance"] for step in self.steps)

    @property
    def refused(self):
        """The one refusal that is allowed: a block too large for its law."""
        return self.exit == 2 and TOO_LARGE in self.said

    @property
    def refusal(self):
        """What the program said when it refused; where the run's folder was does not matter."""
        said = next((line.strip() for line in self.said.splitlines() if TOO_LARGE in line), "")
        return said.replace(f"{self.folder.parent}/", "")

    @property
    def reached(self):
        """The goal, by default ten per cent of the peak, every accepted step converged."""
        if self.exit != 0 or self.summary.get("status") != GOAL or self.unconverged:
            return False
        return self.case.end_share is None or self.end_share is not None and self.end_share <= self.case.end_share + 1e-6

    @property
    def verdict(self):
        if self.refused:
            return "refused: block too large"
        if self.reached:
            return "reached"
        return f"FAILED: {self.reason}"

    @property
    def reason(self):
        if self.unconverged:
            return f"{self.unconverged} steps not converged"
        lines = self.said.strip().splitlines()
        said = lines[-1].replace(f"{self.folder.parent}/", "") if lines else f"exit code {self.exit}"
        return self.summary.get("reason") or said

    @property
    def iterations(self):
        """Newton iterations for all unknowns and on the cracked points alone."""
        return self.summary.get("whole_iterations", 0) + self.summary.get("reduced_iterations", 0)

    def row(self):
        """All that is kept of it, one value per column."""
        columns = ("blocks", "crackable_points", "steps", "rejected_steps", "rescues", "whole_iterations",
                   "reduced_iterations", "factorisations", "energy_balance_error")
        kept = {name: self.summary.get(name) for name in columns}
        return {"name": self.case.name, **self.case.labels, "verdict": self.verdict, "exit": self.exit,
                "status": self.summary.get("status"), "reason": self.reason, "peak": self.peak,
                "end_share": self.end_share, **kept, "unconverged": self.unconverged,
                "largest_residual": self.largest_residual, "unbalanced": self.unbalanced,
                "seconds": round(self.seconds, 2), **self.stiffness(), "notices": self.notices()}

    def stiffness(self):
        """Condition and smallest pivot of the stiffness at the start and at the end, where the program knows them."""
        found = self.summary.get("stiffness", {})
        return {f"{name}_{when}": found.get(when, {}).get(name)
                for when in ("start", "end") for name in ("condition", "smallest_pivot")}

    def notices(self):
        return "; ".join(str(notice) for notice in self.summary.get("notices", []))


class Runner:
    """Runs cases with one program; where a run fails, its deck and the end of its log are kept.

    A run that is in the work folder already, with the same deck and the same program, is not run again.
    """

    def __init__(self, asked, work):
        self.program, self.work, self.jobs, self.limit, self.failures = asked.program, work, asked.jobs, asked.limit, asked.failures
        self.stamp = hashlib.sha256(Path(asked.program).read_bytes()).hexdigest()
        self.knows_condition = "condition:" in study.told("explain", "record")

    @staticmethod
    def knows(family, name):
        """Whether the program has this member of a family."""
        return any(line.split()[:1] == [name] for line in study.told("explain", family).splitlines())

    def run(self, cases):
        """The outcomes in the order of the cases."""
        with ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(self.run_one, cases))

    def run_one(self, case):
        folder = self.work / case.name
        deck = dict(case.deck)
        if self.knows_condition:
            deck["record"] = {**deck.get("record", {}), "condition": True}
        text = json.dumps(deck, indent=1)
        outcome = self.finished(case, folder, text)
        if not outcome:
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)
            (folder / "deck.yaml").write_text(text, encoding="utf-8")
            outcome = self.execute(case, folder)
        print(f"{case.name:48s} {outcome.seconds:7.2f} s  {outcome.verdict}", flush=True)
        if self.failures and not outcome.reached and not outcome.refused:
            self.keep(outcome)
        return outcome

    def finished(self, case, folder, text):
        """The outcome of an earlier study, if it was of this deck and this program."""
        ended = folder / "ended.json"
        if not ended.exists() or (folder / "deck.yaml").read_text(encoding="utf-8") != text:
            return None
        found = json.loads(ended.read_text(encoding="utf-8"))
        if found.pop("program") != self.stamp or found["exit"] < 0:
            return None
        return self.read(Outcome(case, folder=folder / "run", **found))

    def execute(self, case, folder):
        done = study.measured(folder / "deck.yaml", folder / "run", limit=self.limit)
        ended = {"exit": done.exit_code, "seconds": done.seconds, "said": done.said}
        (folder / "ended.json").write_text(json.dumps(ended | {"program": self.stamp}), encoding="utf-8")
        return self.read(Outcome(case, folder=folder / "run", **ended))

    @staticmethod
    def read(outcome):
        if (outcome.folder / "effective_deck.yaml").exists():
            run = read_run(outcome.folder)
            outcome.steps = [event for event in run.log if event["event"] == "step"]
            if run.summary and outcome.exit in (0, 3):
                outcome.summary, outcome.curve = run.summary, run.curve.to_dict("list")
        return outcome

    def keep(self, outcome):
        """Deck, message and the last lines of the log of a run that failed."""
        to = self.failures / outcome.case.name
        to.mkdir(parents=True, exist_ok=True)
        shutil.copy(outcome.folder.parent / "deck.yaml", to)
        log = outcome.folder / "log.jsonl"
        last = log.read_text(encoding="utf-8").splitlines()[-12:] if log.exists() else []
        said = "\n".join([outcome.verdict, outcome.said.strip(), *last])
        (to / "end.txt").write_text(said + "\n", encoding="utf-8")
