#pragma once

#include <cmath>

#include "models/interface_point.hpp"

namespace dda {

/// Left of the strength of a point, 1 intact.
inline double strength_left(const InterfacePoint& point, const History& h) {
  if (!point.law->can_crack() || !std::isfinite(point.law->initial_kappa(point.stiffness))) return 1;
  const double kappa = point.law->kappa(h, point.stiffness) / point.law->initial_kappa(point.stiffness);
  return (1 - point.law->damage(h, point.stiffness)) * kappa;
}

/// Whether it bears a tenth of its strength yet; one that does not holds no piece and lets bodies turn.
inline bool holds_still(const InterfacePoint& point, const History& h) {
  return strength_left(point, h) >= 0.1;
}

}  // namespace dda
