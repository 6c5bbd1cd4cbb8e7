"""A column of Voronoi blocks that collapses, and a beam whose halves tear apart and fall, with either integrator."""

from pathlib import Path

import scenes
from ddapath import deck as decks
from ddapath import study
from ddapath.verify import motion_checks
from scenes import FREE_FLIGHT, classic

BEAM = Path(__file__).resolve().parents[1] / "falling-beam" / "deck.yaml"
TOUGHNESS = 500.0  # of the beam: Gf times its ligament [N mm]


def deepest_overlap(motion):
    """Of any corner in another block over all stored steps, in sizes of the smallest block."""
    return motion_checks.overlaps(motion).worst


def ending_of(motion):
    """In a few words."""
    reason = motion["reason"].removeprefix("motion: ")
    return "its time" if reason.startswith("the time") else reason if motion["is_at_rest"] else f"an end at {motion['time']:.3g} s"


def row_of(name, integrator, done, asked_time):
    """How far a run has come; a run that stops early is a result."""
    motion = done.run.summary["motion"]
    curve = done.run.motion.curve
    spent = done.run.summary.get("dissipated_energy", 0) + motion["fracture"]
    released = curve["kinetic_energy"].max()
    return {"scene": name, "integrator": scenes.name_of(integrator), "ended": ending_of(motion),
            "reached": motion["time"] / asked_time if not motion["is_at_rest"] else 1.0, "at_rest": motion["is_at_rest"],
            "released": motion["external_work"], "friction": motion["friction"], "fracture": spent,
            "largest_kinetic": released, "overlap": deepest_overlap(done.run.motion)} | scenes.books(done.run)


def column_runs(folder, is_quick):
    time, blocks = (0.05, 20) if is_quick else (2.0, 50)
    integrators = [FREE_FLIGHT, classic()] if is_quick else [
        FREE_FLIGHT, classic(), classic(penalty=1), classic(velocity_kept=0.95)]
    for i, integrator in enumerate(integrators):
        done = study.measured(scenes.column(integrator, time, blocks), folder / f"column-{i}")
        yield row_of(f"column of {blocks}", integrator, done, time), done.run


def beam_runs(folder, is_quick):
    deck = decks.read_deck(BEAM)
    for i, integrator in enumerate([FREE_FLIGHT, classic(), classic(velocity_kept=0.95)][:2 if is_quick else 3]):
        deck["motion"]["integrator"] = integrator
        if is_quick:
            deck["motion"]["time"] = 0.01
        done = study.measured(deck, folder / f"beam-{i}")
        yield row_of("falling beam", integrator, done, deck["motion"]["time"]), done.run


def last_outlines(run):
    return motion_checks.outlines(run.motion.fields())


def collapse(folder, is_quick):
    """Pairs of a row and the outlines at the end of its run."""
    runs = [*column_runs(folder, is_quick), *beam_runs(folder, is_quick)]
    return [(row, last_outlines(run)) for row, run in runs]


def table_of(rows):
    lines = ["| scene | integrator | came to | of its time | released | by friction | by fracture | energy missed | energy created | "
             "deepest overlap / size | steps | rejected | systems a step | time [s] |", "|" + 14 * "---|"]
    for row in rows:
        lines.append(
            f"| {row['scene']} | {row['integrator']} | {row['ended']} | {row['reached']:.0%} | {row['released']:.4g} | "
            f"{row['friction'] / row['released']:.0%} | {row['fracture']:.4g} | {row['missed']:.0e} | {row['created']:.0e} | "
            f"{row['overlap']:.1e} | {row['steps']} | {row['rejected']} | {row['solves'] / max(row['steps'], 1):.1f} | "
            f"{row['seconds']:.2g} |")
    return "\n".join(lines)
