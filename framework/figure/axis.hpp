#pragma once

#include <string>
#include <vector>

namespace dda::svg {

/// An interval that grows to hold every finite number it is shown.
struct Range {
  double low = 0, high = 0;
  bool empty = true;

  void include(double value);
  /// Wider by `part` of its length at both ends; a range of no length becomes one around its value.
  Range widened(double part) const;
};

/// A number on an axis and what is written there; nothing is at a minor one.
struct Tick {
  double value;
  std::string label;
  bool is_minor = false;
};

/// Round numbers across a range, and the factor or offset taken out of their labels.
///
///     value = offset + label · 10^exponent,    scale = "×10⁻⁶" or "+ 1000000" or ""
///
/// Steps are 1, 2 or 5 times a power of ten. The page of `dda report` has the same rules in numbers.js.
struct Axis {
  Range range;
  std::vector<Tick> ticks;
  std::string scale;
};

/// The largest round number up to a positive value.
double round_down(double value);

/// About `wanted` ticks on a range that is not empty.
Axis make_axis(const Range& range, int wanted);

/// A logarithmic axis: `range` and the values of its ticks are logarithms to the base of ten, labels are numbers. Decades have
/// labels, at most about `wanted` of them, and the digits 2 to 9 between them minor ticks; below two decades 2 and 5 have
/// labels as well, and where no two of these are in the range round numbers as `make_axis` has them.
Axis make_logarithmic_axis(const Range& range, int wanted);

}  // namespace dda::svg
