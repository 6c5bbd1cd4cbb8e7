#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// Steps to the next crack, and where there is none.

std::optional<Point> event_step(PathState& path);

/// Nothing can crack any more: the response is linear up to the full reference load.
std::optional<Point> linear_step(PathState& path);

}  // namespace dda
