#include "models/interface/coulomb.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

Friction coulomb_friction(const Sides& at, double slip, bool sliding, double m) {
  Friction out;
  if (m == 0 || !at.rub()) return out;
  const double limit = m * at.closing, trial = at.q.y() - slip;
  out.direction = trial < 0 ? -1 : 1;
  out.at_limit = std::abs(trial) >= limit * (1 - at_limit_from);
  out.slides = std::abs(trial) > limit * (1 + (sliding ? -at_limit_from : beyond_limit));
  out.elastic = std::abs(trial) > limit ? out.direction * limit : trial;
  out.gradient = out.slides ? Vec2(out.direction * m * at.per_normal, 0) : Vec2(0, 1);
  return out;
}

namespace {

/// The line of a step, seen by what slides in direction d.
struct SlideLine {
  Vec2 from, to;
  double slip, m, d;

  Vec2 change() const { return to - from; }
  double sheared(double x) const { return from.y() + x * change().y() - slip; }
  double pressure(double x) const { return -(from.x() + x * change().x()); }
  double excess(double x) const { return d * sheared(x) - m * pressure(x); }
  /// Where the sides part or meet, and the derivative of the excess there.
  double touching() const { return from.x() / (from.x() - to.x()); }
  Vec2 touching_gradient() const {
    const double x = touching();
    return {d * change().y() * x * x / from.x(), d * x};
  }
};

}  // namespace

LineSlide slide_on(const Vec2& at, double slip, double m) {
  LineSlide out;
  if (m == 0 || at.x() > 0) return out;
  const double direction = at.y() < slip ? -1 : 1;
  out.mean = -direction * m * at.x();
  out.gradient = -m * at.x() * Vec2(m, direction);
  return out;
}

LineSlide slide_along(const Vec2& from, const Vec2& to, double slip, double m) {
  LineSlide out;
  const bool opens = to.x() > 0, closes = from.x() > 0;
  if (m == 0 || (opens && from.x() >= 0) || (closes && to.x() >= 0)) return out;
  SlideLine line{from, to, slip, m, 1};
  const double begin = closes ? line.touching() : 0, end = opens ? line.touching() : 1;
  if (line.sheared(end) < 0) line.d = -1;
  const double reached = line.excess(end), before = line.excess(begin);
  if (reached <= std::max(before, 0.0)) return out;
  const Vec2 outward(m, line.d);
  Vec2 onset_pressure = -begin * Vec2(1, 0);
  double onset = begin;
  if (before < 0) {
    const double first = line.excess(0), rise = line.excess(1) - first;
    onset = -first / rise;
    onset_pressure = -onset * Vec2(1, 0) - line.change().x() * first / (rise * rise) * outward;
  } else if (closes) {
    onset_pressure.setZero();
  }
  const double slid = reached - std::max(before, 0.0);
  const double mean = 0.5 * (line.pressure(onset) + (opens ? 0 : line.pressure(1)));
  Vec2 slid_gradient = opens ? line.touching_gradient() : outward;
  if (closes && before > 0) slid_gradient -= line.touching_gradient();
  const Vec2 mean_gradient = 0.5 * (onset_pressure + (opens ? Vec2(0, 0) : Vec2(-1, 0)));
  out.energy = m * mean * slid;
  out.gradient = m * (mean * slid_gradient + slid * mean_gradient);
  out.mean = line.d * m * mean;
  out.mean_gradient = line.d * m * mean_gradient;
  return out;
}

LimitedSlide slide_under(const Course& limit, const Course& trial) {
  LimitedSlide out;
  const double d = trial.to < 0 ? -1 : 1;
  const double before = d * trial.from - limit.from, reached = d * trial.to - limit.to;
  const double slid = reached - std::max(before, 0.0);
  if (slid <= 0 || reached <= 0) return out;
  const double change = limit.to - limit.from, way = reached - before;
  const double onset = before < 0 ? -before / way : 0, per_reached = before < 0 ? before / (way * way) : 0;
  const double mean = 0.5 * (limit.from + onset * change + limit.to);
  const double along = mean + 0.5 * slid * change * per_reached;
  out.energy = mean * slid;
  out.per_trial = d * along;
  out.per_limit = 0.5 * slid * (1 + onset) - along;
  return out;
}

}  // namespace dda
