#pragma once

#include <limits>
#include <string>

namespace dda {

/// The interval that a number must lie in; each end open or closed.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  bool contains(double x) const;
  /// "above 0 and at most 1", "between 0 and 0.5", "" when everything is allowed.
  std::string words() const;
};

Bounds any();
Bounds above(double low);
Bounds at_least(double low);
Bounds below(double high);
Bounds at_most(double high);
Bounds between(double low, double high);           ///< ends included
Bounds strictly_between(double low, double high);  ///< ends excluded
/// Both at once: above(0) & at_most(1).
Bounds operator&(const Bounds& a, const Bounds& b);

}  // namespace dda
