#pragma once

#include <Eigen/Core>

namespace dda {

/// A point or vector of the plane, global coordinates (x, y) [length].
using Vec2 = Eigen::Vector2d;

/// z component of a × b: positive when b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace dda
