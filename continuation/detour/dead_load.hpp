#pragma once

#include <string>

#include "continuation/walk/walker.hpp"

namespace dda {

/// Brings the walker's stage from load factor 0 to 1 by load control, cutting steps where Newton needs it.
/// What loses its strength at once does so on the way, point by point, while the load stays.
/// Returns "" or why the structure cannot carry the stage.
std::string apply_full_stage(Walker& walker);

}  // namespace dda
