"""Whole processes of a program, timed from their start to their end."""

import statistics
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))

from ddapath import study  # noqa: E402


def value_of(text):
    return int(text) if text.isdigit() else study.number(text)


class Program:
    def __init__(self, path, folder):
        self.path, self.folder = str(Path(path).resolve()), Path(folder)

    def run(self, deck, *settings, threads=1):
        """Seconds of the whole process, and its summary; `deck` is a file or what goes into one."""
        values = {name: value_of(text) for name, text in (setting.split("=", 1) for setting in settings)}
        done = study.measured(deck, self.folder / "run", values, threads=threads, program=self.path)
        if done.exit_code != 0:
            raise SystemExit(done.said)
        return done.seconds, done.run.summary

    def seconds(self, deck, runs, *settings):
        found = [self.run(deck, *settings) for _ in range(runs + 1)][1:]
        return statistics.median(seconds for seconds, _ in found), found[-1][1]
