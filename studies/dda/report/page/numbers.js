// Numbers and names as people read them.

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

function superscript(number) {
  return String(number).replace("-", "⁻").replace(/\d/g, (digit) => SUPERSCRIPTS[digit]);
}

/** A number with some significant digits, "−" for minus and a power of ten where it is shorter. */
function formatNumber(value, digits = 5) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits))).replace("-", "−");
  if (size >= 1e6 && Number.isInteger(value) && size < 1e9) return String(value).replace("-", "−");
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return `${String(Number(mantissa)).replace("-", "−")}·10${superscript(Number(exponent))}`;
}

function formatSeconds(seconds) {
  if (seconds < 120) return `${formatNumber(seconds, 3)} s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 120) return `${minutes} min ${Math.round(seconds % 60)} s`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** "2024-05-01T12:00:00.123Z" to "2024-05-01 12:00:00 UTC". */
function formatDate(text) {
  const match = /^(\d{4}-\d\d-\d\d)T(\d\d:\d\d:\d\d)/.exec(text ?? "");
  return match ? `${match[1]} ${match[2]} UTC` : text ?? "";
}

function withUnit(name, unit) {
  return unit ? `${name} [${unit}]` : name;
}

/** A name of the run's files in words: "limit_point" to "limit point". */
function words(name) {
  return String(name).replace(/_/g, " ");
}

function plural(count, one, many = `${one}s`) {
  return `${count} ${count === 1 ? one : many}`;
}

// Axes follow the rules of framework/figure/axis.cpp, with the same numbers; tests/report compares them.

function exponentOf(value) {
  return Math.floor(Math.log10(value) + STYLE.rounding);
}

/** The round step that gives about `wanted` intervals. */
function roundStep(length, wanted) {
  const rough = length / wanted;
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * (STYLE.roundDigits.find((digit) => rough <= digit * power * (1 + STYLE.rounding)) ?? 10);
}

/** The largest round number up to `value`. */
function roundDown(value) {
  const power = 10 ** exponentOf(value);
  return power * (STYLE.roundDigits.findLast((digit) => digit * power <= value) ?? 1);
}

/** Ticks of an axis: value and label, and the power of ten and offset taken out of the labels. */
function axisTicks([low, high], wanted) {
  const step = roundStep(high - low, wanted);
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const offset = largest / step > STYLE.mostSteps ? Math.ceil(low / step) * step : 0;
  const rest = Math.max(Math.abs(low - offset), Math.abs(high - offset));
  const power = exponentOf(rest);
  const exponent = power >= STYLE.largeExponent || power <= STYLE.smallExponent ? 3 * Math.floor(power / 3) : 0;
  const unit = 10 ** exponent;
  const decimals = Math.max(0, -exponentOf(step / unit));
  const ticks = [];
  const slack = STYLE.tickSlack * step;
  for (let n = Math.ceil((low - slack) / step); n * step <= high + slack; n += 1)
    ticks.push({value: n * step, label: tickLabel((n * step - offset) / unit, decimals)});
  const shift = offset === 0 ? "" : ` ${offset < 0 ? "−" : "+"} ${Number(Math.abs(offset).toPrecision(15))}`;
  return {ticks, scale: `${exponent === 0 ? "" : `×10${superscript(exponent)}`}${shift}`.trim()};
}

function tickLabel(value, decimals) {
  const text = value.toFixed(decimals);
  return /[1-9]/.test(text) ? text.replace("-", "−") : text.replace("-", "");
}

/** digit · 10^exponent, as long as that has few zeros in digits. */
function decadeLabel(digit, exponent) {
  if (exponent < STYLE.largeExponent && exponent > STYLE.smallExponent)
    return tickLabel(digit * 10 ** exponent, Math.max(0, -exponent));
  return `${digit === 1 ? "" : `${digit}·`}10${superscript(exponent)}`;
}

/** The first and the last whole number in a range. */
function wholeNumbers([low, high]) {
  return [Math.ceil(low - STYLE.rounding), Math.floor(high + STYLE.rounding)];
}

/** Ticks at digits of decades, minor ones where `label(digit, exponent)` is empty. */
function digitTicks(range, label) {
  const [first, last] = wholeNumbers(range);
  const ticks = [];
  for (let exponent = first - 1; exponent <= last; exponent += 1)
    for (let digit = 1; digit < 10; digit += 1) {
      const value = exponent + Math.log10(digit);
      if (value < range[0] - STYLE.rounding || value > range[1] + STYLE.rounding) continue;
      const text = label(digit, exponent);
      ticks.push({value, label: text, isMinor: text === ""});
    }
  return ticks;
}

/** The same of a logarithmic axis; its range and the values of its ticks are logarithms to the base of ten. */
function logarithmicTicks(range, wanted) {
  const [first, last] = wholeNumbers(range);
  const stride = Math.ceil((last - first + 1) / wanted);
  if (last > first) {
    const isMarked = (digit, exponent) => digit === 1 && exponent % stride === 0;
    const all = digitTicks(range, (digit, exponent) => (isMarked(digit, exponent) ? decadeLabel(digit, exponent) : ""));
    return {ticks: stride > 1 ? all.filter(({value}) => Number.isInteger(value)) : all, scale: ""};
  }
  const isRound = (digit) => STYLE.roundDigits.includes(digit);
  const ticks = digitTicks(range, (digit, exponent) => (isRound(digit) ? decadeLabel(digit, exponent) : ""));
  if (ticks.filter(({isMinor}) => !isMinor).length > 1) return {ticks, scale: ""};
  const even = axisTicks(range.map((end) => 10 ** end), wanted);
  return {...even, ticks: even.ticks.map(({value, label}) => ({value: Math.log10(value), label}))};
}
