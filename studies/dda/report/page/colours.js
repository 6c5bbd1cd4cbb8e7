// Colours that also colour-blind readers tell apart.

/** Okabe & Ito (2008), without its yellow, which is too light for a line on white. */
const PALETTE = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];
const INK = "#222222";
const GREY = "#808080";
const FAINT = "#e3e3e3";

const COLOUR_MAPS = {
  viridis: [
    [68, 1, 84], [71, 45, 123], [59, 82, 139], [44, 114, 142], [33, 145, 140], [40, 174, 128], [94, 201, 98],
    [173, 220, 48], [253, 231, 37]
  ],
  crack: [[255, 214, 90], [253, 162, 55], [236, 98, 38], [196, 30, 30], [110, 0, 20]],
  /** Violet for negative, white for none, green for positive numbers. */
  signed: [[88, 34, 130], [166, 130, 196], [246, 246, 246], [126, 186, 140], [10, 96, 60]],
};

/** The colour at `part` in 0 to 1, clamped. */
function colourAt(map, part) {
  const stops = COLOUR_MAPS[map];
  const place = Math.min(1, Math.max(0, part)) * (stops.length - 1);
  const first = Math.min(Math.floor(place), stops.length - 2);
  const weight = place - first;
  const mixed = stops[first].map((low, i) => Math.round(low + weight * (stops[first + 1][i] - low)));
  return `rgb(${mixed.join(",")})`;
}

/** Shapes of one step of colour are drawn as one. */
const COLOUR_STEPS = 64;

/** Values and what they look like. */
class ColourScale {
  constructor(map, range, label) {
    this.label = label;
    this.range = range[0] === range[1] ? [range[0], range[0] + (Math.abs(range[0]) || 1)] : range;
    this.colours = Array.from({length: COLOUR_STEPS}, (_, bin) => colourAt(map, (bin + 0.5) / COLOUR_STEPS));
  }

  /** Symmetric about zero, so that its middle colour means none. */
  static signed([low, high], label) {
    const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
    return new ColourScale("signed", [-size, size], label);
  }

  binOf(value) {
    const part = (value - this.range[0]) / (this.range[1] - this.range[0]);
    return Math.min(COLOUR_STEPS - 1, Math.max(0, Math.floor(part * COLOUR_STEPS)));
  }

  colourOfBin(bin) {
    return this.colours[bin];
  }
}
