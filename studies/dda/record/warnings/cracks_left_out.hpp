#pragma once

#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Of the place where tension is farthest beyond the strength of a region that cracks run through, and none of them may begin:
/// σ₁ > 1.1 f_t where the path ends, or 2 f_t at its peak. A sentence; "" where there is none.
std::string note_on_cracks_left_out(const Simulation& simulation, const State* peak);

}  // namespace dda
