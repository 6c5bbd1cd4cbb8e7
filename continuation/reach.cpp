#include "continuation/reach.hpp"

#include <cmath>
#include <limits>

namespace dda {

double reach(const InterfaceLaw& law, const Vec2& a, const Vec2& b, double kappa) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double speed = law.equivalent_opening(b);
  if (speed == 0 || !std::isfinite(kappa)) return never;
  // q_eq(a + x b) ≥ x q_eq(b) − q_eq(−a), so beyond this x the opening exceeds κ.
  double x = (kappa + law.equivalent_opening(-a) + law.equivalent_opening(a)) / speed;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vec2 q = a + x * b;
    const double excess = law.equivalent_opening(q) - kappa;
    const double slope = law.opening_gradient(q).dot(b);
    if (!(slope > 0)) return never;
    const double next = x - excess / slope;
    if (next <= 0) return never;
    if (std::abs(next - x) <= 1e-15 * x) return next;
    x = next;
  }
  return x;
}

}  // namespace dda
