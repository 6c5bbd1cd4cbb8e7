#pragma once

#include <string>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Of the block of the state that turns or strains most, where that is more than small displacements describe:
///
///     |r0|, |ε₁|, |ε₂| > 0.1         [1]
///
/// Contacts, arms of forces and strains of a path are those of the undeformed shape. A sentence; "" where all are small.
std::string note_on_large_movements(const Simulation& simulation);

}  // namespace dda
