#include "continuation/handover/side_ends.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "continuation/bodies/joined.hpp"
#include "framework/deck/document/node.hpp"

namespace dda {
namespace {

/// Contact without friction.
const InterfaceLaw& pressure() {
  static const std::shared_ptr<const InterfaceLaw> law =
      interface_laws().choose(parse_yaml("{type: friction, friction_angle: 0}", "ends of sides")).make();
  return *law;
}

/// The points of one side.
struct PointsOfSide {
  const InterfacePoint* first = nullptr;
  double area = 0;      ///< [L²]
  bool at_end = false;  ///< one stands at an end of the side
};

/// Of sides that can open.
std::map<std::size_t, PointsOfSide> points_by_side(const Pieces& pieces) {
  constexpr double near = 1e-6;
  std::map<std::size_t, PointsOfSide> out;
  for (const InterfacePoint& point : pieces.equilibrium().interfaces().points) {
    if (point.cut || !point.law->can_crack()) continue;
    const Side& side = pieces.body().assembly.sides[point.side];
    const double from_end = std::min((point.x - side.start).norm(), (point.x - side.end).norm());
    PointsOfSide& points = out[point.side];
    points.first = &point;
    points.area += point.weight;
    points.at_end = points.at_end || from_end < near * (side.end - side.start).norm();
  }
  return out;
}

Bond end_at(const Vec2& x, const PointsOfSide& points, const Body& body) {
  const InterfacePoint& point = *points.first;
  Bond out;
  out.first = point.first.value();
  out.second = point.second.value();
  out.at_first = x - body.block(point.first).moments.centroid;
  out.at_second = x - body.block(point.second).moments.centroid;
  out.normal = point.normal;
  out.stress_first.setZero();
  out.stress_second.setZero();
  out.weight = points.area / 2;
  out.stiffness = point.stiffness;
  out.law = &pressure();
  out.is_end = true;
  return out;
}

}  // namespace

SideEnds ends_of_sides(const Pieces& pieces, const Handover& from) {
  constexpr double further = 1.0 / 20, most = 1.0 / 4;  // of the offset
  const std::vector<MeetingSearch::Pair> joined = joined_by(from.bonds, from.scene.around);
  SideEnds out;
  for (const auto& [index, points] : points_by_side(pieces)) {
    if (points.at_end) continue;
    const Side& side = pieces.body().assembly.sides[index];
    for (const Vec2& x : {side.start, side.end}) {
      Bond bond = end_at(x, points, pieces.body());
      if (from.scene.bodies[bond.first].is_held && from.scene.bodies[bond.second].is_held) continue;
      if (!std::ranges::binary_search(joined, pair_of(bond))) {
        out.of_contacts.push_back(bond);
        continue;
      }
      const double opening = state_of(bond, frame_of(bond, from.poses), from.poses).opening.x();
      bond.multiplier.x() = std::min(std::max(0.0, -opening) + further * from.offset, most * from.offset);
      out.of_joints.push_back(bond);
    }
  }
  return out;
}

}  // namespace dda
