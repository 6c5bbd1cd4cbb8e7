"""What a section leaves behind: a CSV file, a figure, a table and a computed sentence in the README."""

from dataclasses import dataclass, field
from typing import Callable

from ddapath import study

plt = study.plots("stability", "Agg")
plt.rcParams.update({"font.size": 8, "axes.grid": True, "grid.alpha": 0.3, "lines.linewidth": 1.0, "legend.fontsize": 7})


@dataclass
class Section:
    """The results of one section. A complaint is a sentence about something that must not be."""

    name: str
    rows: list
    table: str
    sentence: str
    complaints: list = field(default_factory=list)
    draw: Callable | None = None  # returns the figure

    def write(self, folder):
        results = folder / "results"
        study.write_rows(results / f"{self.name}.csv", self.rows)
        text = f"{self.sentence}\n\n{self.table}"
        if self.draw:
            drawn = self.draw()
            drawn.tight_layout()
            study.save(drawn, results / f"{self.name}.svg")
            text += f"\n\n![{self.name}](results/{self.name}.svg)"
        study.write_region(folder / "README.md", text, self.name)


def figure(rows, columns, width=3.2, height=2.5):
    """Axes in rows and columns, always as a two-dimensional array."""
    return plt.subplots(rows, columns, figsize=(width * columns, height * rows), squeeze=False)


def logarithmic(axis, which):
    """Logarithmic scales in x, y or both, unless nothing is drawn: matplotlib fails on empty ones."""
    if any(len(line.get_xdata()) for line in axis.lines):
        for direction in which:
            axis.set(**{f"{direction}scale": "log"})


def markdown(header, rows):
    """A table; every cell is text already or a number."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(text(cell) for cell in line) + " |" for line in lines)


def text(value):
    """A cell: nothing for None, whole numbers as they are, others to three digits."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.0f}" if 1000 <= abs(value) < 1e5 else f"{value:.3g}"
    return str(value)


def percent(value, of):
    """Signed difference in per cent; nothing where one is missing."""
    return None if not value or not of else f"{100 * (value / of - 1):+.2f} %"


# The columns of a run that every section shows: header and the value of an outcome.
EFFORT = (
    ("blocks", lambda o: o.summary.get("blocks")),
    ("steps", lambda o: o.summary.get("steps")),
    ("rejected", lambda o: o.summary.get("rejected_steps")),
    ("rescues", lambda o: o.summary.get("rescues")),
    ("iterations", lambda o: o.iterations),
)
QUALITY = (
    ("condition at start", lambda o: o.stiffness()["condition_start"]),
    ("at end", lambda o: o.stiffness()["condition_end"]),
    ("smallest pivot at start", lambda o: o.stiffness()["smallest_pivot_start"]),
    ("at end", lambda o: o.stiffness()["smallest_pivot_end"]),
)


def table(outcomes, *columns):
    """A table of outcomes; columns are pairs of a header and a function of the outcome, empty ones left out."""
    kept = [(header, [value(o) for o in outcomes]) for header, value in columns]
    kept = [(header, cells) for header, cells in kept if any(cell is not None for cell in cells)]
    return markdown([header for header, _ in kept], list(zip(*(cells for _, cells in kept))))


def label(name):
    """Column of a case's label."""
    return name.replace("_", " "), lambda o: o.case.labels.get(name)


VERDICT = ("verdict", lambda o: o.verdict)
PEAK = ("peak [N]", lambda o: o.peak)


def count(outcomes):
    """A phrase: how many reached the end, were refused, failed."""
    reached = sum(o.reached for o in outcomes)
    refused = sum(o.refused for o in outcomes)
    failed = len(outcomes) - reached - refused
    return f"{reached} of {len(outcomes)} runs reached 10 % of their peak, {refused} were refused, {failed} failed"


def failures(outcomes):
    """A complaint for every run that neither reached its end nor was refused."""
    return [f"{o.case.name}: {o.reason}" for o in outcomes if not o.reached and not o.refused]


def span(values):
    """Smallest and largest of what is there."""
    values = [value for value in values if value is not None]
    return f"{text(min(values))} to {text(max(values))}" if values else "unknown"
