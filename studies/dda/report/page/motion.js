// What moves behind a path: the blocks as they fly, slide and rest, and beside them where the energy goes.

/** The rows of motion.csv. */
class MotionCurve extends Curve {
  get clocks() {
    return ["time", COLUMN.step];
  }

  get defaultAxis() {
    return "time";
  }
}

const MOTION_ENERGIES = {
  external_work: "external work",
  kinetic_energy: "kinetic",
  stored_energy: "stored",
  friction: "friction",
  fracture: "fracture",
  viscous_damping: "viscous damping",
  impact: "impact",
  numerical_damping: "numerical damping",
};

/** The section of a motion. */
class MotionFigures {
  /** told: what the summary says of it. */
  constructor(data, told, name) {
    const table = data.curve ? new Table(data.curve) : null;
    this.curve = table && table.numRows > 0 ? new MotionCurve(table, {units: data.units}, null) : null;
    this.blocks = data.blocks?.steps.length > 0 ? new Blocks(data.blocks) : null;
    Object.assign(this, {told, name});
  }

  section() {
    const figures = element("div", {class: "figures"});
    if (this.blocks) figures.append(this.picture().figure);
    if (this.curve) figures.append(this.energies().figure);
    return section(
        "motion", "Motion", element("p", {class: "quiet"}, this.told?.reason ?? "It has not ended yet."), figures);
  }

  picture() {
    this.shown = new Choice(this.blocks.steps.length - 1);
    this.moving = new DeformedFigure(
        this.blocks, this.shown, {name: this.name, id: "moving", isTrue: true, stepText: (step) => this.textOf(step)});
    return this.moving;
  }

  textOf(step) {
    if (!this.curve || step === 0) return step === 0 ? "at the beginning" : `step ${step}`;
    return `step ${step}: ${this.curve.table.column("time").textAt(this.curve.rowOfStep(step))}`;
  }

  energies() {
    const {table} = this.curve;
    const lines = Object.entries(MOTION_ENERGIES)
      .map(([column, name]) => ({name, values: table.numbers(column)}))
      .filter(({values}) => values.some((value) => value !== 0));
    return new LinesFigure(this.curve, lines, {
      id: "motion-energies",
      name: this.name,
      yLabel: withUnit("energy", table.column("external_work").unit),
      note: "External work less all others is what solving has missed.",
    });
  }
}
