"""Checks a run folder independently of the program that computed it: `dda verify RUN`, or

    from ddapath.verify import verify
    for finding in verify("runs/notched-beam"): print(finding.check, finding.worst, finding.bound, finding.holds)

Read are fields/, curve.csv, summary.json, effective_deck.yaml and log.jsonl. Stresses, openings, forces, energies and
envelopes are derived again from strains, displacements, stored tractions and the deck's materials and laws; of a motion,
energies and overlaps.
"""
import re
import threading

from ..run_folder import MESH, opened, read_run
from . import curve_checks, fields_checks, motion_checks, stage_checks
from .finding import Finding
from .model import Model
from .state import Step

__all__ = ["Finding", "verify"]

BETWEEN_EQUILIBRIA = "release"  # rows in which a point is losing its strength

# numpy multiplies matrices without the interpreter's lock; a BLAS built without threads (Debian's libopenblas0-serial) gives
# two callers the same work space, and both get wrong products.
ONE_AT_A_TIME = threading.Lock()


def read_steps(run, model):
    curve = run.curve
    out = []
    for fields in run.all_fields():
        control = str(curve["control"][fields.step]) if fields.step < len(curve) else ""
        out.append(Step(model, fields, control.startswith(BETWEEN_EQUILIBRIA)))
    return out


def verify(folder):
    """The Findings about a run folder. Throws NotFound or NothingStored for what is none, or holds too little.

    May be called from several threads, which then wait for each other; nothing else may multiply matrices meanwhile.
    """
    with ONE_AT_A_TIME:
        return findings_of(read_run(folder))


def findings_of(run):
    has_path = bool(run.deck["stages"])
    moved = motion_checks.all_checks(run) if (run.folder / "motion").is_dir() else []
    return (checks_of_path(run) if has_path else []) + moved


def checks_of_path(run):
    out = curve_checks.all_checks(run)
    with opened(run.folder / MESH) as file:
        model = Model(file, run.deck)
    steps = read_steps(run, model)
    if not steps:
        return out
    return out + fields_checks.all_checks(steps, run.curve, dead_loads_are_carried(run)) + stage_checks.all_checks(steps, run)


def dead_loads_are_carried(run):
    return not re.match("stage '.*' cannot be carried", run.summary.get("reason", ""))
