#include "continuation/state/reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dda {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The opening along the ray, less κ.
struct ExcessAlong {
  const LawAt& point;
  const Vec2& a;
  const Vec2& b;
  double kappa;

  double value(double x) const { return point.opening(a + x * b) - kappa; }
  double slope(double x) const { return point.gradient(a + x * b).dot(b); }
};

/// The last root in (low, high), where the excess is positive at `high`.
double last_root(const ExcessAlong& excess, double low, double high) {
  double x = high;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double value = excess.value(x), slope = excess.slope(x);
    (value > 0 ? high : low) = x;
    double next = slope > 0 ? x - value / slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - x) <= 2e-16 * x || next == low || next == high) return next;
    x = next;
  }
  return x;
}

/// A place on the last stretch where the opening is beyond κ; infinite when it stays below.
double beyond(const ExcessAlong& excess, double from) {
  double x = from + 1;
  const double speed = excess.point.opening(excess.b);
  if (speed > 0) x = from + 2 * excess.kappa / speed;
  for (int doubling = 0; doubling < 60; ++doubling, x *= 2) {
    if (excess.value(x) > 0) return x;
    if (doubling > 4 && excess.slope(x) <= 0) break;
  }
  return never;
}

}  // namespace

double reach(const LawAt& point, const Vec2& a, const Vec2& b) {
  const ExcessAlong excess{point, a, b, point.kappa()};
  if (b.isZero(0) || !std::isfinite(excess.kappa)) return never;
  std::array<double, 3> ends{never, never, never};
  for (int i = 0; i < 2; ++i)
    if (const double x = -a[i] / b[i]; b[i] != 0 && x > 0) ends[static_cast<std::size_t>(i)] = x;
  std::ranges::sort(ends);
  double start = 0;
  for (const double end : ends) {
    const double to = std::isfinite(end) ? end : beyond(excess, start);
    if (!std::isfinite(to)) return never;
    const bool from_below = excess.value(start) < 0 || excess.slope(start) < 0;
    if (to > start && from_below && excess.value(to) > 0) {
      constexpr double round_off = 1e-9;  // an opening that only dips towards κ from above has no root
      const double root = last_root(excess, start, to);
      if (std::abs(excess.value(root)) <= round_off * excess.kappa) return root;
    }
    if (!std::isfinite(end)) return never;
    start = end;
  }
  return never;
}

double share_to_kappa(const LawAt& point, const Vec2& from, const Vec2& to, double round_off) {
  if (point.law.is_broken(point.history, point.stiffness)) return 1;
  if (point.opening(to) <= point.kappa() * (1 + round_off)) return 1;
  return std::min(1.0, reach(point, from, to - from));
}

}  // namespace dda
