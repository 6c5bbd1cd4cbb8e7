"""The outcome of one check."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Finding:
    """`worst` against `bound`, and where it stands. A check that could not be made has neither; `place` says why."""
    check: str
    worst: float | None
    bound: float | None
    place: str

    @property
    def is_made(self):
        return self.worst is not None

    @property
    def holds(self):
        """Not for a number that is none."""
        return not self.is_made or self.worst <= self.bound


def not_made(check, why):
    return Finding(check, None, None, why)


def worst_of(check, findings, bound):
    """The largest of (value, place) pairs as a Finding; a nan counts as larger than everything."""
    largest = max(findings, key=lambda pair: (pair[0] != pair[0], pair[0]), default=(0.0, "everywhere"))
    value = float(largest[0])
    return Finding(check, 0.0, bound, "everywhere") if value <= 0 else Finding(check, value, bound, largest[1])
