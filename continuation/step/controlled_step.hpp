#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

/// A step under the control where cracks grow or joints slide: tries, and the rungs that each converged one
/// climbs (stride.hpp), until one ends the step; where the smallest does not, a rescue or the end.
std::optional<Point> controlled_step(PathState& path, const Move& move);

}  // namespace dda
