#include "models/locked_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace dda {
namespace {

/// A side that ends at a corner on a joint with multipliers, seen from one of its blocks.
struct End {
  BlockId neighbour;
  Vec2 along;  ///< unit vector from the corner
};

struct TJoints {
  std::size_t count = 0;
  Vec2 first = Vec2::Zero();
};

class Corners {
 public:
  Corners(const Body& body, const InterfaceSet& interfaces) : body_(body) {
    std::map<std::size_t, int> points;
    std::set<std::size_t> parting;
    for (const InterfacePoint& point : interfaces.points) {
      if (point.is_separate()) parting.insert(point.side);
      if (point.multiplier != Multiplier::none && ++points[point.side] > 1)
        joints_[point.side] = point.interface;
    }
    const auto& sides = body.assembly.sides;
    for (std::size_t s = 0; s < sides.size(); ++s)
      if (!parting.contains(s)) bonded_.insert(std::minmax(sides[s].first, sides[s].second));
  }

  /// By interface: corners at which two bonded blocks face one and the same block.
  std::map<int, TJoints> t_joints() const {
    std::map<int, TJoints> out;
    std::map<Key, std::vector<End>> met;
    for (const auto& [s, interface] : joints_) {
      const Side& side = body_.assembly.sides[s];
      for (const auto& [corner, far] : {std::pair(side.start, side.end), std::pair(side.end, side.start)})
        for (const auto& [through, other] :
             {std::pair(side.first, side.second), std::pair(side.second, side.first)}) {
          const End here{other, (far - corner).normalized()};
          std::vector<End>& ends = met[key(through, corner)];
          if (std::ranges::any_of(ends, [&](const End& end) { return is_t_joint(end, here); }) &&
              out[interface].count++ == 0)
            out[interface].first = corner;
          ends.push_back(here);
        }
    }
    return out;
  }

 private:
  /// Two pieces of one straight side whose neighbours are bonded to each other.
  bool is_t_joint(const End& a, const End& b) const {
    constexpr double straight = -1 + 1e-9;
    return a.along.dot(b.along) < straight && bonded_.contains(std::minmax(a.neighbour, b.neighbour));
  }
  /// A block and a place, to a millionth of the block's size.
  using Key = std::array<long long, 3>;
  Key key(BlockId block, const Vec2& x) const {
    const Moments& moments = body_.block(block).moments;
    const double unit = 1e-6 * std::sqrt(moments.area);
    const Vec2 at = (x - moments.centroid) / unit;
    return {static_cast<long long>(block.value()), std::llround(at.x()), std::llround(at.y())};
  }

  const Body& body_;
  std::map<std::size_t, int> joints_;             ///< sides with multipliers and their interfaces
  std::set<std::pair<BlockId, BlockId>> bonded_;  ///< neighbours that are not free to part
};

}  // namespace

std::vector<std::string> locked_joints(const Body& body, const InterfaceSet& interfaces) {
  std::vector<std::string> out;
  for (const auto& [interface, found] : Corners(body, interfaces).t_joints())
    out.push_back(fmt::format(
        "interface '{}' locks: at ({:.6g}, {:.6g}){} a corner of one block lies within a side of another, "
        "and exact points on both pieces tie three blocks to one straight line; take `treatment: "
        "consistent`, "
        "or a mesh whose corners meet along the joint",
        interface < 0 ? "" : interfaces.names[static_cast<std::size_t>(interface)], found.first.x(),
        found.first.y(),
        found.count > 1 ? fmt::format(" and {} more place{}", found.count - 1, found.count > 2 ? "s" : "")
                        : ""));
  return out;
}

}  // namespace dda
