// The figures of a run over its path: load against a gauge, stability, energies.

/** Load against displacement, axes to be chosen. */
class CurveFigure {
  constructor(curve, name, {onPick, note}) {
    this.curve = curve;
    this.axes = {x: curve.defaultAxis, y: curve.table.column(COLUMN.load) ? COLUMN.load : curve.table.columns[0].name};
    this.plot = new Plot({
      name: fileName(name, "curve"),
      label: "Load against displacement; arrow keys go from step to step",
      height: (width) => Math.min(400, Math.max(260, 0.72 * width)),
      describe: (series, row) => curve.describe(row, Object.values(this.axes)),
      pick: (series, row) => onPick?.(curve.steps[row]),
    });
    this.figure = element("figure", {id: "curve"}, this.toolbar(), this.plot.stage, element("figcaption", {}, note));
    this.show();
  }

  toolbar() {
    const options = this.curve.table.numericColumns().map((column) => [column.name, words(column.name)]);
    const choose = (axis) => (value) => {
      this.axes[axis] = value;
      this.show();
    };
    return element(
        "div", {class: "toolbar"}, chooser("across", options, this.axes.x, choose("x")),
        chooser("up", options, this.axes.y, choose("y")), this.plot.buttons());
  }

  show() {
    const [x, y] = [this.axes.x, this.axes.y].map((name) => this.curve.table.column(name));
    this.plot.show({
      xLabel: x.label,
      yLabel: y.label,
      series: [{
        x: x.numbers,
        y: y.numbers,
        colour: PALETTE[0],
        dots: x.numbers.length < 400,
        kindOf: this.curve.kindOf,
        starts: this.curve.startsOf(x.name, y.name)
      }],
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
    this.plot.setCursor({x: x[row], y: y[row]});
  }
}

/** Several columns over one, with a legend; axis to be chosen among step and gauges. */
class LinesFigure {
  /** lines: [{name, values, unit}] */
  constructor(curve, lines, {id, name, yLabel, note}) {
    Object.assign(this, {curve, lines, yLabel});
    this.plot = new Plot({
      name: fileName(name, id),
      label: `${yLabel} along the path`,
      height: (width) => Math.min(330, Math.max(220, 0.6 * width)),
      describe: (series, i) => [
          [COLUMN.step, String(curve.steps[series.rows[i]])],
          ...lines.map((line) => [line.name, formatNumber(line.values[series.rows[i]])])],
    });
    const axes = [
      ...curve.clocks.map((clock) => [clock, clock]),
      ...curve.displacements().map((column) => [column.name, words(column.name)])
    ];
    this.figure = element(
        "figure", {id},
        element(
            "div", {class: "toolbar"}, chooser("across", axes, axes[0][0], (axis) => this.show(axis)),
            this.plot.buttons()),
        this.plot.stage,
        element(
            "figcaption", {},
            lines.length > 1 ? legend(lines.map((line, i) => [line.name, PALETTE[i % PALETTE.length]])) : null,
            note ?? ""));
    this.show(axes[0][0]);
  }

  show(axis) {
    const column = this.curve.table.column(axis);
    const across = column?.numbers ?? this.curve.steps;
    const series = this.lines.map(({values}, i) => {
      // What is computed now and then only is drawn from one value to the next.
      const rows = [...values.keys()].filter((row) => Number.isFinite(values[row]));
      const [x, y] = [across, values].map((numbers) => rows.map((row) => numbers[row]));
      return {rows, x, y, colour: PALETTE[i % PALETTE.length], dots: rows.length < values.length};
    });
    this.plot.show({xLabel: column?.label ?? axis, yLabel: this.yLabel, series});
  }
}
