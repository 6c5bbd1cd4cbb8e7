#pragma once

#include "meshing/geometry/polygon.hpp"

namespace dda {

/// The polygon shrunk by `offset` s: every side is moved inward by s and meets its neighbours' lines, so that a corner of
/// inner angle β stands back by s/sin(β/2). Sides that this would turn round are left out, one by one, shortest first.
/// Counter-clockwise, convex or not.
///
/// Throws std::domain_error where less than a triangle would be left: the polygon is narrower than 2s.
Polygon core_of(const Polygon& outline, double offset);

}  // namespace dda
