// The data of the page: arrays out of base64, and a table of columns.

/** Columns of curve.csv that the page knows, and those of which there are several. */
const COLUMN = {
  step: "step",
  control: "control",
  iterations: "newton_iterations",
  load: "load",
  loadFactor: "load_factor",
  stage: "stage",
  work: "external_work",
  stored: "stored_energy",
  dissipated: "dissipated_energy",
  stiffness: "current_stiffness",
  lowest: "mu_1",
};
const COLUMNS = {
  eigenvalues: /^mu_(\d+)$/,
  ratios: /^mu_ratio_(\d+)$/,
  stiffness: /^current_stiffness$/,
  counts: /^negative_/
};

/** The bytes of a base64 text as an array of the given type. */
function decoded(text, ArrayType) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; i += 1) bytes[i] = characters.charCodeAt(i);
  return new ArrayType(bytes.buffer);
}

/** Numbers that were stored as 16-bit integers and a scale. */
function dequantised({scale, integers}) {
  const stored = decoded(integers, Int16Array);
  const values = new Float32Array(stored.length);
  for (let i = 0; i < stored.length; i += 1) values[i] = stored[i] * scale;
  return values;
}

/** A column of a table: its numbers, or its texts. */
class Column {
  constructor({name, unit, numbers, singles, texts}) {
    this.name = name;
    this.unit = unit ?? "";
    this.texts = texts ?? null;
    this.numbers = null;
    if (numbers !== undefined) this.numbers = decoded(numbers, Float64Array);
    if (singles !== undefined) this.numbers = decoded(singles, Float32Array);
  }

  get isNumeric() {
    return this.numbers !== null && this.numbers.some(Number.isFinite);
  }

  /** Name and unit as they stand at an axis. */
  get label() {
    return withUnit(words(this.name), this.unit);
  }

  /** A cell in words, unit included. */
  textAt(row) {
    if (this.texts) return this.texts[row];
    const number = formatNumber(this.numbers[row]);
    return this.unit ? `${number} ${this.unit}` : number;
  }
}

/** A table read from a CSV file, by columns. */
class Table {
  constructor({columns, rows, all_rows, stability}) {
    this.columns = columns.map((column) => new Column(column));
    this.numRows = rows ?? this.columns[0]?.numbers?.length ?? 0;
    this.numAllRows = all_rows ?? this.numRows;
    /** Which of STYLE.stability the parts between the rows of a run's curve are; its last, where nobody knows. */
    this.stability = stability ?? [];
  }

  column(name) {
    return this.columns.find((column) => column.name === name);
  }

  numbers(name) {
    return this.column(name)?.numbers ?? null;
  }

  numericColumns() {
    return this.columns.filter((column) => column.isNumeric);
  }
}

/** The row whose value is nearest to the wanted one. */
function nearestRow(values, wanted) {
  let best = 0;
  for (let row = 1; row < values.length; row += 1)
    if (Math.abs(values[row] - wanted) < Math.abs(values[best] - wanted)) best = row;
  return best;
}

/** Smallest and largest finite value of several arrays; [0, 1] when there is none. */
function rangeOf(arrays) {
  let low = Infinity;
  let high = -Infinity;
  for (const values of arrays)
    for (const value of values) {
      if (!Number.isFinite(value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  return low > high ? [0, 1] : [low, high];
}

/** Range of all but the outermost part of the values: a few blocks under a point load would take all colours. */
function innerRange(values, outermost = 0.005) {
  const sorted = Float32Array.from(values).sort();
  const last = sorted.length - 1;
  return last < 0 ? [0, 1] : [sorted[Math.floor(outermost * last)], sorted[Math.ceil((1 - outermost) * last)]];
}

/** Tells its listeners about one chosen number, such as the stored step that is shown. */
class Choice {
  constructor(value) {
    this.value = value;
    this.listeners = [];
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  set(value) {
    if (value === this.value) return;
    this.value = value;
    for (const listener of this.listeners) listener(value);
  }
}
