#pragma once

#include "models/body/place.hpp"

namespace dda {

/// Rotation of a place: of the patch (rotation_over), or of the blocks that meet at the point, in the mean.
Functional rotation_at(const Body& body, const Place& place, const Position& where);

}  // namespace dda
