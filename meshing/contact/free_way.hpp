#pragma once

#include <span>

#include "framework/base/vec2.hpp"

namespace dda {

/// An outline and where its vertices are going: x + a v, a from 0 to 1.
struct MovingOutline {
  std::span<const Vec2> x, v;
};

/// The largest a ≤ `most` up to which no vertex of one comes nearer to an edge of the other than `kept` times the distance
/// they have now, and neither touches.
///
/// Conservative advancement, vertex by edge: the distance shrinks by at most max |v − v_edge| per unit of a, so that steps
/// of (d(a) − kept d(0))/that never pass the place looked for.
double free_way(const MovingOutline& one, const MovingOutline& other, double kept, double most);

}  // namespace dda
