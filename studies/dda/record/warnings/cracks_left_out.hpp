#pragma once

#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Of the place where tension is farthest beyond the strength of a region whose cracks begin by themselves, `most` of which have
/// begun: σ₁ > 1.1 f_t. A sentence; "" where there is none.
std::string note_on_cracks_left_out(const Simulation& simulation);

}  // namespace dda
