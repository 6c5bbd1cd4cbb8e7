#pragma once

#include <span>

#include "framework/base/vec2.hpp"

namespace dda {

/// What of an outline lies nearest to a vertex of another one, seen from there: the inside of an edge, or a corner.
struct Facing {
  std::size_t edge = 0;  ///< from vertex `edge` to the next one; of a corner the edge that begins there
  bool is_corner = false;
  Vec2 foot = Vec2::Zero();  ///< the nearest point
  double distance = 0;       ///< [L]
};

/// Calls visit(Facing) for every edge on whose inside the foot of x lies, and every corner behind whose two edges x is
/// placed, nearer than `reach`. Distances have no sign: outlines that never touch need none. A sum over these of a
/// function that vanishes at `reach` is continuous in x, since a foot that leaves an edge arrives at its corner.
template <class Visit>
void for_each_facing(const Vec2& x, std::span<const Vec2> outline, double reach, Visit visit) {
  const std::size_t n = outline.size();
  const auto share_of = [&](std::size_t e) {  // of the foot along an edge
    const Vec2 edge = outline[(e + 1) % n] - outline[e];
    return (x - outline[e]).dot(edge) / edge.squaredNorm();
  };
  double before = share_of(n - 1);
  for (std::size_t e = 0; e < n; ++e) {
    const double share = share_of(e);
    if (share <= 0 && before >= 1) {
      const double distance = (x - outline[e]).norm();
      if (distance < reach) visit(Facing{e, true, outline[e], distance});
    } else if (share > 0 && share < 1) {
      const Vec2 foot = outline[e] + share * (outline[(e + 1) % n] - outline[e]);
      const double distance = (x - foot).norm();
      if (distance < reach) visit(Facing{e, false, foot, distance});
    }
    before = share;
  }
}

}  // namespace dda
