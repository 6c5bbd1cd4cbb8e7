#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// Steps of structures that slide, open and close while nothing cracks.

/// Nothing cracks, but joints slide, open or close. The first change of a contact is landed on; from there
/// the path is followed until a wanted value or a mechanism. Where no contact will change any more the
/// response is linear for good.
std::optional<Point> sliding_step(PathState& path);

}  // namespace dda
