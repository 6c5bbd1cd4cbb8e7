#pragma once

#include "continuation/step/stride.hpp"

namespace dda {

// Rungs by which a converged try ends the step: at it, or exactly at what lies before it.

/// At the first equilibrium that another branch leaves.
std::optional<Outcome> stop_at_branch(PathState& path, const Candidate& candidate, Stride& stride);
/// On the first wanted value on the way.
std::optional<Outcome> land_on_value(PathState& path, const Candidate& candidate, Stride& stride);
/// Where the first point that loses its strength at once reaches it.
std::optional<Outcome> land_at_strength(PathState& path, const Candidate& candidate, Stride& stride);
/// At the try itself; the next step is sized by it.
std::optional<Outcome> go_on(PathState& path, const Candidate& candidate, Stride& stride);

}  // namespace dda
