// Colours that also colour-blind readers tell apart; they come with the page, from framework/figure.

const {palette: PALETTE, ink: INK, grey: GREY, faint: FAINT} = STYLE;

/** Shapes of one step of colour are drawn as one. */
const COLOUR_STEPS = STYLE.maps.viridis.length;

/** The step of colour at `part` in 0 to 1, clamped. */
function colourStep(part) {
  return Math.min(COLOUR_STEPS - 1, Math.max(0, Math.floor(part * COLOUR_STEPS)));
}

/** Values and what they look like. */
class ColourScale {
  constructor(map, range, label) {
    this.label = label;
    this.range = range[0] === range[1] ? [range[0], range[0] + (Math.abs(range[0]) || 1)] : range;
    this.colours = STYLE.maps[map];
  }

  /** Symmetric about zero, so that its middle colour means none. */
  static signed([low, high], label) {
    const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
    return new ColourScale("signed", [-size, size], label);
  }

  binOf(value) {
    return colourStep((value - this.range[0]) / (this.range[1] - this.range[0]));
  }

  colourOfBin(bin) {
    return this.colours[bin];
  }
}
