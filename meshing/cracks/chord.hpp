#pragma once

#include <array>
#include <optional>

#include "meshing/geometry/polygon.hpp"

namespace dda {

// Straight lines through simple polygons, convex or not. Vertices count as met within `tolerance` [L].

/// Whether a small step from a point of the outline in some direction leads into the polygon; false for points
/// off the outline and along an edge.
bool enters(const Polygon& polygon, const Vec2& from, const Vec2& direction, double tolerance);

/// Where the line that enters there first meets the outline again; a vertex exactly where one is met.
std::optional<Vec2> exit_of(const Polygon& polygon, const Vec2& from, const Vec2& direction,
                            double tolerance);

/// What lies left and right of the chord between two points of the outline, counter-clockwise each. The chord is
/// taken to run inside; where it runs along the outline an area is zero.
std::array<Polygon, 2> divided(const Polygon& polygon, const Vec2& start, const Vec2& end, double tolerance);

/// Distance from x to the polygon, 0 inside [L].
double distance(const Vec2& x, const Polygon& polygon);

}  // namespace dda
