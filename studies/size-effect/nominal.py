"""Nominal strengths from the tables of the sweeps, and what they are compared with.

    σ_N = 6 M / (b D²),  M = P S/4 (three-point), P S/6 (loads at the thirds)      gross section, P the peak load
    l_ch = E Gf / ft²
"""

from dataclasses import dataclass

import numpy as np

LENGTHS = (0.05, 0.1, 0.2, 0.5, 1, 2, 4, 10)  # D/l_ch
ORDER = 2  # of the consistent joint with first-order blocks in the block size


@dataclass(frozen=True)
class Beam:
    """One geometry: its decks, and the strengths σ_N/ft of an independent cohesive-crack solver at LENGTHS."""

    name: str
    title: str
    lever: float  # M / (P S)
    reference: tuple


BEAMS = (
    Beam("notched", "notched, three-point, a₀/D = 0.5", 1 / 4,
         (0.58075, 0.53573, 0.48438, 0.40881, 0.34817, 0.28730, 0.22912, 0.16125)),
    Beam("three-point", "uncracked, three-point, S/D = 4", 1 / 4,
         (2.2097, 2.0239, 1.8253, 1.5637, 1.3868, 1.2468, 1.1533, 1.0893)),
    Beam("four-point", "uncracked, four-point, S/D = 3", 1 / 6,
         (2.0896, 1.8866, 1.6772, 1.4147, 1.2462, 1.1182, 1.0358, 0.9811)),
)


def reference(beam, length):
    """σ_N/ft at a D/l_ch, None where the other solver was not asked."""
    return next((value for known, value in zip(LENGTHS, beam.reference) if np.isclose(known, length)), None)


def dimensions(deck):
    """Depth and span of a deck, in its unit of length."""
    supports = [support["at"] for support in deck["supports"].values()]
    tops = [load["at"][1] for load in deck["stages"][0]["loads"]]
    return max(tops), abs(supports[1][0] - supports[0][0])


def strengths(beam, deck, table):
    """A dictionary per case of a sweep that reached its goal: D/l_ch and σ_N/ft, with what tells the case apart."""
    (name, interface), = deck["interfaces"].items()
    depth, span = dimensions(deck)
    modulus, strength = deck["materials"]["concrete"]["young_modulus"], interface["law"]["tensile_strength"]
    rows = []
    energy_key, size_key = f"interfaces.{name}.law.fracture_energy", "scene.parameters.ligament_size"
    for case in table.to_dict("records"):
        energy = case[energy_key]
        moment = beam.lever * case["peak.load"] * span
        rows.append({"beam": beam.name, "length": float(f"{depth * strength**2 / (modulus * energy):.6g}"),
                     "block_size": case.get(size_key), "seed": case.get("seed"), "blocks": case["blocks"],
                     "steps": case["steps"], "seconds": case.get("timings.total"),
                     "strength": 6 * moment / (deck["thickness"] * depth**2) / strength})
    return rows


@dataclass(frozen=True)
class SecondOrder:
    """One beam of one size by blocks of second order, beside the finest of first order."""

    beam: str
    length: float
    block_size: float
    blocks: int
    difference: float  # of σ_N, relative to the finest blocks of first order
    time: float  # of the run, relative to theirs


def second_orders(beam, rows, straight):
    """One SecondOrder per size and block size; `straight` are the rows of first order."""
    out = []
    for row in sorted(rows, key=lambda row: (row["length"], -row["block_size"])):
        finest = min((other for other in straight if other["length"] == row["length"]), key=lambda other: other["block_size"])
        out.append(SecondOrder(beam.name, row["length"], row["block_size"], row["blocks"], row["strength"] / finest["strength"] - 1,
                          row["seconds"] / finest["seconds"]))
    return out


def richardson(coarse, fine, ratio=2.0, order=ORDER):
    """Relative error of the fine value, estimated: (coarse − fine) / (ratio^order − 1) / fine."""
    return (coarse - fine) / (ratio**order - 1) / fine


@dataclass(frozen=True)
class Peak:
    """What is known of a straight crack in one beam of one size."""

    beam: str
    length: float
    strength: float  # σ_N/ft on the finest blocks
    estimate: float  # of its relative error, from the two finest
    observed_order: float  # from the three finest; nan where they do not converge monotonically
    error: float  # against the reference, relative


def peaks(beam, rows):
    """One Peak per size from the rows of the straight sweep."""
    out = []
    for length in sorted({row["length"] for row in rows}):
        line = sorted((row for row in rows if row["length"] == length), key=lambda row: -row["block_size"])
        values = [row["strength"] for row in line]
        ratio = line[-2]["block_size"] / line[-1]["block_size"]
        known = reference(beam, length)
        out.append(Peak(beam.name, length, values[-1], richardson(values[-2], values[-1], ratio),
                        observed_order(values, ratio), values[-1] / known - 1 if known else np.nan))
    return out


def observed_order(values, ratio):
    """log of the ratio of the last two changes; blocks shrink by `ratio` each time."""
    if len(values) < 3:
        return np.nan
    changes = np.diff(values[-3:])
    return float(np.log(changes[0] / changes[1]) / np.log(ratio)) if changes[0] * changes[1] > 0 else np.nan


@dataclass(frozen=True)
class Bias:
    """Voronoi blocks against the straight crack: relative to its strength."""

    beam: str
    length: float
    count: int
    strength: float  # mean σ_N/ft
    mean: float  # of σ_N/σ_N,straight − 1
    scatter: float  # standard deviation of that over the seeds
    lowest: float
    highest: float


def biases(beam, rows, straight):
    """One Bias per size that the straight crack has too."""
    out = []
    for peak in straight:
        values = np.array([row["strength"] for row in rows if row["length"] == peak.length])
        if len(values) < 2:
            continue
        off = values / peak.strength - 1
        out.append(Bias(beam.name, peak.length, len(values), values.mean(), off.mean(), off.std(ddof=1), off.min(),
                        off.max()))
    return out
