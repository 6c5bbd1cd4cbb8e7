// Numbers of the cases of a sweep against each other.

/** What is drawn of them beside the axes. */
class SweepScatter {
  /** sweep: a Sweep; shown: what `axesPlot` of the page gives; draw: draws all anew. */
  constructor(sweep, shown, draw) {
    this.sweep = sweep;
    this.shown = shown;
    this.over = this.law = "";
    this.isLogarithmic = false;
    const set = (name) => (value) => {
      this[name] = value;
      draw();
    };
    const columns = shown.columns.map(({name}) => [name, sweep.shortName(name)]);
    const laws = Object.entries(SWEEP_LAWS).map(([name, {title}]) => [name, title]);
    this.words = element("span", {id: "scatter-words"});
    shown.figure.querySelector(".toolbar")
        .append(
            chooser("divided by", [["", "nothing"], ...columns], "", set("over")),
            chooser("law", [["", "none"], ...laws], "", set("law")),
            checkbox("logarithms", false, set("isLogarithmic")));
    shown.figure.querySelector("figcaption").append(" ", this.words);
  }

  /** Up may be divided by another column: a nominal strength by a load and an area. */
  up(one) {
    const value = one.cell(this.shown.axes.y);
    return this.over ? value / one.cell(this.over) : value;
  }

  label(axis) {
    const {axes, columns} = this.shown;
    const titled = (name) => withUnit(this.sweep.shortName(name), columns.find((column) => column.name === name).unit);
    return axis === "y" && this.over ? `${titled(axes.y)} / ${titled(this.over)}` : titled(axes[axis]);
  }

  /** Points as they are drawn; those that have no logarithm are not. */
  drawn(points) {
    if (!this.isLogarithmic) return points;
    return points.map((point) => point.map((value) => (value > 0 ? Math.log10(value) : NaN)));
  }

  series(points, style) {
    const drawn = this.drawn(points);
    return {x: drawn.map(([x]) => x), y: drawn.map(([, y]) => y), ...style};
  }

  /** The number that is drawn at a place. */
  numberAt(drawn) {
    return this.isLogarithmic ? 10 ** drawn : drawn;
  }

  place(one) {
    const [[x, y]] = this.drawn([[one.cell(this.shown.axes.x), this.up(one)]]);
    return {x, y};
  }

  /** One point for each case; beside them their spread, and the law that goes through them. */
  content(colour, chosen) {
    const cases = this.sweep.cases.filter(({row}) => row >= 0);
    const points = cases.map((one) => [one.cell(this.shown.axes.x), this.up(one)]);
    const style = (one) =>
        ({case: one, colour: colour(one), width: one === chosen ? 3.6 : 1.4, onlyDots: true, dots: true});
    const groups = spreads(points);
    const bars = groups.map(
        ({x, mean, deviation}) =>
            this.series([[x, mean - deviation], [x, mean], [x, mean + deviation]], {colour: GREY, width: 1.2}));
    const law = this.law ? fittedLaw(SWEEP_LAWS[this.law], points) : null;
    this.words.textContent = [
      groups.length > 0 ? "Bars: mean and standard deviation of cases at the same place." : "", law?.words
    ].filter(Boolean).join(" ");
    return [
      ...cases.map((one, i) => this.series([points[i]], style(one))), ...bars,
      ...(law?.curve ? [this.series(law.curve, {colour: INK, width: 1.6})] : [])
    ];
  }
}
