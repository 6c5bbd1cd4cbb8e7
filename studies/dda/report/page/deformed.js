// The figure of the deformed blocks with its slider.

class DeformedFigure {
  /**
   * shown: the Choice of the place in the list of stored steps. isTrue: displacements are shown as large as they are.
   */
  constructor(blocks, shown, {name, stepText, id = "deformed", isTrue = false}) {
    Object.assign(this, {blocks, shown, name, stepText, id, isTrue});
    this.automatic = isTrue ? 1 : this.automaticMagnification();
    const cracks = isTrue ? "none" : "opening";
    this.options = {magnification: this.automatic, field: "material", cracks, everyStep: true, view: null};
    this.canvas =
        element("canvas", {role: "img", tabindex: 0, "aria-label": "Deformed blocks and cracks at the chosen step"});
    this.stage = element("div", {class: "stage"}, this.canvas);
    this.draw = onceAFrame(() => this.paint());
    this.rangesKept = new Map();
    new Gestures(this.canvas, this.actions());
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(this.draw).observe(this.stage);
    shown.listen(() => this.changed());
    this.figure = element("figure", {id}, this.toolbar(), this.stage, this.player(), this.caption());
    this.changed();
  }

  /** Makes the largest displacement about 5 % of the structure. */
  automaticMagnification() {
    const largest = this.blocks.largestDisplacement();
    return largest > 0 ? roundDown((0.05 * this.blocks.box.size) / largest) : 1;
  }

  actions() {
    return {
      zoom: (factor, x, y) => {
        const {view} = this;
        this.setView({scale: view.scale * factor, x: x + (view.x - x) * factor, y: y + (view.y - y) * factor});
      },
      pan: (dx, dy) => this.setView({...this.view, x: this.view.x + dx, y: this.view.y + dy}),
      reset: () => this.setView(null),
    };
  }

  setView(view) {
    this.options.view = view;
    this.draw();
  }

  set(option, value) {
    this.options[option] = value;
    this.changed();
  }

  toolbar() {
    const fields = Object.entries(BLOCK_FIELDS).map(([key, {text}]) => [key, text]);
    const middle = () => [this.stage.clientWidth / 2, this.height / 2];
    const ofCracks = [
      chooser(
          "cracks by", [["opening", "opening"], ["sliding", "sliding"], ["damage", "damage"], ["none", "not shown"]],
          "opening", (value) => this.set("cracks", value)),
      this.blocks.stressUnit ? chooser("blocks by", fields, "material", (value) => this.set("field", value)) : null,
      checkbox("one scale for all steps", true, (value) => this.set("everyStep", value)),
    ];
    return element(
        "div", {class: "toolbar"}, this.isTrue ? null : ofCracks,
        figureButtons(this.actions(), middle, () => this.vectors()));
  }

  player() {
    const last = this.blocks.steps.length - 1;
    this.slider = element("input", {
      type: "range",
      id: this.id === "deformed" ? "step-slider" : `${this.id}-slider`,
      min: 0,
      max: last,
      step: 1,
      value: this.shown.value,
      "aria-label": "Stored step",
      input: () => this.shown.set(Number(this.slider.value))
    });
    this.play = button("▶", "Play the stored steps", () => this.toggle());
    this.told = element("output", {id: this.id === "deformed" ? "step-shown" : `${this.id}-shown`});
    return element("div", {class: "player"}, this.play, this.slider, this.magnifier(), this.told);
  }

  /** 0, then round numbers around the automatic one. */
  magnifier() {
    const from = Math.floor(Math.log10(this.automatic)) - 2;
    const series = Array.from({length: 5}, (_, i) => STYLE.roundDigits.map((digit) => digit * 10 ** (from + i))).flat();
    const texts = [[0, "none"], ...series.map((value) => [value, `× ${formatNumber(value)}`])];
    const chosen = series.find((value) => Math.abs(value / this.automatic - 1) < 1e-6) ?? 0;
    return chooser(
        "displacements", texts.map(([value, text]) => [String(value), text]), String(chosen),
        (value) => this.set("magnification", Number(value)));
  }

  caption() {
    const {steps, numStored, numBlocks} = this.blocks;
    const thinned = steps.length < numStored ?
        ` ${steps.length} of the ${numStored} stored steps are on this page, to keep it small.` :
        "";
    this.note = element(
        "span", {hidden: true},
        " The half percent of the blocks with the highest and the lowest stress has the colour of the scale's end.");
    this.materials = materialLegend(this.blocks);
    return element(
        "figcaption", {}, this.materials, `${plural(numBlocks, "block")}. Wheel or two fingers: closer; drag: move.${thinned}`,
        this.isTrue ? "" : " Thin lines: cracks whose jump is too small to be seen.",
        this.blocks.tornOut.length > 0 ? " Red: torn out." : "", this.note);
  }

  /** Each play starts anew at the first step when it has come to the end. */
  toggle() {
    if (this.timer) return this.stop();
    const last = this.blocks.steps.length - 1;
    if (this.shown.value === last) this.shown.set(0);
    this.play.textContent = "❚❚";
    const seconds = Math.min(0.7, Math.max(0.12, 6 / (last + 1)));
    this.timer = setInterval(
        () => (this.shown.value < last ? this.shown.set(this.shown.value + 1) : this.stop()), 1000 * seconds);
    return undefined;
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
    this.play.textContent = "▶";
  }

  changed() {
    const {step} = this.blocks.steps[this.shown.value];
    this.slider.value = this.shown.value;
    this.slider.setAttribute("aria-valuetext", `step ${step}`);
    this.told.textContent = this.stepText(step);
    this.note.hidden = this.options.field === "material";
    this.materials.hidden = !this.note.hidden;
    this.draw();
  }

  current() {
    return {...this.options, index: this.shown.value};
  }

  scales() {
    const {field, cracks, everyStep} = this.options;
    const key = [field, cracks, everyStep || this.shown.value].join(" ");
    if (!this.rangesKept.has(key)) this.rangesKept.set(key, scalesOf(this.blocks, this.current()));
    return this.rangesKept.get(key);
  }

  paint() {
    const width = this.stage.clientWidth;
    if (width === 0) return;
    const scales = this.scales();
    this.height = PicturePainter.heightOf(this.blocks, width);
    const painter = new PicturePainter(this.blocks, this.current(), scales);
    painter.paint(
        new CanvasSurface(this.canvas, width, this.height + PicturePainter.barHeight(scales.list)), width, this.height);
    this.view = painter.view;
    this.canvas.dataset.step = this.blocks.steps[this.shown.value].step;
  }

  key(event) {
    const middle = [this.stage.clientWidth / 2, this.height / 2];
    if (event.key === "+")
      this.actions().zoom(1.5, ...middle);
    else if (event.key === "-")
      this.actions().zoom(1 / 1.5, ...middle);
    else if (event.key === "0")
      this.setView(null);
    else if (event.key === "ArrowRight")
      this.shown.set(Math.min(this.shown.value + 1, this.blocks.steps.length - 1));
    else if (event.key === "ArrowLeft")
      this.shown.set(Math.max(this.shown.value - 1, 0));
    else
      return;
    event.preventDefault();
  }

  vectors() {
    const width = this.stage.clientWidth;
    const scales = this.scales();
    const surface = new SvgSurface(width, this.height + PicturePainter.barHeight(scales.list));
    new PicturePainter(this.blocks, this.current(), scales).paint(surface, width, this.height);
    return {name: fileName(this.name, this.id, this.blocks.steps[this.shown.value].step), text: surface.document()};
  }
}

/** Which colour is which material, where there are several. */
function materialLegend({materials}) {
  const out = legend(materials.length > 1 ? materials.map((name, i) => [name, tintOf(i)]) : []);
  out.classList.add("materials");
  return out;
}
