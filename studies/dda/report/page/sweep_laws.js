// Laws through the numbers of a sweep, and their spread where cases repeat each other.

/** v = a + b u by least squares; null where all u are the same. */
function straightLine(u, v) {
  const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [middleU, middleV] = [mean(u), mean(v)];
  const square = u.reduce((sum, value) => sum + (value - middleU) ** 2, 0);
  if (!(square > 0)) return null;
  const b = u.reduce((sum, value, i) => sum + (value - middleU) * (v[i] - middleV), 0) / square;
  return {a: middleV - b * middleU, b};
}

/**
 * Each is a straight line in some coordinates; `of` gives the law at x and its parameters, null where it does not
 * hold.
 */
const SWEEP_LAWS = {
  power: {
    title: "power law",
    formula: "y = a xᵇ",
    of(x, y) {
      const line = straightLine(x.map(Math.log), y.map(Math.log));
      return line &&
          {at: (value) => Math.exp(line.a + line.b * Math.log(value)), told: {a: Math.exp(line.a), b: line.b}};
    }
  },
  // Bažant's, of nominal strengths y over sizes x.
  size: {
    title: "size effect law",
    formula: "y = B / √(1 + x/x₀)",
    of(x, y) {
      const line = straightLine(x, y.map((value) => 1 / value ** 2));
      if (!line || !(line.a > 0) || !(line.b > 0)) return null;
      const [strength, size] = [1 / Math.sqrt(line.a), line.a / line.b];
      return {at: (value) => strength / Math.sqrt(1 + value / size), told: {"B": strength, "x₀": size}};
    }
  }
};

/** A law through the points with positive numbers: its curve and words on it, or only words on why there is none. */
function fittedLaw(law, points) {
  const positive = points.filter(([x, y]) => x > 0 && y > 0);
  const [x, y] = [0, 1].map((axis) => positive.map((point) => point[axis]));
  const found = positive.length > 1 ? law.of(x, y) : null;
  if (!found) return {words: `${law.title}: none goes through these points.`};
  const off =
      Math.sqrt(positive.reduce((sum, [at, value]) => sum + (value / found.at(at) - 1) ** 2, 0) / positive.length);
  const [low, high] = [Math.min(...x), Math.max(...x)];
  const pieces = 60;
  const curve =
      Array.from({length: pieces + 1}, (_, i) => low * (high / low) ** (i / pieces)).map((at) => [at, found.at(at)]);
  const told = Object.entries(found.told).map(([name, value]) => `${name} = ${formatNumber(value, 5)}`).join(", ");
  return {
    curve,
    words: `${law.title} ${law.formula}: ${told}; ${positive.length} points, ${
        formatNumber(100 * off, 2)} % off on average.`
  };
}

/** Mean and standard deviation of y over the points of the same x, where there are several. */
function spreads(points) {
  const groups = new Map();
  for (const [x, y] of points)
    if (Number.isFinite(x) && Number.isFinite(y)) groups.set(x, [...(groups.get(x) ?? []), y]);
  return [...groups].filter(([, values]) => values.length > 1).map(([x, values]) => {
    const mean = values.reduce((sum, y) => sum + y, 0) / values.length;
    const square = values.reduce((sum, y) => sum + (y - mean) ** 2, 0) / (values.length - 1);
    return {x, mean, deviation: Math.sqrt(square), count: values.length};
  });
}
