"""The program that the tests of reports are given as their first argument."""

import subprocess
import sys

PROGRAM = sys.argv.pop(1)


def dda(*arguments, code=0):
    """What it says; an error unless it ends with that code."""
    result = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=240, check=False)
    if result.returncode != code:
        raise AssertionError(f"dda {arguments}: {result.returncode} instead of {code}\n{result.stderr}")
    return result.stdout + result.stderr
