#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// A step under the control where cracks grow or joints slide.

std::optional<Point> controlled_step(PathState& path, const Move& move);

}  // namespace dda
