// The curve of a run: its table, and the events located on it.

/** A run's curve: its table, the rows by step, and what its columns are. */
class Curve {
  constructor(table, summary, log) {
    this.table = table;
    this.summary = summary ?? {};
    this.log = log;
    this.steps = table.numbers(COLUMN.step) ?? Float64Array.from({length: table.numRows}, (_, i) => i);
    const stages = this.summary.stages ? table.numbers(COLUMN.stage) : undefined;
    this.kindOf = (row) => table.stability[row - 1] ?? STYLE.stability.length - 1;
    /** Rows whose stage is another than that of the row before. */
    this.firstRows = stages ? Array.from(this.steps.keys()).filter((row) => row > 0 && stages[row] !== stages[row - 1]) : [];
  }

  /** Where the curve of a stage begins, by its first row: at its own load in the place where the one before is held. */
  startsOf(x, y) {
    const startLoad = (row) => this.summary.stages.find(
        ({number}) => number === this.table.numbers(COLUMN.stage)[row])?.start_load ?? 0;
    const at = (name, row) => ({[COLUMN.load]: startLoad(row), [COLUMN.loadFactor]: 0})[name] ?? this.table.numbers(name)[row - 1];
    return new Map(this.firstRows.map((row) => [row, {x: at(x, row), y: at(y, row)}]));
  }

  rowOfStep(step) {
    return nearestRow(this.steps, step);
  }

  /** Unit of length: that of the run, or the one its gauges have most likely. */
  get lengthUnit() {
    return this.summary.units?.length ?? "mm";
  }

  displacements() {
    return this.table.numericColumns().filter((column) => column.unit === this.lengthUnit);
  }

  /** What goes on from row to row. */
  get clocks() {
    return [COLUMN.step];
  }

  get defaultAxis() {
    return (this.displacements()[0] ?? this.table.column(COLUMN.dissipated) ?? this.table.columns[0]).name;
  }

  /** What the kinds of line mean, of those that the curve has. */
  stabilityNote() {
    const has = (kind) => this.table.stability.includes(kind);
    return STYLE.stability.filter((_, kind) => has(kind)).map(({note}) => note).filter(Boolean).join(" ");
  }

  /** Names of the gauges: the summary lists them, without one they are the displacements. */
  gauges() {
    return Object.keys(this.summary.peak?.gauges ?? {}).length > 0 ? Object.keys(this.summary.peak.gauges) :
                                                                     this.displacements().map(({name}) => name);
  }

  /** What a reader wants to know of a step first; the axes of a figure can be chosen to see the rest. */
  describe(row, axes = []) {
    const {step, control, iterations, load, work, stored, dissipated, stiffness, lowest} = COLUMN;
    const counts = this.table.columns.map(({name}) => name).filter((name) => COLUMNS.counts.test(name));
    const names = [
      step, control, iterations, load, ...this.gauges(), ...axes, work, stored, dissipated, stiffness, ...counts, lowest
    ];
    const isKnown = (column) => column && !(column.numbers && Number.isNaN(column.numbers[row]));
    const columns = [...new Set(names)].map((name) => this.table.column(name)).filter(isKnown);
    const pairs = columns.map((column) => [symbolOf(column.name), column.textAt(row)]);
    const landed = this.log?.landed?.[this.steps[row]];
    return landed ? [...pairs, ["landed on", landed]] : pairs;
  }

  /** What the run located on its path, each with the name that a mark gets. */
  get events() {
    const {events} = this.summary;
    return (Array.isArray(events) ? events : []).filter((event) => typeof event === "object" && event !== null);
  }

  /** Peak and located events as marks over two columns; the limit point that is the peak is marked once. */
  marks(x, y) {
    const {peak} = this.summary;
    const hasPeak = peak?.step > 0;
    const isPeak = (event) => hasPeak && event.kind === "limit_point" && Math.abs(event.step - peak.step) <= 1 &&
        Math.abs(event.load - peak.load) <= 1e-3 * Math.abs(peak.load);
    const loadUnit = this.table.column(COLUMN.load)?.unit ?? "";
    const named = hasPeak ? [{...peak, kind: `peak, ${formatNumber(peak.load, 4)} ${loadUnit}`.trim()}] : [];
    const marks = [...named, ...this.events.filter((event) => !isPeak(event))]
                      .map((event) => this.markOf(event, x, y))
                      .filter(Boolean);
    // Of several of a name the first is labelled; the colour tells the others.
    const isFirst = (mark, i) => marks.findIndex(({label}) => label === mark.label) === i;
    return marks.map((mark, i) => (isFirst(mark, i) ? mark : {...mark, label: ""}));
  }

  /** An event may lie between two steps: its own numbers count, then those of its step. */
  markOf(event, x, y) {
    const row = Number.isFinite(event.step) ? this.rowOfStep(event.step) : null;
    const at =
        (name) => [event[name], event.gauges?.[name], row === null ? undefined : this.table.numbers(name)?.[row]].find(
            Number.isFinite);
    const [px, py] = [at(x), at(y)];
    const fill = MARK_COLOURS[event.kind] ?? PAPER;
    return px === undefined || py === undefined ? null : {x: px, y: py, label: eventName(event), fill};
  }
}

/** Other marks are empty. */
const MARK_COLOURS = {
  turning_point: PALETTE[5],
  bifurcation: PALETTE[4]
};

/** "turning point of cmod". */
function eventName(event) {
  const kind = words(event.kind ?? event.type ?? "event");
  return event.of && event.of !== "load" ? `${kind} of ${words(event.of)}` : kind;
}

/** The located events as a table, null when there are none. */
function eventTable(curve) {
  if (curve.events.length === 0) return null;
  const unit = (name) => curve.table.column(name)?.unit ?? "";
  const numbers = [COLUMN.load, ...curve.gauges()];
  const columns = [
    {
      title: "event",
      className: "status-cell",
      text: (event) => [eventName(event), event.extremum].filter(Boolean).join(", ")
    },
    {title: "step", isNumeric: true, text: ({step}) => String(step ?? "")},
    ...numbers.map((name) => ({
                     title: withUnit(words(name), unit(name)),
                     isNumeric: true,
                     text: (event) => formatNumber(event[name] ?? event.gauges?.[name])
                   })),
    {title: "where", text: ({located}) => words(located ?? "")},
    {title: "uncertainty", isNumeric: true, text: ({uncertainty}) => formatNumber(uncertainty, 2)},
  ];
  return folded(
      `${plural(curve.events.length, "located event")}${smallExtrema(curve.summary.small_extrema)}`,
      tableOf(columns, curve.events), curve.events.length <= 8);
}

/** "; smaller ones (below 0.5 %): 64 of load", which the list leaves out. */
function smallExtrema(small) {
  if (!small) return "";
  const counts = Object.entries(small).filter(([name]) => name !== "depth");
  return `; smaller ones (below ${100 * small.depth} %): ` +
      counts.map(([name, count]) => `${count} of ${words(name)}`).join(", ");
}
