#pragma once

#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Where the faces of a slit have passed through each other at the end, or at the peak: nothing is joined there, and
/// nothing is kept apart. Told where they overlap by more than a hundredth of the largest displacement of such faces, with
/// the place of the deepest overlap and the interface that would bear it.
///
/// "" where none does.
std::string note_on_closed_slits(const Simulation& simulation, const State* peak);

}  // namespace dda
