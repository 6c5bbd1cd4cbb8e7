// The picture of the deformed blocks: what is drawn where, in which colours.

/**
 * Options: index, magnification, field, cracks ("opening", "sliding" or "damage"), everyStep (one scale), view (or
 * null).
 */
class PicturePainter {
  constructor(blocks, options, scales) {
    this.blocks = blocks;
    this.options = options;
    this.scales = scales;
  }

  /** Height of the picture without the colour bars [px]. */
  static heightOf(blocks, width) {
    const {x, y} = blocks.box;
    const wanted = ((width - 20) * (y[1] - y[0])) / Math.max(x[1] - x[0], 1e-300);
    return Math.min(470, Math.max(150, 1.12 * wanted + 34));
  }

  static barHeight(scales) {
    return scales.length > 0 ? 52 : 0;
  }

  /** Equal scale in both directions, y upwards; the undeformed box with some room fits. */
  static viewOf(blocks, width, height) {
    const {x, y} = blocks.box;
    const scale =
        Math.min((0.92 * width) / Math.max(x[1] - x[0], 1e-300), (0.86 * height) / Math.max(y[1] - y[0], 1e-300));
    return {scale, x: width / 2 - (scale * (x[0] + x[1])) / 2, y: height / 2 + (scale * (y[0] + y[1])) / 2};
  }

  paint(surface, width, height) {
    this.view = this.options.view ?? PicturePainter.viewOf(this.blocks, width, height);
    const moved =
        this.blocks.movedOutlines(this.options.index, this.options.magnification, (places) => this.onPicture(places));
    surface.clipped({x: 0, y: 0, width, height}, () => {
      this.paintBlocks(surface, moved, width, height);
      this.paintCracks(surface);
      this.paintTornOut(surface, moved);
    });
    this.scales.list.forEach(
        (scale, i) =>
            paintBar(surface, scale, {x: 14 + (i * width) / 2, y: height + 6, width: Math.min(250, width / 2 - 28)}));
  }

  onPicture(places) {
    const {view} = this;
    return places.map((value, i) => (i % 2 === 0 ? view.x + view.scale * value : view.y - view.scale * value));
  }

  paintBlocks(surface, moved, width, height) {
    const bins = this.blocksByColour(moved, width, height);
    const edge = this.edge();
    if (!edge && surface.smallPolygons) {
      surface.smallPolygons(bins, width, height);
      return;
    }
    // Without an edge of its own a block shows a hairline of white around it.
    for (const [fill, outlines] of bins)
      surface.tracks(outlines, {fill, closed: true, width: 0.5, stroke: edge ?? fill});
  }

  /** What has been torn out under a load or a support has a red outline. */
  paintTornOut(surface, moved) {
    const isTornOut = new Set(this.blocks.tornOut);
    const outlines = moved.filter(({block}) => isTornOut.has(block)).map(({outline}) => outline);
    if (outlines.length > 0) surface.tracks(outlines, {stroke: STYLE.markOutline, width: 2.4, closed: true});
  }

  /** Outlines of the blocks that are in view. */
  blocksByColour(moved, width, height) {
    const {blocks, scales} = this;
    const values = scales.field ? blocks.field(this.options.index, this.options.field) : null;
    const bins = new Map();
    for (const {block, outline} of moved) {
      if (!isInView(outline, width, height)) continue;
      const fill = values ? scales.field.colourOfBin(scales.field.binOf(values[block])) : blocks.tintOf(block);
      if (!bins.has(fill)) bins.set(fill, []);
      bins.get(fill).push(outline);
    }
    return bins;
  }

  /** Colour of the blocks' edges, null where they are too small to have one. */
  edge() {
    const {blocks, view} = this;
    const area = (blocks.box.x[1] - blocks.box.x[0]) * (blocks.box.y[1] - blocks.box.y[0]);
    const side = view.scale * Math.sqrt(area / Math.max(1, blocks.numBlocks));
    if (side < 4) return null;
    return this.scales.field ? "rgba(0,0,0,0.13)" : SCREEN.edge;
  }

  paintCracks(surface) {
    const {blocks, options, scales} = this;
    if (!scales.cracks) return;
    const ends = this.onPicture(blocks.crackEnds(options.index, options.magnification));
    const values = blocks.ofCracks(options.index, options.cracks);
    const isWide = this.areWide();
    const bins = new Map();
    values.forEach((value, p) => {
      const bin = scales.cracks.binOf(value);
      if (!bins.has(bin)) bins.set(bin, {wide: [], hair: []});
      bins.get(bin)[isWide[p] ? "wide" : "hair"].push(ends.subarray(4 * p, 4 * p + 4));
    });
    // The widest are drawn last, on top.
    const sorted = [...bins].sort(([one], [other]) => one - other);
    // A pale edge keeps a crack visible on blocks of its own colour.
    if (scales.field) sorted.forEach(([, {wide}]) => surface.tracks(wide, {stroke: PAPER, width: 4.2}));
    for (const [bin, {wide, hair}] of sorted) {
      const stroke = scales.cracks.colourOfBin(bin);
      surface.tracks(hair, {stroke, width: 0.9});
      surface.tracks(wide, {stroke, width: 2.4});
    }
  }

  /** Of each crack whether its jump, magnified, is large enough to be seen; the others are hairlines. */
  areWide() {
    const {blocks, options: {index, magnification}} = this;
    const [opening, sliding] = ["opening", "sliding"].map((name) => blocks.ofCracks(index, name));
    const least = STYLE.hairline * blocks.box.size;
    return Array.from(opening, (value, p) => magnification * Math.hypot(value, sliding[p]) >= least);
  }
}

/** Whether the box around a track meets the picture. */
function isInView(track, width, height) {
  let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < track.length; i += 2) {
    left = Math.min(left, track[i]);
    right = Math.max(right, track[i]);
    top = Math.min(top, track[i + 1]);
    bottom = Math.max(bottom, track[i + 1]);
  }
  return right >= 0 && left <= width && bottom >= 0 && top <= height;
}

/** A horizontal colour bar with numbers and unit. */
function paintBar(surface, scale, {x, y, width}) {
  const height = 9;
  const slice = width / COLOUR_STEPS;
  for (let bin = 0; bin < COLOUR_STEPS; bin += 1) {
    const [left, right] = [x + bin * slice, Math.min(x + width, x + (bin + 1) * slice + 0.6)];
    surface.tracks(
        [[left, y, right, y, right, y + height, left, y + height]], {fill: scale.colourOfBin(bin), closed: true});
  }
  surface.tracks([[x, y, x + width, y, x + width, y + height, x, y + height]], {stroke: INK, width: 0.8, closed: true});
  const {ticks, scale: power} = axisTicks(scale.range, Math.max(2, Math.floor(width / 48)));
  for (const {value, label} of ticks) {
    const place = x + (width * (value - scale.range[0])) / (scale.range[1] - scale.range[0]);
    surface.tracks([[place, y + height, place, y + height + 3]], {stroke: INK, width: 0.8});
    surface.text(place, y + height + 14, label, {size: 10.5, anchor: "middle"});
  }
  surface.text(x, y + height + 30, power ? `${scale.label}  ${power}` : scale.label);
}

/** The scales of a picture: `field` and `cracks`, null where nothing is coloured, and both as a list. */
function scalesOf(blocks, {index, field, cracks, everyStep}) {
  const over = (range) => (everyStep ? blocks.rangeOverSteps(range) : range(index));
  const scales = {field: null, cracks: null};
  if (blocks.field(index, field))
    scales.field = ColourScale.signed(
        over((i) => innerRange(blocks.field(i, field))), withUnit(BLOCK_FIELDS[field].label, blocks.stressUnit));
  if (cracks === "damage") scales.cracks = new ColourScale("crack", [0, 1], "damage of the interface");
  if (cracks === "opening" || cracks === "sliding")
    scales.cracks = new ColourScale(
        "crack", [0, over((i) => rangeOf([[0], blocks.ofCracks(i, cracks)]))[1]], withUnit(cracks, blocks.lengthUnit));
  scales.list = [scales.cracks, scales.field].filter(Boolean);
  return scales;
}
