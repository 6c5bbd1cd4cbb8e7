"""`python -m ddapath.verify RUN [RUN...]`: a table per run; exit code 0 all checks hold, 3 some are refused, 2 no run."""
import signal
import sys

from ..errors import DdapathError
from . import verify

HELD, WRONG_INPUT, REFUSED = 0, 2, 3


def row(finding):
    if not finding.is_made:
        return ["-", finding.check, "", "", f"not checked: {finding.place}"]
    return ["ok" if finding.holds else "REFUSED", finding.check, f"{finding.worst:.2e}", f"{finding.bound:.0e}", finding.place]


def table(rows):
    widths = [max(len(cells[i]) for cells in rows) for i in range(4)]
    return "\n".join("  ".join([*(cell.ljust(width) for cell, width in zip(cells, widths)), cells[4]]).rstrip()
                     for cells in rows)


def report(folder):
    """Prints the table of one run; its exit code."""
    try:
        findings = verify(folder)
    except (DdapathError, OSError, KeyError, ValueError) as error:
        print(f"{folder}: cannot be verified: {error or type(error).__name__}", file=sys.stderr)
        return WRONG_INPUT
    refused = [finding.check for finding in findings if not finding.holds]
    print(f"{folder}: {'refused: ' + ', '.join(refused) if refused else 'all checks hold'}")
    print(table([["", "check", "worst", "bound", "where"], *map(row, findings)]))
    return REFUSED if refused else HELD


def main(folders):
    if not folders or any(folder in ("-h", "--help") for folder in folders):
        print(__doc__)
        return WRONG_INPUT if not folders else HELD
    return max(map(report, folders), key=lambda code: (code == WRONG_INPUT, code))


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `| head` ends it without a word, as it does other programs
    sys.exit(main(sys.argv[1:]))
