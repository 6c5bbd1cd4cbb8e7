"""Whole processes of a program, timed from their start to their end."""

import json
import statistics
import subprocess
import time
from pathlib import Path


class Program:
    def __init__(self, path, folder):
        self.path, self.folder = str(Path(path).resolve()), Path(folder)

    def run(self, deck, *settings, threads=1):
        """Seconds of the whole process, and its summary; `deck` is a file or what goes into one."""
        if isinstance(deck, dict):
            file = self.folder / "deck.json"
            file.write_text(json.dumps(deck), encoding="utf-8")
            deck = file
        command = [self.path, "run", deck, "--folder", self.folder / "run", "--overwrite", "--quiet", "--threads",
                   str(threads)]
        for setting in settings:
            command += ["--set", setting]
        start = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        seconds = time.perf_counter() - start
        return seconds, json.loads((self.folder / "run" / "summary.json").read_text(encoding="utf-8"))

    def seconds(self, deck, runs, *settings):
        found = [self.run(deck, *settings) for _ in range(runs + 1)][1:]
        return statistics.median(seconds for seconds, _ in found), found[-1][1]
