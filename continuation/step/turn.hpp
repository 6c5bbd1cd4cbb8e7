#pragma once

#include "continuation/step/stride.hpp"

namespace dda {

/// Where a step fails because the path turns on the way: lands exactly where a crack starts or has lost its
/// last traction, so that the tangent there tells which cracks go on and which unload.
std::optional<Point> land_on_turn(PathState& path, const Stride& stride, bool on_new_cracks);

}  // namespace dda
