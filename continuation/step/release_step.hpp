#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// Steps of an instantaneous release.

/// Next vertex of an instantaneous release; where no continuous path leads on, what a test would find after a
/// jump.
std::optional<Point> release_step(PathState& path);

}  // namespace dda
