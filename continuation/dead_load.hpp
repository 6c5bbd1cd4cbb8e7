#pragma once

#include <string>

#include "continuation/walker.hpp"

namespace dda {

/// Brings the walker's stage from load factor 0 to 1 by load control, cutting steps where Newton needs it.
/// Returns "" or why the structure cannot carry the stage.
std::string apply_full_stage(Walker& walker);

}  // namespace dda
