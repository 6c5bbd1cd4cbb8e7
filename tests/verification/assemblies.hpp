#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "framework/base/vec2.hpp"
#include "meshing/geometry/polygon.hpp"

namespace dda::verification {

/// A region of the scene and its outline; every side of the outer boundary has a name of its own.
struct Drawing {
  std::string name;
  std::vector<std::pair<std::string, Polygon>> regions;  ///< material, outline
  Polygon outline;                                       ///< of the whole, counter-clockwise
  std::string subdivision = "given";                     ///< YAML
};

inline void PrintTo(const Drawing& drawing, std::ostream* out) { *out << drawing.name; }

/// `scene:` of a deck, with boundaries side0, side1, … along the outline.
std::string scene_text(const Drawing& drawing);

/// A random convex polygon of `corners` points on an ellipse of half-axes `half_axes` about the origin.
Polygon random_convex(std::size_t corners, const Vec2& half_axes, std::uint64_t seed);

/// Cuts a convex polygon by random lines near the middle of its pieces until there are `count`: convex pieces
/// with T-joints everywhere.
std::vector<Polygon> random_pieces(const Polygon& convex, std::size_t count, std::uint64_t seed);

Polygon rectangle(const Vec2& low, const Vec2& high);

/// "[[x, y], …]" with every digit.
std::string points_text(const std::vector<Vec2>& points);

}  // namespace dda::verification
