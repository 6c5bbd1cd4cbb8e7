#include "continuation/state/residual_stiffness.hpp"

#include <algorithm>

namespace dda {

Vec2 residual_stiffness(const InterfacePoint& point) {
  constexpr double most = 10;
  return residual_share * std::min(1.0, most * point.spring_unit / point.stiffness) * point.trial_stiffness();
}

double residual_power(const Equilibrium& equilibrium, std::span<const Vec2> opening) {
  double sum = 0;
  for (std::size_t p = 0; p < opening.size(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    sum += point.weight * opening[p].cwiseAbs2().dot(residual_stiffness(point));
  }
  return sum;
}

}  // namespace dda
