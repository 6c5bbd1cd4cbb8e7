#include "continuation/handover/side_ends.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

#include "continuation/bodies/joined.hpp"
#include "framework/deck/document/node.hpp"
#include "meshing/geometry/polygon.hpp"

namespace dda {
namespace {

/// Contact without friction.
const InterfaceLaw& pressure() {
  static const std::shared_ptr<const InterfaceLaw> law =
      interface_laws().choose(parse_yaml("{type: friction, friction_angle: 0}", "ends of sides")).make();
  return *law;
}

/// A side between two pieces, and the points on it.
struct PointsOfSide {
  const InterfacePoint* point = nullptr;            ///< one of them
  std::pair<std::size_t, std::size_t> bodies = {};  ///< beside it
  double area = 0;                                  ///< [L²]
  bool at_end = false;                              ///< one stands at an end of the side
};

/// Finds the side of the pieces' assembly on which a point of the whole lies.
class SidesOfPieces {
 public:
  explicit SidesOfPieces(const std::vector<Side>& sides) : sides_(sides) {
    for (std::size_t s = 0; s < sides.size(); ++s) between_[pair_of(sides[s])].push_back(s);
  }
  std::size_t at(const std::pair<std::size_t, std::size_t>& bodies, const Vec2& x) const {
    const auto from_x = [&](std::size_t s) { return distance(x, sides_[s].start, sides_[s].end); };
    return std::ranges::min(between_.at(std::minmax(bodies.first, bodies.second)), {}, from_x);
  }

 private:
  static std::pair<std::size_t, std::size_t> pair_of(const Side& side) {
    return std::minmax(side.first.value(), side.second.value());
  }
  const std::vector<Side>& sides_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> between_;
};

/// Of sides that can open, and of cuts.
std::map<std::size_t, PointsOfSide> points_by_side(const Pieces& pieces, const Equilibrium& whole) {
  constexpr double near = 1e-6;
  const std::vector<Side>& sides = pieces.body().assembly.sides;
  const SidesOfPieces places(sides);
  std::map<std::size_t, PointsOfSide> out;
  for (const InterfacePoint& point : whole.interfaces().points) {
    if (!point.law->can_crack()) continue;
    const auto bodies = pieces.beside(point);
    const std::size_t index = places.at(bodies, point.x);
    const Side& side = sides[index];
    const double from_end = std::min((point.x - side.start).norm(), (point.x - side.end).norm());
    PointsOfSide& points = out[index];
    points.point = &point;
    points.bodies = bodies;
    points.area += point.weight;
    points.at_end = points.at_end || from_end < near * (side.end - side.start).norm();
  }
  return out;
}

Bond end_at(const Vec2& x, const PointsOfSide& points, const Body& body) {
  Bond out;
  std::tie(out.first, out.second) = points.bodies;
  out.at_first = x - body.block(BlockId{out.first}).moments.centroid;
  out.at_second = x - body.block(BlockId{out.second}).moments.centroid;
  out.normal = points.point->normal;
  out.stress_first.setZero();
  out.stress_second.setZero();
  out.weight = points.area / 2;
  out.stiffness = points.point->stiffness;
  out.law = &pressure();
  out.is_end = true;
  return out;
}

}  // namespace

SideEnds ends_of_sides(const Pieces& pieces, const Equilibrium& whole, const Handover& from) {
  constexpr double little = 1.0 / 20;  // of the offset
  const std::vector<MeetingSearch::Pair> joined = joined_by(from.bonds, from.scene.around);
  SideEnds out;
  for (const auto& [index, points] : points_by_side(pieces, whole)) {
    if (points.at_end) continue;
    const Side& side = pieces.body().assembly.sides[index];
    for (const Vec2& x : {side.start, side.end}) {
      Bond bond = end_at(x, points, pieces.body());
      if (from.scene.bodies[bond.first].is_held && from.scene.bodies[bond.second].is_held) continue;
      const double opening = state_of(bond, frame_of(bond, from.poses), from.poses).opening.x();
      const bool holds = std::ranges::binary_search(joined, pair_of(bond));
      bond.multiplier.x() = std::max(0.0, -opening) + (holds ? little * from.offset : 0);
      (holds ? out.of_joints : out.of_contacts).push_back(bond);
      if (!holds && -opening > little * from.offset) out.overlapping.push_back(pair_of(bond));
    }
  }
  put_in_order(out.overlapping);
  for (Bond& bond : out.of_contacts)
    if (!std::ranges::binary_search(out.overlapping, pair_of(bond))) bond.multiplier.setZero();
  return out;
}

}  // namespace dda
