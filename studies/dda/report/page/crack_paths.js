// Cracks through blocks: their paths over the blocks, and the table of their cuts.

/** The blocks as they were, and over them the lines along which cracks have grown. */
class CrackPathFigure {
  constructor(blocks, cracks, name) {
    Object.assign(this, {blocks, cracks, name, viewKept: null});
    this.canvas = element("canvas", {role: "img", "aria-label": "Paths of the cracks over the blocks"});
    this.stage = element("div", {class: "stage"}, this.canvas);
    this.draw = onceAFrame(() => this.paint());
    new Gestures(this.canvas, this.actions());
    new ResizeObserver(this.draw).observe(this.stage);
    const middle = () => [this.stage.clientWidth / 2, this.height / 2];
    this.figure = element(
        "figure", {id: "crack-paths"},
        element("div", {class: "toolbar"}, figureButtons(this.actions(), middle, () => this.vectors())), this.stage,
        element(
            "figcaption", {},
            "Undeformed blocks, cut ones in their parts at the end. A ring stands where a crack has begun, a dot where it " +
                "may have turned."));
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
    this.viewKept = view;
    this.draw();
  }

  paint() {
    const width = this.stage.clientWidth;
    if (width === 0) return;
    this.height = PicturePainter.heightOf(this.blocks, width);
    this.paintOn(new CanvasSurface(this.canvas, width, this.height), width);
  }

  paintOn(surface, width) {
    const options = {index: this.blocks.steps.length - 1, magnification: 0, field: "material", view: this.viewKept};
    const painter = new PicturePainter(this.blocks, options, {field: null, cracks: null, list: []});
    painter.paint(surface, width, this.height);
    this.view = painter.view;
    surface.clipped({x: 0, y: 0, width, height: this.height}, () => {
      this.cracks.forEach(({path}, i) => this.paintPath(surface, painter.onPicture(path.flat()), crackColour(i)));
    });
  }

  paintPath(surface, track, colour) {
    surface.tracks([track], {stroke: PAPER, width: 5});
    surface.tracks([track], {stroke: colour, width: 2.6});
    for (let i = 2; i < track.length; i += 2) surface.circle(track[i], track[i + 1], 2.6, {fill: colour});
    surface.circle(track[0], track[1], 5, {stroke: colour, width: 2, fill: PAPER});
  }

  vectors() {
    const width = this.stage.clientWidth;
    const surface = new SvgSurface(width, this.height);
    this.paintOn(surface, width);
    return {name: fileName(this.name, "crack-paths"), text: surface.document()};
  }
}

function crackColour(number) {
  return PALETTE[(number + 1) % PALETTE.length];
}

/** What is said of each crack: how long, how straight, why it goes no farther. */
function crackTable(cracks, lengthUnit) {
  const columns = [
    {
      title: "crack",
      text: (crack) => String(cracks.indexOf(crack)),
      element: (crack) =>
          element(
              "span", {}, element("i", {class: "dot", style: `background:${crackColour(cracks.indexOf(crack))}`}),
              String(cracks.indexOf(crack)))
    },
    {title: "from", text: ({path}) => placeText(path[0])},
    {title: "to", text: ({path}) => placeText(path[path.length - 1])},
    {title: withUnit("length", lengthUnit), isNumeric: true, text: ({length}) => formatNumber(length, 4)},
    {title: "mean turn [°]", isNumeric: true, text: ({mean_turn: turn}) => formatNumber(turn, 2)},
    {title: "ends at", text: ({ended}) => ended ?? "goes on"},
  ];
  return tableOf(columns, cracks);
}

/** A row per cut, as they came. */
function cutTable(cracks, lengthUnit, loadUnit) {
  const rows = cracks.flatMap(({cuts}, crack) => cuts.map((cut) => ({crack, ...cut})));
  const number = (title, unit, key, digits) => ({
    title: withUnit(title, unit),
    isNumeric: true,
    text: (cut) => formatNumber(cut[key], digits),
    value: (cut) => cut[key]
  });
  const columns = [
    {title: "crack", isNumeric: true, text: ({crack}) => String(crack), value: ({crack}) => crack},
    {title: "block", isNumeric: true, text: ({block}) => String(block), value: ({block}) => block},
    {title: "cut", text: ({side}) => (side === undefined ? "through it" : "along a side")},
    {title: "from", text: ({from}) => placeText(from)},
    {title: "to", text: ({to}) => placeText(to)},
    number("step", "", "step", 6),
    number("load", loadUnit, "load", 4),
    number("opening", lengthUnit, "opening", 3),
    number("sliding", lengthUnit, "sliding", 3),
    number("damage", "", "damage", 3),
  ];
  return folded(
      `${plural(rows.length, "cut")}: when the crack grew by it, and what it has come to at the end`,
      new SortableTable(columns, rows, () => "").element, rows.length <= 12);
}

function placeText([x, y]) {
  return `(${formatNumber(x, 4)}, ${formatNumber(y, 4)})`;
}
