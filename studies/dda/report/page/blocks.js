// The blocks of a run: geometry, and where they are and what they feel at the stored steps.

/** Fields that blocks may show, each from the stress (xx, yy, xy). */
const BLOCK_FIELDS = {
  none: {text: "none"},
  xx: {text: "stress σxx", label: "σxx", value: (xx) => xx},
  yy: {text: "stress σyy", label: "σyy", value: (xx, yy) => yy},
  xy: {text: "stress σxy", label: "σxy", value: (xx, yy, xy) => xy},
  first: {
    text: "largest principal stress σ₁",
    label: "σ₁",
    value: (xx, yy, xy) => (xx + yy) / 2 + Math.hypot((xx - yy) / 2, xy),
  },
  second: {
    text: "smallest principal stress σ₂",
    label: "σ₂",
    value: (xx, yy, xy) => (xx + yy) / 2 - Math.hypot((xx - yy) / 2, xy),
  },
};

class Blocks {
  /** tornOut: pieces of the summary, each with its blocks by number. */
  constructor(data, tornOut) {
    this.lengthUnit = data.length_unit;
    this.stressUnit = data.stress_unit ?? "";
    this.offsets = offsetsOf(decoded(data.counts, Uint16Array));
    this.vertices = decoded(data.vertices, Float32Array);
    this.segments = decoded(data.segments, Float32Array);
    this.numBlocks = this.offsets.length - 1;
    this.numStored = data.stored;
    this.steps = data.steps;
    this.tornOut = (tornOut ?? []).flatMap((piece) => piece.blocks);
    this.states = new Map();
    this.centres = this.findCentres();
    this.box = this.findBox();
  }

  /** Means of the vertices, about which the motion of a block is given. */
  findCentres() {
    const centres = new Float64Array(2 * this.numBlocks);
    for (let b = 0; b < this.numBlocks; b += 1) {
      const count = this.offsets[b + 1] - this.offsets[b];
      for (let v = this.offsets[b]; v < this.offsets[b + 1]; v += 1) {
        centres[2 * b] += this.vertices[2 * v] / count;
        centres[2 * b + 1] += this.vertices[2 * v + 1] / count;
      }
    }
    return centres;
  }

  findBox() {
    const x = rangeOf([this.vertices.filter((_, i) => i % 2 === 0)]);
    const y = rangeOf([this.vertices.filter((_, i) => i % 2 === 1)]);
    return {x, y, size: Math.hypot(x[1] - x[0], y[1] - y[0])};
  }

  /** How the step at this place of the list moves, decoded once. */
  state(index) {
    // A few are kept; all of a large run would fill the memory.
    const mostKept = 24;
    if (!this.states.has(index)) {
      if (this.states.size >= mostKept) this.states.delete(this.states.keys().next().value);
      this.states.set(index, decodedStep(this.steps[index]));
    }
    return this.states.get(index);
  }

  /** Every vertex where the magnified displacement puts it. */
  movedVertices(index, magnification) {
    const {mean, gradient} = this.state(index);
    const moved = new Float32Array(this.vertices.length);
    for (let b = 0; b < this.numBlocks; b += 1)
      for (let v = this.offsets[b]; v < this.offsets[b + 1]; v += 1) {
        const dx = this.vertices[2 * v] - this.centres[2 * b];
        const dy = this.vertices[2 * v + 1] - this.centres[2 * b + 1];
        const g = 4 * b;
        moved[2 * v] = this.vertices[2 * v] + magnification * (mean[2 * b] + gradient[g] * dx + gradient[g + 1] * dy);
        moved[2 * v + 1] =
            this.vertices[2 * v + 1] + magnification * (mean[2 * b + 1] + gradient[g + 2] * dx + gradient[g + 3] * dy);
      }
    return moved;
  }

  /** A field over the blocks, null when nothing is to be shown. */
  field(index, name) {
    const {value} = BLOCK_FIELDS[name];
    if (!value || !this.steps[index].stress) return null;
    const stress = dequantised(this.steps[index].stress);
    const values = new Float32Array(this.numBlocks);
    for (let b = 0; b < this.numBlocks; b += 1) values[b] = value(stress[3 * b], stress[3 * b + 1], stress[3 * b + 2]);
    return values;
  }

  /** What the cracked points of a step have: "opening", "sliding" or "damage". */
  ofCracks(index, name) {
    const {cracks} = this.steps[index];
    return cracks ? decoded(cracks[name], Float32Array) : new Float32Array(0);
  }

  /** Ends of the cracked pieces of interface: x, y, x, y for each. */
  crackEnds(index, magnification) {
    const {points, ends} = this.state(index);
    const placed = new Float32Array(4 * points.length);
    for (let p = 0; p < points.length; p += 1)
      for (let k = 0; k < 4; k += 1)
        placed[4 * p + k] = this.segments[4 * points[p] + k] + magnification * ends[4 * p + k];
    return placed;
  }

  /** What all of the ranges `range(index)` of the steps shown hold. */
  rangeOverSteps(range) {
    return rangeOf(this.steps.map((_, index) => range(index)));
  }

  /** Of a block's middle, over all steps shown. */
  largestDisplacement() {
    const largestInteger = 32767;
    return this.steps.reduce((largest, {motion}) => Math.max(largest, largestInteger * motion.mean.scale), 0);
  }
}

/** Where the vertices of each block begin, and where the last end. */
function offsetsOf(counts) {
  const offsets = new Uint32Array(counts.length + 1);
  for (let b = 0; b < counts.length; b += 1) offsets[b + 1] = offsets[b] + counts[b];
  return offsets;
}

function decodedStep({motion, cracks}) {
  return {
    mean: dequantised(motion.mean),
    gradient: dequantised(motion.gradient),
    points: cracks ? decoded(cracks.points, Uint32Array) : new Uint32Array(0),
    ends: cracks ? dequantised(cracks.ends) : new Float32Array(0),
  };
}
