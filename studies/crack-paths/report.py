"""Tables of README.md and the figures from results/*.csv; nothing in the marked region is typed."""

import statistics

import figures
import patterns
from ddapath import study

PARTS = ("beams", "curved", "second-order", "paper")
STRAIGHT_KITOH = 14997.0  # N


def percent(value, digits=2):
    return f"{100 * value:+.{digits}f} %"


def read(folder):
    """Rows of each part that has been run, and the places of its cracks."""
    out = {}
    for part in PARTS:
        for name in (part, f"{part}-paths"):
            file = folder / "results" / f"{name}.csv"
            out[name] = study.read_rows(file) if file.exists() else []
    return out


def chosen(rows, **what):
    return [row for row in rows if all(row[key] == value for key, value in what.items())]


def station(places, structure, at):
    """Where the first crack that gets there is at a station, on the straight line between two of its places."""
    key, other = ("y", "x") if structure.across == "y" else ("x", "y")
    for crack in sorted({place["crack"] for place in places}):
        line = chosen(places, crack=crack)
        for one, two in zip(line, line[1:]):
            if min(one[key], two[key]) <= at <= max(one[key], two[key]) and one[key] != two[key]:
                share = (at - one[key]) / (two[key] - one[key])
                return one[other] + share * (two[other] - one[other])
    return None


def bias_table(rows):
    yield "### Peak against that of the straight crack"
    yield "| beam | size | " + " | ".join(patterns.PATTERNS) + " |"
    yield "|---|---|" + "---|" * len(patterns.PATTERNS)
    for structure in patterns.BEAMS:
        for size in patterns.SIZES:
            cells = []
            for pattern in patterns.PATTERNS:
                found = chosen(rows, structure=structure.name, size=size, pattern=pattern)
                cells.append(percent(found[0]["peak"] / structure.reference - 1) if found else "–")
            yield f"| {structure.title} | {size} | " + " | ".join(cells) + " |"
    yield ""


def worst(rows, structure, size):
    found = [row["peak"] / structure.reference - 1 for row in chosen(rows, structure=structure.name, size=size)]
    return max(found, key=abs) if found else None


def beam_verdicts(rows):
    for structure in patterns.BEAMS:
        found = chosen(rows, structure=structure.name, size="middle")
        over = [row["pattern"] for row in found
                if abs(row["peak"] / structure.reference - 1) > patterns.allowed(structure, row["pattern"])]
        sizes = [worst(rows, structure, size) for size in patterns.SIZES]
        if found:
            yield (f"* {structure.title}: at about 1300 blocks within {percent(structure.bias, 1)[1:]} "
                   f"(triangles {percent(patterns.allowed(structure, 'triangles'), 1)[1:]}): "
                   f"{'yes' if not over else '**no**, ' + ', '.join(over)}; largest by size: "
                   + ", ".join(percent(value) for value in sizes if value is not None) + ".")
    off = [abs(row["work_over_spent"] - 1) for row in rows]
    ended = [row for row in rows if row["status"] != "goal_reached"]
    if rows:
        yield (f"* Work put in and not stored, over the energy of the laws: 1 within {100 * max(off):.2g} % on every path, "
               f"half of them within {100 * statistics.median(off):.2g} %.")
        yield f"* {len(rows) - len(ended)} of {len(rows)} paths reach 30 % of their peak."
    for row in ended:
        yield f"    * {row['structure']}, {row['size']}, {row['pattern']}: to {100 * row['end']:.0f} %: {row['reason']}"
    yield ""


def curved_table(rows, paths, structure):
    yield f"### {structure.title[0].upper()}{structure.title[1:]}"
    other = "x" if structure.across == "y" else "y"
    stations = " | ".join(f"{other} at {structure.across} = {at} [mm]" for at in structure.stations)
    yield f"| direction | pattern | blocks | peak [N] | {stations} | load at the end |"
    yield "|---|---|---|---|" + "---|" * (len(structure.stations) + 1)
    for row in chosen(rows, structure=structure.name):
        what = {key: row[key] for key in ("structure", "direction", "pattern")}
        at = [station(chosen(paths, **what), structure, place) for place in structure.stations]
        cells = " | ".join("–" if value is None else f"{value:.1f}" for value in at)
        end = f"{100 * row['end']:.0f} %" + ("" if row["status"] == "goal_reached" else f", {row['reason']}")
        yield f"| {row['direction']} | {row['pattern']} | {row['blocks']:.0f} | {row['peak']:.0f} | {cells} | {end} |"
    yield ""
    yield from spread(rows, paths, structure)


def differences(rows, paths, structure):
    """Peaks, and half of what the paths differ by at each station, in depths."""
    places = []
    for at in structure.stations:
        values = [station(chosen(paths, structure=structure.name, direction=row["direction"], pattern=row["pattern"]),
                          structure, at) for row in rows]
        values = [value for value in values if value is not None]
        places.append((max(values) - min(values)) / 2 / structure.depth if values else 0.0)
    return [row["peak"] for row in rows], places


def spread(rows, paths, structure):
    """How much peak and path differ between the patterns."""
    for direction in dict.fromkeys(row["direction"] for row in rows):
        found = chosen(rows, structure=structure.name, direction=direction)
        if len(found) < 2:
            continue
        peaks, places = differences(found, paths, structure)
        yield (f"`{direction}`: peaks differ by {100 * (max(peaks) / min(peaks) - 1):.2f} %, paths by "
               + ", ".join(f"± {100 * value:.1f} %" for value in places) + " of the depth.")
        yield ""


def second_order_tables(rows, paths, first):
    """Blocks of second order beside as many of first order: bias of the beams, and how much curved cracks differ between
    the patterns."""
    yield "### Blocks of second order, about 1300"
    yield "| beam | " + " | ".join(patterns.PATTERNS) + " | mean (first order) | seconds (first order) |"
    yield "|---|" + "---|" * (len(patterns.PATTERNS) + 2)
    for structure in patterns.BEAMS:
        found = {row["pattern"]: row for row in chosen(rows, structure=structure.name)}
        of_first = chosen(first["beams"], structure=structure.name, size="middle")
        cells = [percent(found[name]["peak"] / structure.reference - 1) if name in found else "–" for name in patterns.PATTERNS]
        yield (f"| {structure.title} | " + " | ".join(cells)
               + f" | {mean_bias(found.values(), structure)} ({mean_bias(of_first, structure)})"
               + f" | {middle_seconds(found.values())} ({middle_seconds(of_first)}) |")
    yield ""
    yield "| curved crack | peak [N] | peaks differ by (first order) | paths by ± | seconds (first order) |"
    yield "|---|---|---|---|---|"
    for structure in patterns.CURVED:
        found = chosen(rows, structure=structure.name)
        of_first = chosen(first["curved"], structure=structure.name, direction="nonlocal_stress")
        if len(found) > 1:
            peaks, places = differences(found, paths, structure)
            shown = ", ".join(f"{100 * value:.1f} %" for value in places)
            yield (f"| {structure.title} | {min(peaks):.0f} to {max(peaks):.0f} | {range_of(found)} ({range_of(of_first)}) | "
                   f"{shown} of the depth | {middle_seconds(found)} ({middle_seconds(of_first)}) |")
    yield ""


def mean_bias(rows, structure):
    return percent(statistics.mean(abs(row["peak"] / structure.reference - 1) for row in rows))[1:] if rows else "–"


def range_of(rows):
    peaks = [row["peak"] for row in rows]
    return f"{100 * (max(peaks) / min(peaks) - 1):.2f} %" if peaks else "–"


def middle_seconds(rows):
    return f"{statistics.median(row['seconds'] for row in rows):.1f}" if rows else "–"


def paper_table(rows):
    yield "### The paper's beam: cracks between blocks and through them"
    yield "| cracks | blocks | meshes | mean bias of the peak | smallest | largest |"
    yield "|---|---|---|---|---|---|"
    for way in dict.fromkeys(row["way"] for row in rows):
        for blocks in sorted({row["blocks_asked"] for row in rows}):
            found = [row["peak"] / STRAIGHT_KITOH - 1 for row in chosen(rows, way=way, blocks_asked=blocks)]
            if found:
                yield (f"| {way} | {blocks:.0f} | {len(found)} | {percent(statistics.mean(found), 1)} | "
                       f"{percent(min(found), 1)} | {percent(max(found), 1)} |")
    yield ""


def write(folder):
    data = read(folder)
    lines = [*bias_table(data["beams"]), *beam_verdicts(data["beams"])]
    for structure in patterns.CURVED:
        if chosen(data["curved"], structure=structure.name):
            lines += curved_table(data["curved"], data["curved-paths"], structure)
    lines += second_order_tables(data["second-order"], data["second-order-paths"], data)
    lines += paper_table(data["paper"])
    study.write_region(folder / "README.md", "\n".join(lines).strip())
    figures.draw_paths(data["beams-paths"], data["curved-paths"], folder / "results" / "paths.svg")
    if data["paper"]:
        figures.draw_bias(data["paper"], STRAIGHT_KITOH, folder / "results" / "bias.svg")
