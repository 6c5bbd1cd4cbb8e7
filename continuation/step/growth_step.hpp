#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// Cracks through blocks, which go on where the first point of the segment ahead of them stands at its strength.

/// The crack for which that is so where the walker stands; nothing when there is none.
std::optional<int> crack_to_grow(PathState& path);

/// Aims the segment ahead once more or, where it is aimed well, takes it as grown and cuts the next one; then the
/// equilibrium in which the first of all points stands at its strength, their damage staying as it is. Closed cuts are
/// all but rigid, so that this is hardly another state; what it differs by is booked as a jump.
std::optional<Point> growth_step(PathState& path, int crack);

}  // namespace dda
