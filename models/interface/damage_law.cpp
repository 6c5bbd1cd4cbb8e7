#include "models/interface/damage_law.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

double DamageLaw::equivalent_opening(const Vec2& q) const {
  return std::hypot(std::max(q.x(), 0.0), beta_ * q.y());
}

Vec2 DamageLaw::opening_gradient(const Vec2& q) const {
  const double opening = equivalent_opening(q);
  if (opening == 0) return Vec2::Zero();
  return Vec2(std::max(q.x(), 0.0), beta_ * beta_ * q.y()) / opening;
}

Response DamageLaw::secant(const Vec2& q, double kappa, double k) const {
  const double r = kappa > initial_kappa(k) ? strength(kappa, k) / kappa : k;
  Response out;
  out.tangent.diagonal() = Vec2(q.x() < 0 ? k : r, beta_ * beta_ * r);
  out.traction = out.tangent.diagonal().cwiseProduct(q);
  return out;
}

/// A point on its surface is loading when the path has chosen so: the flag decides within round-off of κ.
bool DamageLaw::is_loading(double opening, double kappa, bool flag) const {
  constexpr double round_off = 1e-11;
  return opening > kappa * (1 + (flag ? -round_off : round_off));
}

Response DamageLaw::respond(const Vec2& q, const History& h, double k) const {
  const double reached = std::max(h.kappa, initial_kappa(k));
  const double opening = equivalent_opening(q);
  if (!is_loading(opening, reached, h.loading)) return secant(q, std::max(reached, opening), k);
  const double kappa = std::max(opening, reached);
  Response out = secant(q, kappa, k);
  const double secant_slope = (strength_slope(kappa, k) - strength(kappa, k) / kappa) / kappa;
  const Vec2 e = opening_gradient(q);
  out.tangent += secant_slope * opening * e * e.transpose();
  return out;
}

Response DamageLaw::respond_frozen(const Vec2& q, const History& h, double k) const {
  return secant(q, std::max(h.kappa, initial_kappa(k)), k);
}

double DamageLaw::damage(double kappa, double k) const {
  return kappa > initial_kappa(k) ? 1 - strength(kappa, k) / (kappa * k) : 0;
}

}  // namespace dda
