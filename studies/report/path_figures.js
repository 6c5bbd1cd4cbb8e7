// The figures of a run over its path: load against a gauge, stability, energies.

/** A run's curve: its table, the rows by step, and what its columns are. */
class Curve {
  constructor(table, summary, log) {
    this.table = table;
    this.summary = summary ?? {};
    this.log = log;
    this.steps = table.numbers("step") ?? Float64Array.from({ length: table.numRows }, (_, i) => i);
    this.isUnstable = this.stability();
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

  get defaultAxis() {
    return (this.displacements()[0] ?? this.table.column("dissipated_energy") ?? this.table.columns[0]).name;
  }

  /** Whether the structure is unstable where this row's part of the path ends; null when nobody asked. */
  stability() {
    const negative = this.table.numbers("negative_eigenvalues");
    return negative ? (row) => negative[row] > 0 : null;
  }

  /** All that is known of a step, with units. */
  describe(row) {
    const hidden = new Set(["load_factor"]);
    const load = this.table.column("load");
    if (!load || load.unit !== "") hidden.delete("load_factor");
    const pairs = this.table.columns.filter((column) => !hidden.has(column.name)).map((column) => [words(column.name), column.textAt(row)]);
    const landed = this.log?.landed?.[this.steps[row]];
    return landed ? [...pairs, ["landed on", landed]] : pairs;
  }

  /** Peak and located events as marks over two columns. */
  marks(x, y) {
    const { peak, events } = this.summary;
    const listed = Array.isArray(events) ? events : [];
    const marks = listed.map((event) => this.markOf(event, x, y)).filter(Boolean);
    if (!peak || !(peak.step > 0)) return marks;
    const loadUnit = this.table.column("load")?.unit ?? "";
    return [this.markOf({ ...peak, kind: `peak, ${formatNumber(peak.load, 4)} ${loadUnit}`.trim() }, x, y), ...marks].filter(Boolean);
  }

  /** An event may lie between two steps: its own numbers count, then those of its step. */
  markOf(event, x, y) {
    if (typeof event !== "object" || event === null) return null;
    const row = Number.isFinite(event.step) ? this.rowOfStep(event.step) : null;
    const at = (name) => [event[name], event.gauges?.[name], row === null ? undefined : this.table.numbers(name)?.[row]].find(Number.isFinite);
    const [px, py] = [at(x), at(y)];
    return px === undefined || py === undefined ? null : { x: px, y: py, label: words(event.kind ?? event.type ?? "event") };
  }
}

/** Load against displacement, axes to be chosen. */
class CurveFigure {
  constructor(curve, name, { onPick, note }) {
    this.curve = curve;
    this.axes = { x: curve.defaultAxis, y: curve.table.column("load") ? "load" : curve.table.columns[0].name };
    this.plot = new Plot({
      name: fileName(name, "curve"),
      label: "Load against displacement; arrow keys go from step to step",
      height: (width) => Math.min(400, Math.max(260, 0.72 * width)),
      describe: (series, row) => curve.describe(row),
      pick: (series, row) => onPick?.(curve.steps[row]),
    });
    this.figure = element("figure", { id: "curve" }, this.toolbar(), this.plot.stage, element("figcaption", {}, note));
    this.show();
  }

  toolbar() {
    const options = this.curve.table.numericColumns().map((column) => [column.name, words(column.name)]);
    const choose = (axis) => (value) => {
      this.axes[axis] = value;
      this.show();
    };
    return element("div", { class: "toolbar" }, chooser("across", options, this.axes.x, choose("x")),
      chooser("up", options, this.axes.y, choose("y")), this.plot.buttons());
  }

  show() {
    const [x, y] = [this.axes.x, this.axes.y].map((name) => this.curve.table.column(name));
    this.plot.show({
      xLabel: x.label,
      yLabel: y.label,
      series: [{ x: x.numbers, y: y.numbers, colour: PALETTE[0], dots: x.numbers.length < 400, dashed: this.curve.isUnstable }],
      marks: this.curve.marks(x.name, y.name),
    });
    this.mark(this.step);
  }

  /** Marks the step that the picture shows. */
  mark(step) {
    this.step = step;
    if (step === undefined) return;
    const row = this.curve.rowOfStep(step);
    const [x, y] = [this.axes.x, this.axes.y].map((name) => this.curve.table.numbers(name));
    this.plot.setCursor({ x: x[row], y: y[row] });
  }
}

/** Several columns over one, with a legend; axis to be chosen among step and gauges. */
class LinesFigure {
  /** lines: [{name, values, unit}] */
  constructor(curve, lines, { id, name, yLabel, note }) {
    Object.assign(this, { curve, lines, yLabel });
    this.plot = new Plot({
      name: fileName(name, id),
      label: `${yLabel} along the path`,
      height: (width) => Math.min(330, Math.max(220, 0.6 * width)),
      describe: (series, row) => [["step", String(curve.steps[row])], ...lines.map((line) => [line.name, formatNumber(line.values[row])])],
    });
    const axes = [["step", "step"], ...curve.displacements().map((column) => [column.name, words(column.name)])];
    this.figure = element("figure", { id }, element("div", { class: "toolbar" },
      chooser("across", axes, "step", (axis) => this.show(axis)), this.plot.buttons()), this.plot.stage,
      element("figcaption", {}, legend(lines.map((line, i) => [line.name, PALETTE[i % PALETTE.length]])), note ?? ""));
    this.show("step");
  }

  show(axis) {
    const column = this.curve.table.column(axis);
    this.plot.show({
      xLabel: column?.label ?? axis,
      yLabel: this.yLabel,
      series: this.lines.map((line, i) => ({ x: column?.numbers ?? this.curve.steps, y: line.values, colour: PALETTE[i % PALETTE.length] })),
    });
  }
}
