"""The locking table: an intact cantilever against its exact field, per treatment, stiffness and shape of block."""

import subprocess
from pathlib import Path

import report


def parse(said):
    """The markdown tables that the program prints: a list of (title, header, rows)."""
    tables, title = [], ""
    for line in said.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|"):
            title = line.strip(" :") or title
        elif set(line) <= set("|- "):
            continue
        elif not tables or tables[-1][0] != title:
            tables.append((title, cells, []))
        else:
            tables[-1][2].append(cells)
    return tables


def errors(tables):
    """One row per error: table, blocks, column and where a cell holds several numbers, which of them."""
    return [{"table": title, "blocks": cells[0], "column": column, "number": i, "error": float(number)}
            for title, header, rows in tables for cells in rows for column, cell in zip(header[1:], cells[1:])
            for i, number in enumerate(cell.split("/"))]


def sentence(rows):
    """Best and worst penalty error per shape against the consistent default on the same, finest blocks."""
    consistent = [row for row in rows if row["table"].startswith("Consistent")]
    finest = consistent[-1]["column"]
    parts = []
    for shape in dict.fromkeys(row["blocks"] for row in consistent):
        default = next(row["error"] for row in consistent
                       if row["blocks"] == shape and row["column"] == finest and row["number"] == 1)
        penalty = [row["error"] for row in rows if row["table"].startswith("Classic") and
                   row["blocks"] in (f"{shape}, gauss", f"{shape}, vertices")]
        parts.append(f"{shape}: {default:.2g} against {min(penalty):.2g} to {max(penalty):.2g}")
    return ("Error of the consistent default (α = 0.6) on the finest blocks against that of penalty joints with two "
            f"points per side over all stiffnesses. {'; '.join(parts)}.")


def locking(runner, quick=False):
    """None where the program of the table has not been built beside `dda`."""
    program = Path(runner.program).with_name("cantilever_table")
    if not program.exists():
        print(f"locking: {program} is missing; build the target cantilever_table")
        return None
    said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    rows = errors(parse(said))
    return report.Section("locking", rows, said.strip(), sentence(rows))
