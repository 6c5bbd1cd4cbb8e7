"""Tables and sentences of README.md from results/*.csv; nothing in the marked region is typed."""

import math
import statistics

import figures
import nominal
import size_effect_law as law
from ddapath import study

# |relative error| allowed against the independent solver: up to this D/l_ch, and beyond.
LIMITS = ((4, 0.01), (math.inf, 0.02))
LARGE = 1  # D/l_ch from which the law is fitted once more


def of_beam(rows, beam):
    return [row for row in rows if row["beam"] == beam.name]


def percent(value, digits=2):
    return "–" if value is None or math.isnan(value) else f"{100 * value:+.{digits}f} %"


def plus_minus(value, half, digits):
    return f"{value:.{digits}f} ± {half:.{digits}f}"


def peak_table(beam, peaks):
    yield f"### {beam.title[0].upper()}{beam.title[1:]}"
    yield "| D/l_ch | independent solver | straight crack | difference | estimate of its error | observed order |"
    yield "|---|---|---|---|---|---|"
    for peak in peaks:
        order = "–" if math.isnan(peak.observed_order) else f"{peak.observed_order:.1f}"
        known = nominal.reference(beam, peak.length)
        yield (f"| {peak.length:g} | {known if known else '–'} | {peak.strength:.5f} | {percent(peak.error, 3)} | "
               f"{percent(peak.estimate, 3)} | {order} |")
    yield ""


def verdict(beam, peaks):
    """Whether every size is as close to the other solver as is asked."""
    for low, (high, limit) in zip((0, LIMITS[0][0]), LIMITS):
        found = [peak for peak in peaks if low < peak.length <= high and not math.isnan(peak.error)]
        if not found:
            continue
        worst = max(found, key=lambda peak: abs(peak.error))
        sizes = f"D/l_ch ≤ {high:g}" if math.isfinite(high) else f"D/l_ch > {low:g}"
        held = "yes" if abs(worst.error) <= limit else "**no**"
        yield (f"* {beam.title}: within {100 * limit:g} % for {sizes}: {held}, at most {percent(abs(worst.error), 3)[1:]}, "
               f"at D/l_ch = {worst.length:g}.")


def law_table(peaks):
    yield f"### Size-effect law, notched beam, ± {100 * law.CONFIDENCE:.0f} % confidence"
    yield "| fitted to | B | D₀/l_ch | slope of (ft/σ_N)² | linear elastic | farthest point |"
    yield "|---|---|---|---|---|---|"
    for name, chosen in (("all sizes", peaks), (f"D/l_ch ≥ {LARGE}", [p for p in peaks if p.length >= LARGE])):
        if len(chosen) < 3:
            continue
        found = fit(chosen)
        yield (f"| {name} | {plus_minus(found.b, found.b_half, 3)} | {plus_minus(found.d0, found.d0_half, 3)} | "
               f"{plus_minus(found.slope, found.slope_half, 2)} | {law.LEFM_SLOPE} | {100 * found.largest:.1f} % |")
    yield ""


def fit(peaks):
    return law.fit([peak.length for peak in peaks], [peak.strength for peak in peaks])


def bias_table(biases):
    yield "### Voronoi blocks against the straight crack"
    yield "| beam | D/l_ch | seeds | mean σ_N/ft | mesh bias | scatter | lowest | highest |"
    yield "|---|---|---|---|---|---|---|---|"
    for beam in nominal.BEAMS:
        for bias in biases.get(beam.name, []):
            yield (f"| {beam.title} | {bias.length:g} | {bias.count} | {bias.strength:.4f} | **{percent(bias.mean, 1)}** | "
                   f"{100 * bias.scatter:.1f} % | {percent(bias.lowest, 1)} | {percent(bias.highest, 1)} |")
    yield ""


def second_order_table(orders):
    yield "### Blocks of second order against the finest of first order"
    yield "| beam | blocks along the ligament [mm] | blocks | σ_N differs by at most | at D/l_ch | of the time |"
    yield "|---|---|---|---|---|---|"
    for beam in nominal.BEAMS:
        for size in sorted({found.block_size for found in orders[beam.name]}, reverse=True):
            chosen = [found for found in orders[beam.name] if found.block_size == size]
            worst = max(chosen, key=lambda found: abs(found.difference))
            yield (f"| {beam.title} | {size:g} | {worst.blocks:.0f} | {percent(worst.difference, 3)} | {worst.length:g} | "
                   f"{statistics.median(found.time for found in chosen):.2f} |")
    yield ""


def text(peaks, biases, orders):
    out = ["### Against the independent solver"]
    for beam in nominal.BEAMS:
        out += verdict(beam, peaks[beam.name])
    out.append("")
    out += law_table(peaks["notched"])
    out += second_order_table(orders)
    out += bias_table(biases)
    for beam in nominal.BEAMS:
        out += peak_table(beam, peaks[beam.name])
    return "\n".join(out)


def write(output):
    """Figure and README region from the tables of results."""
    straight, second, voronoi = (study.read_rows(output / "results" / f"{name}.csv")
                                 for name in ("straight", "second-order", "voronoi"))
    peaks = {beam.name: nominal.peaks(beam, of_beam(straight, beam)) for beam in nominal.BEAMS}
    biases = {beam.name: nominal.biases(beam, of_beam(voronoi, beam), peaks[beam.name]) for beam in nominal.BEAMS}
    orders = {beam.name: nominal.second_orders(beam, of_beam(second, beam), of_beam(straight, beam)) for beam in nominal.BEAMS}
    fitted = fit(peaks["notched"]) if len(peaks["notched"]) > 2 else None
    figures.draw(peaks, biases, fitted, output / "results" / "size-effect.svg")
    study.write_region(output / "README.md", text(peaks, biases, orders).rstrip())
