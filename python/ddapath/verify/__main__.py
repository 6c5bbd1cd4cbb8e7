"""`python -m ddapath.verify [--out=FILE] RUN [RUN...]`: a table per run, printed or in a file; exit code 0 all checks hold, 3 some are
refused, 2 no run, 4 the file cannot be written."""
import signal
import sys

from ..errors import DdapathError, IsSweep
from . import verify

HELD, WRONG_INPUT, REFUSED, NOT_WRITTEN = 0, 2, 3, 4


def row(finding):
    if not finding.is_made:
        return ["-", finding.check, "", "", f"not checked: {finding.place}"]
    return ["ok" if finding.holds else "REFUSED", finding.check, f"{finding.worst:.2e}", f"{finding.bound:.0e}", finding.place]


def table(rows):
    widths = [max(len(cells[i]) for cells in rows) for i in range(4)]
    return "\n".join("  ".join([*(cell.ljust(width) for cell, width in zip(cells, widths)), cells[4]]).rstrip()
                     for cells in rows)


def report(folder, file):
    """Writes the table of one run; its exit code."""
    try:
        findings = verify(folder)
    except IsSweep as error:
        print(error.in_words, file=sys.stderr)
        return WRONG_INPUT
    except (DdapathError, OSError, KeyError, ValueError) as error:
        print(f"{folder}: cannot be verified: {error or type(error).__name__}", file=sys.stderr)
        return WRONG_INPUT
    refused = [finding.check for finding in findings if not finding.holds]
    is_finished = not any("not finished" in finding.place for finding in findings if not finding.is_made)
    held = "all checks hold" if is_finished else "all checks hold so far; the run is not finished"
    print(f"{folder}: {'refused: ' + ', '.join(refused) if refused else held}", file=file)
    print(table([["", "check", "worst", "bound", "where"], *map(row, findings)]), file=file)
    return REFUSED if refused else HELD


def worst(folders, file):
    return max((report(folder, file) for folder in folders), key=lambda code: (code == WRONG_INPUT, code))


def main(arguments):
    if not arguments or any(argument in ("-h", "--help") for argument in arguments):
        print(__doc__)
        return WRONG_INPUT if not arguments else HELD
    try:
        if not arguments[0].startswith("--out="):
            code = worst(arguments, sys.stdout)
            sys.stdout.flush()
            return code
        with open(arguments[0].removeprefix("--out="), "w", encoding="utf-8") as file:
            return worst(arguments[1:], file)
    except OSError as error:
        sys.stdout = None  # what it still holds cannot be written at the end, either
        print(f"verify: {error.filename or 'standard output'}: {error.strerror}", file=sys.stderr)
        return NOT_WRITTEN


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `| head` ends it without a word, as it does other programs
    sys.exit(main(sys.argv[1:]))
