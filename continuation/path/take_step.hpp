#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

// Which step a path takes next.

std::optional<Point> take_step(PathState& path);

}  // namespace dda
