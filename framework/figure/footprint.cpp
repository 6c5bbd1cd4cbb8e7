#include "framework/figure/footprint.hpp"

#include <algorithm>
#include <utility>

namespace dda::svg {
namespace {

constexpr double meeting = 6;  ///< of a way, from the anchor, where others may meet it [px]

/// The way without what is near its anchor, if that is one of its ends.
std::pair<Vec2, Vec2> away_from_anchor(const Footprint& mark) {
  const Vec2 way = mark.to - mark.from;
  if (way.norm() <= meeting) return {mark.from, mark.to};
  const Vec2 cut = meeting * way.normalized();
  if ((mark.from - mark.anchor).norm() < meeting) return {mark.from + cut, mark.to};
  if ((mark.to - mark.anchor).norm() < meeting) return {mark.from, mark.to - cut};
  return {mark.from, mark.to};
}

double distance(const Vec2& x, const std::pair<Vec2, Vec2>& way) {
  const Vec2 along = way.second - way.first;
  const double square = along.squaredNorm();
  const double at = square > 0 ? std::clamp((x - way.first).dot(along) / square, 0.0, 1.0) : 0;
  return (way.first + at * along - x).norm();
}

bool do_cross(const std::pair<Vec2, Vec2>& a, const std::pair<Vec2, Vec2>& b) {
  const auto sides = [](const std::pair<Vec2, Vec2>& of, const std::pair<Vec2, Vec2>& ends) {
    const Vec2 along = of.second - of.first;
    return cross(along, ends.first - of.first) * cross(along, ends.second - of.first);
  };
  return sides(a, b) < 0 && sides(b, a) < 0;
}

double distance(const std::pair<Vec2, Vec2>& a, const std::pair<Vec2, Vec2>& b) {
  if (do_cross(a, b)) return 0;
  return std::min({distance(a.first, b), distance(a.second, b), distance(b.first, a), distance(b.second, a)});
}

}  // namespace

bool Footprint::covers(const Footprint& other) const {
  return distance(away_from_anchor(*this), away_from_anchor(other)) < breadth + other.breadth;
}

Vec2 Footprints::shift_of(const Footprint& mark, const Vec2& direction) const {
  constexpr double same_place = 4, step = 0.5;
  constexpr int most = 72;
  const auto is_covered = [&](const Footprint& there) {
    return std::ranges::any_of(marks_, [&](const Footprint& other) { return other.covers(there); });
  };
  const bool is_beside = std::ranges::none_of(marks_, [&](const Footprint& other) {
    return (other.anchor - mark.anchor).norm() < same_place && other.covers(mark);
  });
  if (is_beside) return Vec2::Zero();
  const Vec2 aside(-direction.y(), direction.x());
  for (int i = 1; i <= most; ++i)
    for (const Vec2& by : {Vec2(i * step * aside), Vec2(-i * step * aside)})
      if (!is_covered(mark.shifted(by))) return by;
  return Vec2::Zero();
}

}  // namespace dda::svg
