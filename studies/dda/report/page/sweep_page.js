// The page of a sweep.

class SweepPage {
  constructor(data) {
    this.data = data;
    this.sweep = new Sweep(data);
    this.colourKey = this.sweep.keys[0] ?? "";
    this.chosen = new Choice(null);
  }

  elements() {
    return [
      ...this.top(), this.figures(), this.tableSection(), this.failures(), this.asked(), this.provenance()
    ].filter(Boolean);
  }

  top() {
    const {cases} = this.sweep;
    const good = cases.filter((one) => one.isGood).length;
    const counts = new Map();
    for (const {status} of cases) counts.set(status, (counts.get(status) ?? 0) + 1);
    const told = [...counts].map(([status, count]) => `${count} ${words(status)}`).join(", ");
    return [
      element("p", {class: "over"}, `ddapath report · sweep ${this.data.name}`), element("h1", {}, this.data.title),
      element(
          "p", {class: `status ${good === cases.length ? "good" : "warn"}`, id: "status"},
          element("b", {}, plural(cases.length, "case")), `: ${told || "none"}.`),
      ...noticeLines(this.data.notices)
    ];
  }

  figures() {
    const colourBy = this.sweep.keys.map((key) => [key, this.sweep.shortName(key)]);
    const choice = chooser("colour by", [...colourBy, ["", "nothing"]], this.colourKey, (key) => {
      this.colourKey = key;
      this.draw();
    });
    this.legend = element("p", {class: "quiet"});
    this.curves = this.curvePlot();
    this.scatter = this.scatterPlot();
    this.numbers = this.scatter ? new SweepScatter(this.sweep, this.scatter, () => this.draw()) : null;
    const out = section(
        "curves", "Curves and numbers", element("div", {class: "toolbar"}, choice), this.legend,
        element(
            "div", {class: "figures"},
            this.curves?.figure ?? element("p", {class: "quiet"}, "No case has a curve yet."),
            this.scatter?.figure ?? element("p", {class: "quiet"}, "The sweep has no table of numbers yet.")));
    this.chosen.listen(() => this.draw());
    this.draw();
    return out;
  }

  /** A plot with two choosers of its axes; `change` draws it anew. */
  axesPlot(columns, axes, options) {
    const plot = new Plot({
      ...options,
      height: (width) => Math.min(420, Math.max(260, 0.72 * width)),
      pick: (series) => this.chosen.set(series.case ?? null)
    });
    const names = columns.map(({name}) => [name, this.sweep.shortName(name)]);
    const choose = (axis) => (value) => {
      axes[axis] = value;
      this.draw();
    };
    const figure = element(
        "figure", {id: options.id},
        element(
            "div", {class: "toolbar"}, chooser("across", names, axes.x, choose("x")),
            chooser("up", names, axes.y, choose("y")), plot.buttons()),
        plot.stage, element("figcaption", {}, options.note));
    return {plot, figure, axes, columns};
  }

  curvePlot() {
    const columns = this.sweep.curveColumns();
    if (columns.length < 2) return null;
    const gauge = columns.find(({name}) => !Sweep.axes.includes(name)) ?? columns[1];
    const up = columns.find(({name}) => name === COLUMN.load) ?? columns[0];
    return this.axesPlot(columns, {x: gauge.name, y: up.name}, {
      id: "overlay",
      name: fileName(this.data.name, "curves"),
      label: "Curves of all cases",
      note: "One curve per case; a click marks its row in the table.",
      describe: (series, i) =>
          [...this.settingsOf(series.case),
           ...series.case.curve.columns.filter(({isNumeric}) => isNumeric)
               .map((column) => [words(column.name), column.textAt(i)])]
    });
  }

  scatterPlot() {
    const columns = this.sweep.numericColumns();
    if (columns.length < 2) return null;
    const varied = this.sweep.keys.find((key) => columns.some(({name}) => name === key));
    const peak = columns.find(({name}) => name === "peak.load") ?? columns[1];
    return this.axesPlot(columns, {x: varied ?? columns[0].name, y: peak.name}, {
      id: "scatter",
      name: fileName(this.data.name, "scatter"),
      label: "A number of each case against another",
      note: "One point per case; any column of sweep.csv against any other.",
      describe: (series, i) => (series.case ? this.numbersOf(series.case) : this.placeOf(series, i))
    });
  }

  numbersOf(one) {
    const named =
        Object.values(this.scatter.axes).map((name) => [this.sweep.shortName(name), this.cellText(one, name)]);
    return [...this.settingsOf(one), ...named];
  }

  /** Of what is no case: a law, a spread. */
  placeOf(series, i) {
    return ["x", "y"].map((axis) => [this.numbers.label(axis), formatNumber(this.numbers.numberAt(series[axis][i]))]);
  }

  settingsOf(one) {
    return [
      ["case", String(one.number)],
      ...this.sweep.keys.map((key) => [this.sweep.shortName(key), textOf(one.setting(key))])
    ];
  }

  cellText(one, name) {
    const column = this.sweep.table.column(name);
    return column && one.row >= 0 ? column.textAt(one.row) : textOf(one.cell(name) ?? "–");
  }

  draw() {
    const {colour, entries} = this.sweep.colouring(this.colourKey);
    this.legend.replaceChildren(legend(entries));
    this.drawCurves(colour);
    this.drawScatter(colour);
    this.markRow();
  }

  drawCurves(colour) {
    if (!this.curves) return;
    const {axes, columns, plot} = this.curves;
    const series = this.sweep.cases.filter(({curve}) => curve?.column(axes.x)?.numbers && curve.column(axes.y)?.numbers)
                       .map((one) => ({
                              case: one,
                              x: one.curve.numbers(axes.x),
                              y: one.curve.numbers(axes.y),
                              colour: colour(one),
                              width: one === this.chosen.value ? 3.6 : 1.4
                            }));
    const label = (name) => withUnit(this.sweep.shortName(name), columns.find((column) => column.name === name).unit);
    this.showIn(plot, {xLabel: label(axes.x), yLabel: label(axes.y)}, series);
  }

  drawScatter(colour) {
    if (!this.scatter) return;
    const {value} = this.chosen;
    const {numbers, scatter: {plot}} = this;
    const {isLogarithmic} = numbers;
    this.showIn(
        plot, {xLabel: numbers.label("x"), yLabel: numbers.label("y"), isLogarithmic}, numbers.content(colour, value));
    plot.setCursor(value && value.row >= 0 ? numbers.place(value) : null);
  }

  /** The view is kept while the axes stay. */
  showIn(plot, labels, series) {
    const sameAxes = Object.entries(labels).every(([name, value]) => plot.content[name] === value);
    const view = sameAxes ? plot.view : null;
    plot.show({series, ...labels});
    plot.setView(view);
  }

  tableSection() {
    this.tableHost = element("div", {id: "cases"});
    const all = checkbox("all columns", false, (isAll) => this.fillTable(isAll));
    const out = section(
        "cases-section", "Cases",
        element(
            "div", {class: "toolbar"}, all,
            element("span", {class: "quiet"}, "A click on a column's head sorts by it.")),
        this.tableHost);
    this.fillTable(false);
    return out;
  }

  fillTable(isAll) {
    const isUsual = ({name}) =>
        /^(peak\.load$|peak\.gauges\.|steps$|blocks$|energy_balance_error$|timings\.total$)/.test(name);
    const known = new Set(["case", "folder", "status", "exit_code", "reason", ...this.sweep.keys]);
    const more =
        (this.sweep.table?.columns ?? []).filter((column) => !known.has(column.name) && (isAll || isUsual(column)));
    const columns = [
      {
        title: "case",
        isNumeric: true,
        text: (one) => String(one.number),
        value: (one) => Number(one.number),
        element: (one) => linkOf(one)
      },
      ...this.sweep.keys.map((key) => ({
                               title: this.sweep.title(key),
                               isNumeric: this.sweep.valuesOf(key).every(Number.isFinite),
                               text: (one) => textOf(one.setting(key)),
                               value: (one) => one.setting(key)
                             })),
      {title: "status", className: "status-cell", text: (one) => words(one.status)},
      ...more.map((column) => ({
                    title: this.sweep.title(column.name),
                    isNumeric: column.isNumeric,
                    text: (one) => numberOrText(one.cell(column.name)),
                    value: (one) => one.cell(column.name)
                  })),
    ];
    this.caseTable = new SortableTable(
        columns, this.sweep.cases,
        (one) => `${one.isGood ? "" : "failed"} ${one === this.chosen.value ? "chosen" : ""}`.trim());
    this.tableHost.replaceChildren(this.caseTable.element);
  }

  markRow() {
    this.caseTable?.fill();
  }

  failures() {
    const failed = this.sweep.cases.filter((one) => !one.isGood);
    if (failed.length === 0) return null;
    const columns = [
      {title: "case", isNumeric: true, text: (one) => String(one.number), element: (one) => linkOf(one)},
      {
        title: "settings",
        text: (one) =>
            this.sweep.keys.map((key) => `${this.sweep.shortName(key)} = ${textOf(one.setting(key))}`).join(", ")
      },
      {title: "status", className: "status-cell", text: (one) => words(one.status)},
      {title: "exit code", isNumeric: true, text: (one) => String(one.entry.exit_code ?? one.cell("exit_code") ?? "")},
      {
        title: "reason",
        className: "message",
        text: (one) => [one.reason, ...(one.entry.notices ?? [])].filter(Boolean).join("; ") ||
            "not known: the case has not ended"
      },
    ];
    return section("failures", "Cases that did not reach their goal", tableOf(columns, failed));
  }

  asked() {
    const {deck, overrides} = this.data;
    const varied = this.sweep.keys.map(
        (key) => element("li", {}, element("code", {}, key), ` over ${listed(this.sweep.valuesOf(key))}`));
    return section(
        "asked", "What was asked", varied.length > 0 ? [element("h3", {}, "Varied"), element("ul", {}, varied)] : null,
        overrides?.length > 0 ?
            [
              element("h3", {}, "Overrides of the command"),
              element("ul", {}, overrides.map((text) => element("li", {}, element("code", {}, `--set ${text}`))))
            ] :
            null,
        deck ?
            [
              element("h3", {}, "Assumptions and comments of the sweep"), commentList(deck),
              folded("sweep.yaml", deckText(deck))
            ] :
            null);
  }

  provenance() {
    const {generator, units} = this.data;
    const versions = [...new Set(this.sweep.table?.column("version")?.texts ?? [])].filter(Boolean);
    return section("provenance", "Provenance", facts([
                     ["cases run by", versions.join(", ")],
                     ["units", Object.entries(units ?? {}).map(([what, unit]) => `${what} ${unit}`).join(", ")],
                     ["this page", `made by ddapath ${generator.version}, ${formatDate(generator.date)}`]
                   ]));
  }
}

/** The number of a case, as a link to its own folder or report where there is one. */
function linkOf(one) {
  return one.entry.link ? element("a", {href: one.entry.link}, String(one.number)) : String(one.number);
}

function numberOrText(value) {
  return typeof value === "number" ? formatNumber(value) : String(value ?? "");
}

/** Values in a row, those in the middle left out where they are many. */
function listed(values) {
  const most = 12;
  const texts = values.map(textOf);
  return texts.length <= most ?
      texts.join(", ") :
      `${texts.slice(0, most - 2).join(", ")}, … ${texts[texts.length - 1]} (${texts.length} values)`;
}
