#pragma once

#include <string>
#include <vector>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// What hardly any structure has, and units that were mixed up give: by interface whose law softens
///
///     ft/E         strain at which it cracks, below 1e-8
///     E Gf/ft²     length that its cohesive zone needs, more than a hundred times the structure
///
/// E of the softer of the two materials. A sentence for each.
std::vector<std::string> unlikely_numbers(const Simulation& simulation);

}  // namespace dda
