#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

/// Lands on zero load: where the last crack of the structure breaks. Unloading ends there, too, and what
/// slides back dissipates.
std::optional<Point> rupture(PathState& path);

}  // namespace dda
