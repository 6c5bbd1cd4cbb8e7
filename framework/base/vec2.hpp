#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace dda {

/// A point or vector of the plane, global coordinates (x, y) [length].
using Vec2 = Eigen::Vector2d;

/// z component of a × b: positive when b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The components of vectors, one vector after another; also of none.
inline std::span<double> components(std::vector<Vec2>& v) {
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  return {reinterpret_cast<double*>(v.data()), 2 * v.size()};
}
inline std::span<const double> components(const std::vector<Vec2>& v) {
  return {reinterpret_cast<const double*>(v.data()), 2 * v.size()};
}

}  // namespace dda
