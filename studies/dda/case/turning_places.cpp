#include "studies/dda/case/turning_places.hpp"

#include <algorithm>

namespace dda {
namespace {

TurningPlace turning_place(const std::vector<const InterfacePoint*>& points, double thickness) {
  TurningPlace out{.num_points = points.size()};
  Vec2 middle = Vec2::Zero();
  for (const InterfacePoint* point : points) {
    const double length = point->weight / thickness * (point->is_mirror() ? 2 : 1);
    out.length += length;
    middle += length * point->x;
    out.is_second_order = out.is_second_order || !point->gradients.empty();
  }
  middle /= out.length;
  double farthest = 0;
  for (const InterfacePoint* point : points) farthest = std::max(farthest, (point->x - middle).norm());
  out.inside = 0.5 - farthest / out.length;
  return out;
}

}  // namespace

std::map<SideKey, TurningPlace> turning_places(const InterfaceSet& set, double thickness) {
  constexpr double at_its_end = 1e-6;
  std::map<SideKey, std::vector<const InterfacePoint*>> sides;
  for (const InterfacePoint& point : set.points)
    if (point.interface >= 0 && point.law->can_crack()) sides[SideKey(point)].push_back(&point);
  std::map<SideKey, TurningPlace> out;
  for (const auto& [key, points] : sides)
    if (const TurningPlace place = turning_place(points, thickness);
        points.size() > 1 && place.inside > at_its_end)
      out.emplace(key, place);
  return out;
}

}  // namespace dda
