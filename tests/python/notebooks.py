"""Notebooks without Jupyter: their code cells in order, in one process.

    notebooks.py NOTEBOOK      in the current folder; every figure is left there as figure-1.png, figure-2.png, ...
"""

import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("agg")


def cells(file):
    """Source and JSON of the code cells."""
    notebook = json.loads(Path(file).read_text(encoding="utf-8"))
    return [("".join(cell["source"]), cell) for cell in notebook["cells"] if cell["cell_type"] == "code"]


def executed(file):
    """The variables that the cells leave."""
    variables = {"__name__": "__main__"}
    for number, (source, _) in enumerate(cells(file)):
        exec(compile(source, f"{Path(file).name}, code cell {number}", "exec"), variables)
    return variables


def main():
    from matplotlib import pyplot
    executed(sys.argv[1])
    for number in pyplot.get_fignums():
        pyplot.figure(number).savefig(f"figure-{number}.png")


if __name__ == "__main__":
    main()
