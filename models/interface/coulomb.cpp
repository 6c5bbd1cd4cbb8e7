#include "models/interface/coulomb.hpp"

#include <cmath>

namespace dda {

Friction coulomb_friction(const Vec2& q, double slip, bool sliding, double m) {
  Friction out;
  if (m == 0 || q.x() > 0) return out;
  constexpr double round_off = 1e-11, surface = 1e-9;
  const double limit = -m * q.x(), trial = q.y() - slip;
  out.direction = trial < 0 ? -1 : 1;
  out.at_limit = std::abs(trial) >= limit * (1 - surface);
  out.slides = std::abs(trial) > limit * (1 + (sliding ? -round_off : round_off));
  out.elastic = out.slides ? out.direction * limit : trial;
  out.gradient = out.slides ? Vec2(-out.direction * m, 0) : Vec2(0, 1);
  return out;
}

SlidingTraction sliding_traction(double before, double now, double slipped, bool slid_before) {
  const bool on = before * slipped >= 0 && now * slipped >= 0;
  if (on && (slid_before || std::abs(now) < std::abs(before))) return {0.5 * (before + now), 0.5};
  if (now * slipped > 0) return {now, 1};
  return {};
}

}  // namespace dda
