#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// Steps off the damage surfaces to a gauge value.

/// A tenth of the way to the leg's goal, off the damage surfaces.
std::optional<Point> unload_step(PathState& path);

}  // namespace dda
