"""Tables from results/many-ranks.csv, and what they say of larger structures; nothing in the marked region is typed."""

import math
import os
import platform
import time

import numpy as np

from ddapath import study

plt = study.plots("many-ranks")

MIB = 2.0**20
LARGE = 10_000_000  # blocks of the structure that is foreseen
FORESEEN = (1, 4, 16, 64, 512)  # ranks of it
NETWORK = 1.25e9  # bytes a second between machines: ten gigabit
BYTES = 8  # of a number


def dense_rate(rows=3000):
    """Operations a second of this machine in a dense Cholesky factorisation, n³/3 of them."""
    a = np.eye(rows) * rows + np.ones((rows, rows))
    begin = time.perf_counter()
    np.linalg.cholesky(a)
    return rows**3 / 3 / (time.perf_counter() - begin)


def border_rows(rows):
    """b of a structure from its runs on several ranks, whose rank 0 has received

        S_B of the others in each factorisation, (2 (N − 2) + ½) b² numbers,
        and their part of all solutions, 1 − 2/N² of a number that is the same for all N
    """
    several = [row for row in rows if row["ranks"] > 1]
    shares = [[2 * (row["ranks"] - 2) + 0.5, 1 - 2 / row["ranks"] ** 2] for row in several]
    numbers = [row["received_mib"] * MIB / row["factorisations"] / BYTES for row in several]
    return math.sqrt(np.linalg.lstsq(np.array(shares), np.array(numbers), rcond=None)[0][0])


def exponent(rows, name):
    x, y = (np.log([row[key] for row in rows]) for key in ("blocks", name))
    return float(np.polyfit(x, y, 1)[0]) if len(rows) > 1 else 1.0


def measured(rows):
    yield "| blocks | ranks | memory of each [MiB] | most of one rank's | factorisation [s] | shared work [s] | times as fast | whole [s] " \
          "| messages | MiB sent, received | peak [N] |"
    yield "|" + "---|" * 11
    for row in rows:
        one = next(other for other in rows if other["blocks"] == row["blocks"] and other["ranks"] == 1)
        memory = [row[f"memory_{k}"] for k in range(int(row["ranks"]))]
        yield (f"| {row['blocks']:.0f} | {row['ranks']:.0f} | {', '.join(f'{mib:.0f}' for mib in memory)} "
               f"| {max(memory) / one['memory_0']:.2f} | {row['factorisation']:.2f} | {row['shared']:.2f} "
               f"| {one['shared'] / row['shared']:.2f} | {row['whole']:.1f} | {row['exchanges']:.0f} "
               f"| {row['sent_mib']:.0f}, {row['received_mib']:.0f} | {row['peak_load']:.2f} |")


def of_ranks(rows, ranks):
    """What N ranks take for LARGE blocks: bytes that rank 0 receives in a factorisation, bytes between the strips, its
    operations there, and seconds of a strip."""
    alone = [row for row in rows if row["ranks"] == 1]
    b = border_rows([row for row in rows if row["blocks"] == alone[-1]["blocks"]]) * math.sqrt(LARGE / alone[-1]["blocks"])
    inner, pairs = max(ranks - 2, 0), ranks - 1
    seconds = alone[-1]["factorisation"] * (LARGE / alone[-1]["blocks"]) ** exponent(alone, "factorisation") / ranks
    return {"received": BYTES * (2 * inner + pairs / max(pairs, 1) / 2) * b**2 if pairs else 0.0,
            "between": BYTES * (pairs + inner) * b**2, "operations": pairs * b**3 / 3 + inner * 2 * b**3, "seconds": seconds}


def foreseen(rows, rate):
    yield "| ranks | strip of each [s] | between the strips, rank 0 [s] | on its way to rank 0 [GiB] | [s] | held between the strips [GiB] |"
    yield "|" + "---|" * 6
    for ranks in FORESEEN:
        at = of_ranks(rows, ranks)
        yield (f"| {ranks} | {at['seconds']:.0f} | {at['operations'] / rate:.0f} | {at['received'] / MIB / 1024:.1f} "
               f"| {at['received'] / NETWORK:.0f} | {at['between'] / MIB / 1024:.1f} |")


def best_number(rows, rate):
    """Ranks beyond which the time of strips and of what lies between them grows."""
    times = {ranks: (at := of_ranks(rows, ranks))["seconds"] + at["operations"] / rate for ranks in range(1, 65)}
    return min(times, key=times.get)


def text(rows):
    rate = dense_rate()
    last = [row for row in rows if row["ranks"] == max(other["ranks"] for other in rows)][-1]
    b = border_rows([row for row in rows if row["blocks"] == last["blocks"]])
    return "\n".join([
        f"{platform.machine()}, {os.cpu_count()} cores for all ranks together.\n", *measured(rows), "",
        f"### {LARGE / 1e6:.0f} million blocks\n", *foreseen(rows, rate), "",
        f"b = {b:.0f} unknowns of {last['blocks']:.0f} blocks. Dense factorisation: {rate / 1e9:.0f} · 10⁹ operations a second, measured here. Rank 0 has "
        f"{last['memory_0'] * MIB / last['blocks'] / 1024:.1f} KiB a block of {last['blocks']:.0f} on {last['ranks']:.0f} ranks, model "
        f"included: {last['memory_0'] / last['blocks'] * LARGE / 1024:.0f} GiB for {LARGE / 1e6:.0f} million. The time of strips and "
        f"between them is least on {best_number(rows, rate)} ranks.", ""])


def draw(rows, file):
    """Memory of each rank, of the largest structure, beside the time of its shared work."""
    last = [row for row in rows if row["blocks"] == rows[-1]["blocks"]]
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
    for k in range(int(last[-1]["ranks"])):
        having = [row for row in last if row["ranks"] > k]
        left.bar([row["ranks"] + 0.2 * (k - (row["ranks"] - 1) / 2) for row in having], [row[f"memory_{k}"] / 1024 for row in having],
                 width=0.18, label=f"rank {k}")
    left.set_ylabel("memory [GiB]")
    left.legend(frameon=False, fontsize=8)
    right.plot([row["ranks"] for row in last], [last[0]["shared"] / row["shared"] for row in last], marker="o", color="black")
    right.set_ylabel("shared work, times as fast")
    right.set_ylim(bottom=0)
    for panel in (left, right):
        panel.set_xlabel(f"ranks, {last[0]['blocks']:.0f} blocks")
        panel.set_xticks([row["ranks"] for row in last])
    figure.tight_layout()
    study.save(figure, file)


def write(output, rows):
    draw(rows, output / "results" / "many-ranks.svg")
    study.write_region(output / "README.md", text(rows))
