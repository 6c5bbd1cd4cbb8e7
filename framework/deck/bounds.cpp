#include "framework/deck/bounds.hpp"

#include <cmath>

#include "framework/deck/document/node.hpp"

namespace dda {

bool Bounds::contains(double x) const {
  return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
}

std::string Bounds::words() const {
  const auto text = [](double x) { return Node::number(x).text; };
  const std::string lower = std::isinf(low) ? "" : (low_open ? "above " : "at least ") + text(low);
  const std::string upper = std::isinf(high) ? "" : (high_open ? "below " : "at most ") + text(high);
  if (lower.empty() || upper.empty()) return lower + upper;
  if (!low_open && !high_open) return "between " + text(low) + " and " + text(high);
  return lower + " and " + upper;
}

Bounds any() { return {}; }
Bounds above(double low) { return {.low = low, .low_open = true}; }
Bounds at_least(double low) { return {.low = low}; }
Bounds below(double high) { return {.high = high, .high_open = true}; }
Bounds at_most(double high) { return {.high = high}; }
Bounds between(double low, double high) { return {.low = low, .high = high}; }
Bounds strictly_between(double low, double high) { return above(low) & below(high); }

Bounds operator&(const Bounds& a, const Bounds& b) {
  Bounds both = a;
  if (b.low > a.low || (b.low == a.low && b.low_open)) both.low = b.low, both.low_open = b.low_open;
  if (b.high < a.high || (b.high == a.high && b.high_open)) both.high = b.high, both.high_open = b.high_open;
  return both;
}

}  // namespace dda
