// Colours that also colour-blind readers tell apart; they come with the page, from framework/figure.

/** A colour "#rrggbb" with a part of another. */
function mixed(colour, other, part) {
  const bytes = [colour, other].map((text) => text.match(/[0-9a-f]{2}/gi).map((byte) => parseInt(byte, 16)));
  const mix = bytes[0].map((byte, i) => Math.round((1 - part) * byte + part * bytes[1][i]));
  return `#${mix.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}

/** What a figure stands on and is written with: on paper, and on a screen that the reader has set dark. */
const ON_PAPER = {
  paper: STYLE.paper,
  ink: STYLE.ink,
  grey: STYLE.grey,
  faint: STYLE.faint,
  block: STYLE.blockFill,
  edge: STYLE.blockEdge,
  black: STYLE.palette.at(-1),
  tints: STYLE.tints
};
const IN_THE_DARK = {
  paper: "#15181b",
  ink: "#e4e6e8",
  grey: "#8f9499",
  faint: "#2d3237",
  block: "#343a40",
  edge: "#646b72",
  black: "#f4f4f4"
};
IN_THE_DARK.tints =
    [...STYLE.palette.slice(0, -1), IN_THE_DARK.black].map((colour) => mixed(IN_THE_DARK.block, colour, 0.32));
const DARK_SCREEN = window.matchMedia("(prefers-color-scheme: dark)");
const SCREEN = DARK_SCREEN.matches ? IN_THE_DARK : ON_PAPER;
const {ink: INK, grey: GREY, faint: FAINT, paper: PAPER} = SCREEN;
const PALETTE = [...STYLE.palette.slice(0, -1), SCREEN.black];

/** Colours of some figures by those of the same things in others. */
function translation(from, to) {
  return new Map(Object.keys(from).flatMap((name) => [from[name]].flat().map((colour, i) => [colour, [to[name]].flat()[i]])));
}

const PAPER_COLOURS = translation(SCREEN, ON_PAPER);

/** What is most stands out most: the colours of cracks, from the pale to the dark on paper, are turned round in the dark. */
const CRACK_COLOURS = DARK_SCREEN.matches ? [...STYLE.maps.crack].reverse() : STYLE.maps.crack;
CRACK_COLOURS.forEach((colour, step) => PAPER_COLOURS.set(colour, STYLE.maps.crack[step]));

/** The part of the colours of numbers that stands out: on paper without the palest, on a dark screen without the darkest. */
const OF_NUMBERS = {paper: [0, 0.92], dark: [0.37, 1]};

/** A colour of the screen as it is on paper, to which figures are saved. */
function onPaper(colour) {
  return PAPER_COLOURS.get(colour) ?? colour;
}

/** A vector graphic that was made for paper in the colours of the screen. */
function onScreen(vectors) {
  const colours = translation(ON_PAPER, SCREEN);
  const picture = new DOMParser().parseFromString(vectors, "image/svg+xml");
  for (const one of picture.querySelectorAll("*"))
    for (const name of ["fill", "stroke"])
      if (colours.has(one.getAttribute(name))) one.setAttribute(name, colours.get(one.getAttribute(name)));
  return new XMLSerializer().serializeToString(picture);
}

/** The colour of the material at this place among those of a run: the same in all figures. */
function tintOf(material) {
  return SCREEN.tints[material % SCREEN.tints.length];
}

/** Shapes of one step of colour are drawn as one. */
const COLOUR_STEPS = STYLE.maps.viridis.length;

/** The step of colour at `part` in 0 to 1, clamped. */
function colourStep(part) {
  return Math.min(COLOUR_STEPS - 1, Math.max(0, Math.floor(part * COLOUR_STEPS)));
}

/** The colour of a number at `part` in 0 to 1 of all, and in PAPER_COLOURS the one that it has on paper. */
function colourOfNumber(part) {
  const at = ([low, high]) => STYLE.maps.viridis[colourStep(low + part * (high - low))];
  const [shown, saved] = [at(DARK_SCREEN.matches ? OF_NUMBERS.dark : OF_NUMBERS.paper), at(OF_NUMBERS.paper)];
  PAPER_COLOURS.set(shown, saved);
  return shown;
}

/** Values and what they look like. */
class ColourScale {
  constructor(map, range, label) {
    this.label = label;
    this.range = range[0] === range[1] ? [range[0], range[0] + (Math.abs(range[0]) || 1)] : range;
    this.colours = map === "crack" ? CRACK_COLOURS : STYLE.maps[map];
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
