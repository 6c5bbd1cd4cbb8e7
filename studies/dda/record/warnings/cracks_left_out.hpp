#pragma once

#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Of the place where tension is farthest beyond the strength of a region that cracks run through, and none of them may begin:
/// σ₁ > 1.1 f_t where the path ends, or 1.5 f_t at its peak. A sentence; "" where there is none.
std::string note_on_cracks_left_out(const Simulation& simulation, const State* peak);

/// Of the re-entrant corner with the fewest blocks ahead of it, less than four, where cracks begin by themselves; "" where there
/// is none.
std::string note_on_shallow_corners(const Simulation& simulation);

}  // namespace dda
