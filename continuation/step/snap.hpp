#pragma once

#include "continuation/step/stride.hpp"

namespace dda {

/// Accepts what a step has jumped to where joints snap: most of what such a jump leaves unaccounted for is
/// left however short the step is, as two of its sizes tell, while that of a kink vanishes with it. How much
/// of the energy that it sets free friction takes on the way is not known.
std::optional<Point> snap(PathState& path, const Candidate& beyond, Stride& stride);

}  // namespace dda
