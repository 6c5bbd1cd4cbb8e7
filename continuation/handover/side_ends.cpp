#include "continuation/handover/side_ends.hpp"

#include <algorithm>
#include <map>
#include <memory>

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
  bool at_end = false;  ///< of the side: one stands there
};

std::map<std::size_t, PointsOfSide> contacts_of(const Pieces& pieces) {
  constexpr double near = 1e-6;
  std::map<std::size_t, PointsOfSide> out;
  for (const InterfacePoint& point : pieces.equilibrium().interfaces().points) {
    if (point.cut || !point.is_separate()) continue;
    const Side& side = pieces.body().assembly.sides[point.side];
    const double from_end = std::min((point.x - side.start).norm(), (point.x - side.end).norm());
    PointsOfSide& points = out[point.side];
    points.first = &point;
    points.area += point.weight;
    points.at_end = points.at_end || from_end < near * (side.end - side.start).norm();
  }
  return out;
}

}  // namespace

std::vector<Bond> ends_of_contacts(const Pieces& pieces) {
  std::vector<Bond> out;
  const Body& body = pieces.body();
  for (const auto& [index, points] : contacts_of(pieces)) {
    if (points.at_end) continue;
    const Side& side = body.assembly.sides[index];
    const InterfacePoint& point = *points.first;
    for (const Vec2& x : {side.start, side.end}) {
      Bond bond;
      bond.first = point.first.value();
      bond.second = point.second.value();
      bond.at_first = x - body.block(point.first).moments.centroid;
      bond.at_second = x - body.block(point.second).moments.centroid;
      bond.normal = point.normal;
      bond.stress_first.setZero();
      bond.stress_second.setZero();
      bond.weight = points.area / 2;
      bond.stiffness = point.stiffness;
      bond.law = &pressure();
      bond.is_end = true;
      out.push_back(bond);
    }
  }
  return out;
}

}  // namespace dda
