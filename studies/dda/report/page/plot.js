// A plot on the page: zooms, tells about the point under the pointer, saves itself as SVG.

/**
 * options: name (of the saved file), label (for screen readers), height(width) [px],
 *   describe(series, i) → [[term, value], ...], pick(series, i).
 */
class Plot {
  constructor(options) {
    this.options = options;
    this.content = {series: [], marks: [], cursor: null, xLabel: "", yLabel: ""};
    this.hovered = null;
    this.view = null;
    this.canvas = element("canvas", {tabindex: 0, role: "img", "aria-label": options.label});
    this.box = element("div", {class: "data-box", hidden: true, "aria-live": "polite"});
    this.stage = element("div", {class: "stage"}, this.canvas, this.box);
    this.draw = onceAFrame(() => this.paint());
    new Gestures(this.canvas, this.actions());
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(this.draw).observe(this.stage);
  }

  actions() {
    return {
      zoom: (factor, x, y) => this.zoom(factor, x, y),
      pan: (dx, dy) => this.pan(dx, dy),
      reset: () => this.setView(null),
      point: (x, y) => this.hover(this.nearest(x, y)),
      pick: (x, y) => this.pick(this.nearest(x, y)),
      leave: () => this.hover(null),
    };
  }

  buttons() {
    const middle = () => [this.frame.x + this.frame.width / 2, this.frame.y + this.frame.height / 2];
    return figureButtons(this.actions(), middle, () => this.vectors());
  }

  /** Other curves or axes: everything is shown again. */
  show(content) {
    this.content = {...this.content, ...content};
    this.hover(null);
    this.setView(null);
  }

  setCursor(cursor) {
    this.content.cursor = cursor;
    this.draw();
  }

  setView(view) {
    this.view = view;
    this.draw();
  }

  frameOf(width, height) {
    const {series, marks} = this.content;
    // A point counts where both of its numbers are there.
    const starts = (one, axis) => [...(one.starts?.values() ?? [])].map((start) => start[axis]);
    const drawn = (one, axis) => [...one[axis].filter((_, i) => isPoint(one, i)), ...starts(one, axis)];
    const all = (axis) => widened(rangeOf([...series.map((one) => drawn(one, axis)), marks.map((mark) => mark[axis])]));
    const view = this.view ?? {x: all("x"), y: all("y")};
    return new PlotFrame(width, height, view.x, view.y);
  }

  paint() {
    const width = this.stage.clientWidth;
    if (width === 0) return;
    const height = this.options.height(width);
    this.frame = this.frameOf(width, height);
    new PlotPainter(new CanvasSurface(this.canvas, width, height), this.frame, this.contentWithHover()).paint();
  }

  contentWithHover() {
    if (!this.hovered) return this.content;
    const {series, i} = this.hovered;
    const dot = {x: [series.x[i]], y: [series.y[i]], colour: INK, onlyDots: true, dots: true};
    const line = this.content.series.length > 1 ? [{...series, width: 3}] : [];
    return {...this.content, series: [...this.content.series, ...line, dot]};
  }

  zoom(factor, x, y) {
    const about = (range, value) => range.map((end) => value + (end - value) / factor);
    this.setView(
        {x: about(this.frame.rangeX, this.frame.valueX(x)), y: about(this.frame.rangeY, this.frame.valueY(y))});
  }

  pan(dx, dy) {
    const {frame} = this;
    const moved = (range, by) => range.map((end) => end + by * (range[1] - range[0]));
    this.setView({x: moved(frame.rangeX, -dx / frame.width), y: moved(frame.rangeY, dy / frame.height)});
  }

  /** The point nearest to a place, null when none is near. */
  nearest(x, y) {
    let found = null;
    let best = 40 ** 2;
    for (const series of this.content.series)
      for (let i = 0; i < series.x.length; i += 1) {
        const distance = (this.frame.toX(series.x[i]) - x) ** 2 + (this.frame.toY(series.y[i]) - y) ** 2;
        if (!(distance < best)) continue;
        best = distance;
        found = {series, i};
      }
    return found;
  }

  pick(found) {
    this.hover(found);
    if (found) this.options.pick?.(found.series, found.i);
  }

  hover(found) {
    if (found?.series === this.hovered?.series && found?.i === this.hovered?.i) return;
    this.hovered = found;
    this.box.hidden = !found;
    if (found) this.tell(found);
    this.draw();
  }

  tell({series, i}) {
    const pairs = this.options.describe(series, i);
    this.box.replaceChildren(...pairs.flatMap(([term, value]) => [element("span", {}, term), element("b", {}, value)]));
    const [px, py] = [this.frame.toX(series.x[i]), this.frame.toY(series.y[i])];
    const [width, height] = [this.box.offsetWidth, this.box.offsetHeight];
    const left = px + 14 + width <= this.stage.clientWidth ? px + 14 : Math.max(0, px - 14 - width);
    this.box.style.left = `${left}px`;
    this.box.style.top = `${Math.max(0, Math.min(py - height / 2, this.canvas.clientHeight - height))}px`;
  }

  key(event) {
    const steps = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1};
    const middle = [this.frame.x + this.frame.width / 2, this.frame.y + this.frame.height / 2];
    if (event.key in steps)
      this.moveHover(steps[event.key]);
    else if (event.key === "Enter" && this.hovered)
      this.pick({...this.hovered});
    else if (event.key === "+")
      this.zoom(1.5, ...middle);
    else if (event.key === "-")
      this.zoom(1 / 1.5, ...middle);
    else if (event.key === "0")
      this.setView(null);
    else if (event.key === "Escape")
      this.hover(null);
    else
      return;
    event.preventDefault();
  }

  moveHover(by) {
    const series = this.hovered?.series ?? this.content.series[0];
    if (!series) return;
    const i = this.hovered ? this.hovered.i + by : 0;
    if (i >= 0 && i < series.x.length) this.hover({series, i});
  }

  vectors() {
    const [width, height] = [this.stage.clientWidth, this.options.height(this.stage.clientWidth)];
    const surface = new SvgSurface(width, height);
    new PlotPainter(surface, this.frameOf(width, height), {...this.content, cursor: null}).paint();
    return {name: fileName(this.options.name), text: surface.document()};
  }
}

/** Short names of coloured lines, for below a figure. */
function legend(entries) {
  return element(
      "span", {class: "legend"},
      entries.map(
          ([name, colour]) => element("span", {class: "entry"}, element("i", {style: `background:${colour}`}), name)));
}
