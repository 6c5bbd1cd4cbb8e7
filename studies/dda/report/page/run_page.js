// The page of a run.

class RunPage {
  constructor(data) {
    this.data = data;
    this.summary = data.summary ?? {};
    this.log = data.log ? {...data.log, landed: data.log.steps.landed} : null;
    this.table = data.curve ? new Table(data.curve) : null;
    const hasRows = this.table && this.table.numRows > 0 && this.table.numericColumns().length > 1;
    this.curve = hasRows ? new Curve(this.table, data.summary, this.log) : null;
    this.blocks = data.blocks?.steps.length > 0 ? new Blocks(data.blocks, this.summary.torn_out) : null;
    this.figures = {};
  }

  elements() {
    return [
      ...this.top(), this.modelSection(), this.pathSection(), this.cracksSection(), this.stabilitySection(),
      this.energySection(), this.motionSection(), this.askedSection(), this.logSection(), this.timeSection(),
      this.provenanceSection()
    ].filter(Boolean);
  }

  top() {
    const {data} = this;
    return [
      element("p", {class: "over"}, `ddapath report · run ${data.name}`), element("h1", {}, data.title),
      statusLine(data), ...noticeLines([...(this.summary.notices ?? []), ...data.notices]), this.numbers()
    ];
  }

  /** The key numbers, those that the run has. */
  numbers() {
    const {summary: s} = this;
    const cards = element("dl", {class: "numbers", id: "numbers"});
    const card = (term, value, note) => value !== null && value !== undefined &&
        cards.append(element(
            "div", {}, element("dt", {}, term), element("dd", {}, value, note ? element("small", {}, note) : null)));
    for (const peak of this.peakCards()) card(...peak);
    if (s.steps !== undefined)
      card("accepted steps", String(s.steps), s.rejected_steps ? `${s.rejected_steps} rejected` : "none rejected");
    else if (this.curve)
      card("rows of the curve", String(this.table.numAllRows));
    const iterations = (s.newton_iterations ?? 0) + (s.reduced_iterations ?? 0);
    if (s.steps > 0) card("iterations per step", formatNumber(iterations / s.steps, 2), `${iterations} in all`);
    if (s.energy_balance_error !== undefined)
      card("energy balance error", formatNumber(s.energy_balance_error, 2), "of the most work, at the end");
    if (s.blocks !== undefined) card("blocks", String(s.blocks), s.unknowns ? `${s.unknowns} unknowns` : null);
    if (s.crackable_points !== undefined)
      card("points that may crack", String(s.crackable_points), `of ${s.interface_points}`);
    if (s.rescues) card("rescues", String(s.rescues), "jumps at a held displacement");
    if (s.timings)
      card(
          "wall time", formatSeconds(s.timings.total),
          s.peak_memory_mib ? `${formatNumber(s.peak_memory_mib, 3)} MiB` : null);
    return cards;
  }

  peakCards() {
    const {peak} = this.summary;
    if (!peak || !this.curve) return this.highestSoFar();
    const unit = (name) => this.table.column(name)?.unit ?? "";
    const gauges = Object.entries(peak.gauges ?? {}).slice(0, 2);
    return [
      ["peak load", `${formatNumber(peak.load)} ${unit(COLUMN.load)}`, `step ${peak.step}`],
      ...gauges.map(([name, value]) => [`${words(name)} at the peak`, `${formatNumber(value, 4)} ${unit(name)}`])
    ];
  }

  /** Without a summary the highest load of the curve is told, as what it is. */
  highestSoFar() {
    const load = this.table?.numbers(COLUMN.load);
    if (!this.curve || !load) return [];
    const row = load.reduce((best, value, i) => (Math.abs(value) > Math.abs(load[best]) ? i : best), 0);
    return [["highest load so far", this.table.column(COLUMN.load).textAt(row), `step ${this.curve.steps[row]}`]];
  }

  /** What was asked: blocks, interfaces, supports, loads, gauges. */
  modelSection() {
    if (!this.data.model) return null;
    const {model, name} = this.data;
    const source = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(onScreen(model))}`;
    const picture =
        element("img", {id: "model-picture", src: source, alt: "Blocks, interfaces, supports, loads and gauges"});
    const buttons = savingButtons(() => ({name: fileName(name, "model"), text: model}));
    return section("model", "Model", element("div", {class: "toolbar"}, buttons),
                   element("div", {class: "scroll"}, picture));
  }

  motionSection() {
    const {motion} = this.data;
    if (!motion) return null;
    this.figures.motion =
        new MotionFigures({...motion, units: this.summary.units}, this.summary.motion, this.data.name);
    return this.figures.motion.section();
  }

  pathSection() {
    if (!this.curve && !this.blocks && this.data.motion) return null;
    if (!this.curve && !this.blocks) return section("path", "Path", element("p", {}, "Nothing has been recorded."));
    const figures = element("div", {class: "figures"});
    const shown = this.blocks ? new Choice(this.firstShown()) : null;
    if (this.curve) figures.append(this.curveFigure(shown).figure);
    if (this.blocks) {
      this.figures.deformed =
          new DeformedFigure(this.blocks, shown, {name: this.data.name, stepText: (step) => this.stepText(step)});
      figures.append(this.figures.deformed.figure);
    } else
      figures.append(element("p", {class: "quiet"}, this.whyNoBlocks()));
    return section("path", "Path", figures, this.curve ? eventTable(this.curve) : null);
  }

  /** Of cracks through blocks. */
  cracksSection() {
    const {cracks} = this.summary;
    if (!Array.isArray(cracks) || cracks.length === 0) return null;
    const unit = this.summary.units?.length ?? "";
    const loadUnit = this.table?.column(COLUMN.load)?.unit ?? "";
    if (this.blocks) this.figures.cracks = new CrackPathFigure(this.blocks, cracks, this.data.name);
    return section(
        "cracks", "Cracks through blocks", crackTable(cracks, unit),
        this.blocks ? element("div", {class: "figures"}, this.figures.cracks.figure) : null,
        cutTable(cracks, unit, loadUnit));
  }

  whyNoBlocks() {
    const stored = this.data.blocks?.stored ?? 0;
    return stored > 0 ?
        `The ${this.data.blocks.blocks} blocks are too many for a page of this size; ParaView reads run.xdmf.` :
        "No deformed state has been stored.";
  }

  /** The last of the stored steps shows the whole crack. */
  firstShown() {
    return this.blocks.steps.length - 1;
  }

  curveFigure(shown) {
    const notes = [
      "A point tells its step's data; a click shows the blocks at the nearest stored step.",
      "The ring marks the step of the picture."
    ];
    notes.push(this.curve.stabilityNote());
    if (this.table.numRows < this.table.numAllRows)
      notes.push(`${this.table.numRows} of ${this.table.numAllRows} steps are on this page, to keep it small.`);
    const steps = this.blocks?.steps.map(({step}) => step) ?? [];
    const figure = new CurveFigure(this.curve, this.data.name, {
      onPick: (step) => shown?.set(nearestRow(steps, step)),
      note: (shown ? notes : notes.slice(2)).join(" "),
    });
    this.figures.curve = figure;
    if (shown) {
      shown.listen((index) => figure.mark(steps[index]));
      figure.mark(steps[shown.value]);
    }
    return figure;
  }

  stepText(step) {
    if (!this.curve) return `step ${step}`;
    const row = this.curve.rowOfStep(step);
    const told = [COLUMN.load, this.curve.defaultAxis]
                     .map((name) => this.table.column(name))
                     .filter(Boolean)
                     .map((column) => `${words(column.name)} ${column.textAt(row)}`);
    const peak = this.summary.peak?.step === step ? " (peak)" : "";
    return `step ${step}${peak}: ${told.join(", ")}`;
  }

  stabilitySection() {
    if (!this.curve) return null;
    const columns = this.table.numericColumns();
    const groups = [
      [
        "ratios", "μ/μ₀",
        "Eigenvalues of the stiffness over those at the start, each followed by its shape: negative where it makes the " +
            "structure unstable."
      ],
      ["eigenvalues", "eigenvalue", "Lowest eigenvalues of the stiffness: negative where the structure is unstable."],
      [
        "stiffness", "current stiffness",
        "Stiffness along the path over that at the start: zero at a limit point, negative while the load falls and its " +
            "displacement grows, positive while both fall."
      ],
      [
        "counts", "negative eigenvalues",
        "How many eigenvalues of the stiffness are negative: under dead load, while the control holds what it prescribes, " +
            "and of its symmetric part, where friction or unequal strengths make it unsymmetric."
      ],
    ];
    const figures = groups.map(
        ([id, label, note]) =>
            this.stabilityFigure(columns.filter(({name}) => COLUMNS[id].test(name)), {id, label, note}));
    const drawn = figures.filter(Boolean);
    return drawn.length === 0 ? null : section("stability", "Stability", element("div", {class: "figures"}, drawn));
  }

  stabilityFigure(columns, {id, label, note}) {
    if (columns.length === 0) return null;
    const lines = columns.map((column) => ({name: symbolOf(column.name), values: column.numbers}));
    return new LinesFigure(
               this.curve, lines, {id, name: this.data.name, yLabel: withUnit(label, columns[0].unit), note})
        .figure;
  }

  energySection() {
    const [work, stored, dissipated] =
        [COLUMN.work, COLUMN.stored, COLUMN.dissipated].map((name) => this.table?.numbers(name));
    if (!this.curve || !work || !stored || !dissipated) return null;
    const jumps = this.jumps();
    const lines = [["external work", work], ["stored", stored], ["dissipated", dissipated]].map(
        ([name, values]) => ({name, values}));
    if (jumps.some((value) => value !== 0)) lines.push({name: "released in jumps", values: jumps});
    const largest = Math.max(...rangeOf([work]).map(Math.abs)) || 1;
    const error = work.map(
        (value, row) =>
            (value - work[0] - (stored[row] - stored[0]) - (dissipated[row] - dissipated[0]) - jumps[row]) / largest);
    const unit = this.table.column(COLUMN.work).unit;
    return section(
        "energy", "Energy balance",
        element(
            "p", {class: "quiet"},
            "Work and energies are integrated apart, so their difference tells how well the path was followed."),
        element(
            "div", {class: "figures"},
            new LinesFigure(this.curve, lines, {id: "energies", name: this.data.name, yLabel: withUnit("energy", unit)})
                .figure,
            new LinesFigure(this.curve, [{name: "error", values: error}], {
              id: "balance",
              name: this.data.name,
              yLabel: "error / largest work",
              note: "Work less stored, dissipated and released energy, over the largest work."
            }).figure));
  }

  /** Energy released in jumps up to each row, which the log books step by step. */
  jumps() {
    const jumps = new Float64Array(this.table.numRows);
    if (!this.log) return jumps;
    const [steps, energies] =
        [this.log.steps.step, this.log.steps.jump_energy].map((text) => decoded(text, Float64Array));
    steps.forEach((step, i) => {
      if (energies[i] !== 0)
        for (let row = 0; row < jumps.length; row += 1)
          if (this.curve.steps[row] >= step) jumps[row] += energies[i];
    });
    return jumps;
  }

  askedSection() {
    const {deck, effective_deck: effective, overrides} = this.data;
    if (!deck && !effective) return null;
    return section(
        "asked", "What was asked",
        overrides.length > 0 ?
            [
              element("h3", {}, "Overrides of the command"),
              element("ul", {}, overrides.map((text) => element("li", {}, element("code", {}, `--set ${text}`))))
            ] :
            null,
        element("h3", {}, "Assumptions and comments of the deck"), commentList(deck),
        deck ? folded("The deck as given", deckText(deck)) : null,
        effective ?
            folded("The effective deck: every parameter, defaults and overrides included", deckText(effective)) :
            null);
  }

  logSection() {
    if (!this.log) return null;
    const {counts, events, left_out: leftOut} = this.log;
    const told = Object.entries(counts).map(([event, count]) => `${words(event)} ${count}`).join(" · ");
    const columns = [
      {title: "time", text: ({time}) => formatDate(time).slice(11, 19)},
      {title: "step", isNumeric: true, text: ({step}) => String(step ?? "")},
      {title: "event", text: ({event, level}) => (level === "info" ? words(event) : `${level}: ${words(event)}`)},
      {title: "what was said", className: "message", text: (event) => messageOf(event)},
    ];
    const isBad = ({level}) => (level === "info" ? "" : "failed");
    const list = events.length > 0 ? tableOf(columns, events, isBad) : element("p", {class: "quiet"}, "None.");
    return section(
        "events", "Warnings, rescues and other events", element("p", {}, told || "None."),
        events.length > 12 ?
            folded(`All ${events.length}${leftOut ? ` first of ${events.length + leftOut}` : ""}`, list) :
                                                    list);
  }

  timeSection() {
    const {timings, profile} = this.summary;
    if (!timings) return null;
    const phases = Array.isArray(profile) ? profile :
                                            Object.entries(timings)
                                                .filter(([name]) => name !== "total" && name !== "start_up")
                                                .map(([phase, seconds]) => ({phase, seconds}));
    const sorted = [...phases].sort((one, other) => other.seconds - one.seconds);
    const longest = sorted[0]?.seconds || 1;
    const columns = [
      {title: "phase", text: ({phase}) => phase},
      {title: "time [s]", isNumeric: true, text: ({seconds}) => seconds.toFixed(3)},
      {
        title: "",
        text: () => "",
        element: ({seconds}) =>
            element("span", {class: "bar", style: `width:${Math.max(0.5, (110 * seconds) / longest)}px`})
      },
      {title: "calls", isNumeric: true, text: ({calls}) => String(calls ?? "")},
      {
        title: "work that was not needed",
        text: ({skipped, skipped_what: what}) => (skipped ? `${skipped} ${what ?? ""}` : "")
      },
    ];
    return section(
        "time", "Time",
        element(
            "p", {},
            `${formatSeconds(timings.total)} in all` +
                `${timings.start_up ? `, ${formatSeconds(timings.start_up)} of it before the deck was read` : ""}.` +
                " A phase does not count what is inside it."),
        folded("By phase", tableOf(columns, sorted), true));
  }

  provenanceSection() {
    const {provenance = {}, generator} = this.data;
    const {units = {}} = this.summary;
    return section("provenance", "Provenance", facts([
                     ["program", this.summary.version ?? provenance.version],
                     ["compiled by", provenance.compiler],
                     ["machine", provenance.host],
                     ["units", Object.entries(units).map(([what, unit]) => `${what} ${unit}`).join(", ")],
                     ["started", formatDate(this.log?.started)],
                     ["last entry of the log", formatDate(this.log?.last)],
                     ["this page", `made by ddapath ${generator.version}, ${formatDate(generator.date)}`],
                   ]));
  }
}

/** "mu_2" as μ₂, "mu_ratio_1" as μ₁ ratio. */
function symbolOf(name) {
  const ratio = COLUMNS.ratios.exec(name);
  const match = ratio ?? COLUMNS.eigenvalues.exec(name);
  if (!match) return words(name);
  const subscript = match[1].replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);
  return `μ${subscript}${ratio ? " ratio" : ""}`;
}

/** What a line of the log says beside its time, level, event and step. */
function messageOf(event) {
  const known = new Set(["time", "level", "event", "step", "text"]);
  const rest =
      Object.entries(event).filter(([key, value]) => !known.has(key) && !(Array.isArray(value) && value.length === 0));
  const told =
      rest.map(([key, value]) => `${words(key)}: ${typeof value === "string" ? value : JSON.stringify(value)}`);
  return [event.text, ...told].filter(Boolean).join("; ");
}
