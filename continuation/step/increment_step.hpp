#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// Steps by increments of the load.

/// The load raised by the largest of halved increments that still finds an equilibrium.
std::optional<Point> increment_step(PathState& path);

}  // namespace dda
