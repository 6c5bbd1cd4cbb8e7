// Draws a plot on a surface: axes, curves, marks.

const PLOT_ROOM = {
  left: 64,
  right: 14,
  top: 22,
  bottom: 44
};

/** From values to the picture and back. */
class PlotFrame {
  constructor(width, height, x, y) {
    this.x = PLOT_ROOM.left;
    this.y = PLOT_ROOM.top;
    this.width = width - PLOT_ROOM.left - PLOT_ROOM.right;
    this.height = height - PLOT_ROOM.top - PLOT_ROOM.bottom;
    this.rangeX = x;
    this.rangeY = y;
  }

  toX(value) {
    return this.x + (this.width * (value - this.rangeX[0])) / (this.rangeX[1] - this.rangeX[0]);
  }

  toY(value) {
    return this.y + this.height - (this.height * (value - this.rangeY[0])) / (this.rangeY[1] - this.rangeY[0]);
  }

  valueX(place) {
    return this.rangeX[0] + ((place - this.x) / this.width) * (this.rangeX[1] - this.rangeX[0]);
  }

  valueY(place) {
    return this.rangeY[0] + ((this.y + this.height - place) / this.height) * (this.rangeY[1] - this.rangeY[0]);
  }

  holds(x, y) {
    return x >= this.x - 1 && x <= this.x + this.width + 1 && y >= this.y - 1 && y <= this.y + this.height + 1;
  }
}

/** series: {x, y, colour, width, kindOf(i), dots, starts: point i to where the part before it begins}; marks: {x, y, label, fill}; cursor: {x, y} or null; isLogarithmic: all
 * places are logarithms to the base of ten. */
class PlotPainter {
  constructor(surface, frame, content) {
    this.surface = surface;
    this.frame = frame;
    this.content = content;
  }

  paint() {
    this.axes();
    const inside = {x: this.frame.x, y: this.frame.y, width: this.frame.width, height: this.frame.height};
    this.surface.clipped(inside, () => this.content.series.forEach((series) => this.curve(series)));
    this.marks();
    this.cursor();
  }

  ticks(range, wanted) {
    return (this.content.isLogarithmic ? logarithmicTicks : axisTicks)(range, Math.max(2, Math.floor(wanted)));
  }

  axes() {
    const {frame, surface} = this;
    const across = this.ticks(frame.rangeX, frame.width / 85);
    const up = this.ticks(frame.rangeY, frame.height / 48);
    const [right, bottom] = [frame.x + frame.width, frame.y + frame.height];
    const [ofX, ofY] = [across, up].map(({ticks}) => ticks.filter(({isMinor}) => !isMinor));
    surface.tracks(
        ofX.map(({value}) => [frame.toX(value), frame.y, frame.toX(value), bottom]), {stroke: FAINT, width: 0.8});
    surface.tracks(
        ofY.map(({value}) => [frame.x, frame.toY(value), right, frame.toY(value)]), {stroke: FAINT, width: 0.8});
    if (!this.content.isLogarithmic) this.zeroLines(right, bottom);
    this.minorTicks(across.ticks, up.ticks, bottom);
    surface.tracks([[frame.x, frame.y, right, frame.y, right, bottom, frame.x, bottom]], {stroke: INK, closed: true});
    for (const {value, label} of ofX) surface.text(frame.toX(value), bottom + 15, label, {anchor: "middle"});
    for (const {value, label} of ofY) surface.text(frame.x - 6, frame.toY(value) + 4, label, {anchor: "end"});
    surface.text(frame.x + frame.width / 2, bottom + 34, this.content.xLabel, {size: 12, anchor: "middle"});
    surface.text(14, frame.y + frame.height / 2, this.content.yLabel, {size: 12, anchor: "middle", rotate: -90});
    surface.text(right, bottom + 28, across.scale, {anchor: "end"});
    surface.text(frame.x, frame.y - 7, up.scale);
  }

  /** Short lines at the left and the lower side. */
  minorTicks(across, up, bottom) {
    const {frame} = this;
    const length = STYLE.minorTick;
    const places = (ticks, to) => ticks.filter(({isMinor}) => isMinor).map(({value}) => to(value));
    this.surface.tracks(
        [
          ...places(across, (value) => frame.toX(value)).map((x) => [x, bottom, x, bottom - length]),
          ...places(up, (value) => frame.toY(value)).map((y) => [frame.x, y, frame.x + length, y])
        ],
        {stroke: INK, width: 0.8});
  }

  zeroLines(right, bottom) {
    const {frame} = this;
    const lines = [];
    if (frame.rangeX[0] < 0 && frame.rangeX[1] > 0) lines.push([frame.toX(0), frame.y, frame.toX(0), bottom]);
    if (frame.rangeY[0] < 0 && frame.rangeY[1] > 0) lines.push([frame.x, frame.toY(0), right, frame.toY(0)]);
    this.surface.tracks(lines, {stroke: GREY, width: 0.8});
  }

  curve(series) {
    if (!series.onlyDots)
      STYLE.stability.forEach(({colour, dash}, kind) => {
        const stroke = PALETTE[colour] ?? series.colour;
        this.surface.tracks(this.pieces(series, kind), {stroke, width: series.width ?? 1.8, dash});
      });
    if (series.dots) this.dots(series);
  }

  /** Runs of finite points, as far as they are of one kind; the part of the curve before a point has a kind. */
  pieces(series, kind) {
    const tracks = [];
    let track = [];
    const end = () => {
      if (track.length > 0) tracks.push(track);
      track = [];
    };
    for (let i = 1; i < series.x.length; i += 1) {
      const start = series.starts?.get(i);
      const fits = isPoint(series, i - 1) && isPoint(series, i) && (series.kindOf?.(i) ?? 0) === kind;
      if (start || !fits) end();
      if (!fits) continue;
      const {x, y} = start ?? {x: series.x[i - 1], y: series.y[i - 1]};
      if (track.length === 0) track.push(this.frame.toX(x), this.frame.toY(y));
      track.push(this.frame.toX(series.x[i]), this.frame.toY(series.y[i]));
    }
    end();
    return tracks;
  }

  dots(series) {
    const radius = series.onlyDots ? 4 : 1.9;
    for (let i = 0; i < series.x.length; i += 1)
      if (isPoint(series, i))
        this.surface.circle(this.frame.toX(series.x[i]), this.frame.toY(series.y[i]), radius, {fill: series.colour});
  }

  marks() {
    const taken = [];
    const shown = (this.content.marks ?? [])
                      .map(({x, y, label, fill}) => ({x: this.frame.toX(x), y: this.frame.toY(y), label, fill}))
                      .filter(({x, y}) => Number.isFinite(x + y) && this.frame.holds(x, y));
    for (const {x, y, fill} of shown) this.surface.circle(x, y, 4.5, {stroke: INK, fill: fill ?? PAPER, width: 1.5});
    // A mark is worse to write over than a piece of a curve.
    const weight = 20;
    const places = shown.flatMap(({x, y}) => Array.from({length: weight}, () => [x, y]));
    const curves = shown.length > 0 ? [...this.samples(), ...places] : [];
    for (const {x, y, label} of shown)
      if (label) this.label(x, y, label, {taken, curves});
  }

  /** Places on the curves, close enough to each other that no label slips between. */
  samples() {
    const places = [];
    const apart = 5;
    for (const series of this.content.series)
      for (const track of STYLE.stability.flatMap((_, kind) => this.pieces(series, kind)))
        for (let i = 2; i < track.length && places.length < 20000; i += 2) {
          const [dx, dy] = [track[i] - track[i - 2], track[i + 1] - track[i - 1]];
          const count = Math.min(300, Math.ceil(Math.hypot(dx, dy) / apart));
          for (let k = 0; k <= count; k += 1)
            places.push([track[i - 2] + (dx * k) / count, track[i - 1] + (dy * k) / count]);
        }
    return places;
  }

  /** Beside its mark, where no other label is and least of the curves; left out where there is no room. */
  label(px, py, text, {taken, curves}) {
    const width = 6.4 * text.length;
    const offsets = [[9, -8], [9, 16], [-9, -8], [-9, 16], [9, -24], [9, 32], [-9, -24], [-9, 32], [24, 4], [-24, 4]];
    const boxes =
        offsets.map(([dx, dy]) => ({left: dx > 0 ? px + dx : px + dx - width, base: py + dy, width, isRight: dx > 0}));
    const touches = (box, [x, y]) =>
        x > box.left - 3 && x < box.left + width + 3 && y > box.base - 12 && y < box.base + 5;
    const isFree = (box) => this.frame.holds(box.left, box.base - 10) &&
        this.frame.holds(box.left + width, box.base + 3) &&
        !taken.some(
            (other) => Math.abs(other.base - box.base) < 13 && box.left < other.left + other.width &&
                other.left < box.left + width);
    const crossings = (box) => curves.filter((place) => touches(box, place)).length;
    const [best] = boxes.filter(isFree)
                       .map((box) => ({...box, crossings: crossings(box)}))
                       .sort((one, other) => one.crossings - other.crossings);
    if (!best) return;
    taken.push(best);
    this.surface.text(
        best.isRight ? best.left : best.left + width, best.base, text, {anchor: best.isRight ? "start" : "end"});
  }

  cursor() {
    const {cursor} = this.content;
    if (!cursor) return;
    const [px, py] = [this.frame.toX(cursor.x), this.frame.toY(cursor.y)];
    if (Number.isFinite(px + py) && this.frame.holds(px, py))
      this.surface.circle(px, py, 6, {stroke: PALETTE[1], width: 2.4});
  }
}

function isPoint(series, i) {
  return Number.isFinite(series.x[i]) && Number.isFinite(series.y[i]);
}

/** A range a little wider than its values, never empty. */
function widened([low, high]) {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const around = largest ? STYLE.halfOfNoLength * largest : 1;
  const room = high - low > STYLE.leastLength * largest ? STYLE.axisMargin * (high - low) : around;
  return [low - room, high + room];
}
