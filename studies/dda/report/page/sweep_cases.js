// The cases of a sweep: what was varied, how each ended, its numbers and its curve.

class SweepCase {
  constructor(entry, row, table) {
    this.entry = entry;
    this.row = row;
    this.table = table;
    this.curve = entry.curve ? new Table({columns: entry.curve}) : null;
  }

  get number() {
    return this.entry.number ?? this.cell("case") ?? this.row + 1;
  }

  get status() {
    return this.entry.status || this.cell("status") || "unfinished";
  }

  get isGood() {
    return this.status === "goal_reached";
  }

  get reason() {
    return this.entry.reason ?? this.cell("reason") ?? "";
  }

  /** Number or text of a column of the table; NaN for a case without a row. */
  cell(name) {
    const column = this.table?.column(name);
    if (!column) return this.entry.settings?.[name];
    if (this.row < 0) return column.texts ? "" : NaN;
    return column.texts ? column.texts[this.row] : column.numbers[this.row];
  }

  setting(key) {
    return this.entry.settings?.[key] ?? this.cell(key);
  }
}

class Sweep {
  /** What curves have beside displacements. */
  static axes = [COLUMN.load, COLUMN.loadFactor, COLUMN.dissipated];

  constructor(data) {
    this.data = data;
    this.table = data.table ? new Table(data.table) : null;
    this.cases = data.cases.map((entry, i) => new SweepCase(entry, this.rowOf(entry, i), this.table));
    this.keys = [...new Set(data.cases.flatMap(({settings}) => Object.keys(settings ?? {})))];
  }

  /** The row of a case in the table: by its number, else by its folder; -1 when it has none. */
  rowOf(entry, i) {
    if (!this.table) return -1;
    const numbers = this.table.numbers("case");
    if (numbers && entry.number !== undefined) return numbers.indexOf(entry.number);
    const folders = this.table.column("folder")?.texts;
    return folders ? folders.indexOf(entry.folder) : i;
  }

  /** The name of a key or column of the table, as short as it can be. */
  shortName(name) {
    if (this.keys.includes(name)) return words(shortKey(name, this.keys));
    return words(name.replace(/^peak\.gauges\./, "peak ")
                     .replace(/^peak\./, "peak ")
                     .replace(/^timings\.total$/, "wall time")
                     .replace(/^timings\./, "time of "));
  }

  /** The same with its unit. */
  title(name) {
    return withUnit(this.shortName(name), this.table?.column(name)?.unit ?? "");
  }

  numericColumns() {
    return this.table ? this.table.numericColumns().filter(({name}) => name !== "exit_code") : [];
  }

  /** Columns that the curves of some case have, with the displacements first. */
  curveColumns() {
    const found = new Map();
    for (const {curve} of this.cases)
      for (const column of curve?.columns ?? [])
        if (column.isNumeric) found.set(column.name, column);
    const rank = ({name}) => Sweep.axes.indexOf(name);
    return [...found.values()].sort((one, other) => rank(one) - rank(other));
  }

  /** Values of a key over the cases, each once: numbers by size, else by the alphabet. */
  valuesOf(key) {
    const values = [...new Set(this.cases.map((one) => one.setting(key)))].filter((value) => value !== undefined);
    const areNumbers = values.every((value) => typeof value === "number");
    return areNumbers ? values.sort((one, other) => one - other) :
                        values.sort((one, other) => textOf(one).localeCompare(textOf(other), "en", {numeric: true}));
  }

  /** How cases are coloured by a key: colour(case) and the entries of a legend. */
  colouring(key) {
    if (!key) return {colour: () => PALETTE[0], entries: []};
    const values = this.valuesOf(key);
    const areNumbers = values.every((value) => typeof value === "number");
    // Numbers follow a scale; few words have colours of their own.
    const part = (i) => (values.length > 1 ? i / (values.length - 1) : 0);
    const colours = values.map(
        (_, i) =>
            (areNumbers || values.length > PALETTE.length ? colourOfNumber(part(i)) : PALETTE[i]));
    const colour = (one) => colours[values.indexOf(one.setting(key))] ?? GREY;
    return {
      colour,
      entries: thinnedLegend(values.map((value, i) => [`${this.shortName(key)} = ${textOf(value)}`, colours[i]]))
    };
  }
}

/** A value of a setting as text. */
function textOf(value) {
  if (typeof value === "number") return formatNumber(value);
  return typeof value === "string" ? value : JSON.stringify(value) ?? "–";
}

/** A long legend says its first and last and some between. */
function thinnedLegend(entries) {
  const most = 9;
  if (entries.length <= most) return entries;
  return Array.from({length: most}, (_, i) => entries[Math.round((i * (entries.length - 1)) / (most - 1))]);
}
