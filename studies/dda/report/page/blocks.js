// The blocks of a run: geometry, and where they are and what they feel at the stored steps.

/** Fields that blocks may show, each from the stress (xx, yy, xy). */
const BLOCK_FIELDS = {
  material: {text: "material"},
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
    this.materials = data.materials ?? [];
    this.materialOf = data.material_of ? decoded(data.material_of, Uint16Array) : null;
    this.tornOut = (tornOut ?? []).flatMap((piece) => piece.blocks);
    this.states = new Map();
    this.centres = centresOf(this.vertices, this.offsets);
    this.box = this.findBox();
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

  /**
   * Outlines where the magnified displacement puts them, each with its block: of blocks that cracks have cut those of
   * their parts. `place` puts an array of vertices somewhere else.
   */
  movedOutlines(index, magnification, place) {
    const {motion, parts} = this.state(index);
    const isCut = new Set(parts?.blocks ?? []);
    const whole = outlinesOf(this, place(movedVertices(this, motion, magnification)))
                      .map((outline, block) => ({block, outline}))
                      .filter(({block}) => !isCut.has(block));
    if (!parts) return whole;
    const ofParts = outlinesOf(parts, place(movedVertices(parts, parts.motion, magnification)));
    return [...whole, ...ofParts.map((outline, i) => ({block: parts.blocks[i], outline}))];
  }

  /** The colour of a block's material. */
  tintOf(block) {
    return this.materialOf ? tintOf(this.materialOf[block]) : SCREEN.block;
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

  /** Ends of the cracked pieces of interfaces, and of cracks through blocks: x, y, x, y for each. */
  crackEnds(index, magnification) {
    const {points, pieces, ends} = this.state(index);
    const placed = new Float32Array(ends.length);
    for (let i = 0; i < ends.length; i += 1) {
      const beyond = i - 4 * points.length;
      const from = beyond >= 0 ? pieces[beyond] : this.segments[4 * points[Math.floor(i / 4)] + (i % 4)];
      placed[i] = from + magnification * ends[i];
    }
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

/** Means of the vertices, about which the motion of an outline is given. */
function centresOf(vertices, offsets) {
  const centres = new Float64Array(2 * (offsets.length - 1));
  for (let b = 0; b + 1 < offsets.length; b += 1) {
    const count = offsets[b + 1] - offsets[b];
    for (let v = offsets[b]; v < offsets[b + 1]; v += 1) {
      centres[2 * b] += vertices[2 * v] / count;
      centres[2 * b + 1] += vertices[2 * v + 1] / count;
    }
  }
  return centres;
}

/** Every vertex of some outlines where the magnified displacement puts it. */
function movedVertices({vertices, offsets, centres}, {mean, gradient}, magnification) {
  const moved = new Float32Array(vertices.length);
  for (let b = 0; b + 1 < offsets.length; b += 1)
    for (let v = offsets[b]; v < offsets[b + 1]; v += 1) {
      const dx = vertices[2 * v] - centres[2 * b];
      const dy = vertices[2 * v + 1] - centres[2 * b + 1];
      const g = 4 * b;
      moved[2 * v] = vertices[2 * v] + magnification * (mean[2 * b] + gradient[g] * dx + gradient[g + 1] * dy);
      moved[2 * v + 1] =
          vertices[2 * v + 1] + magnification * (mean[2 * b + 1] + gradient[g + 2] * dx + gradient[g + 3] * dy);
    }
  return moved;
}

/** The vertices of each outline. */
function outlinesOf({offsets}, vertices) {
  return Array.from({length: offsets.length - 1}, (_, b) => vertices.subarray(2 * offsets[b], 2 * offsets[b + 1]));
}

function decodedMotion({mean, gradient}) {
  return {mean: dequantised(mean), gradient: dequantised(gradient)};
}

function decodedParts({blocks, counts, vertices: places, motion}) {
  const offsets = offsetsOf(decoded(counts, Uint16Array));
  const vertices = decoded(places, Float32Array);
  return {
    blocks: decoded(blocks, Uint32Array),
    offsets,
    vertices,
    centres: centresOf(vertices, offsets),
    motion: decodedMotion(motion)
  };
}

function decodedStep({motion, cracks, parts}) {
  return {
    motion: decodedMotion(motion),
    parts: parts ? decodedParts(parts) : null,
    points: cracks ? decoded(cracks.points, Uint32Array) : new Uint32Array(0),
    pieces: cracks ? decoded(cracks.pieces, Float32Array) : new Float32Array(0),
    ends: cracks ? dequantised(cracks.ends) : new Float32Array(0),
  };
}
