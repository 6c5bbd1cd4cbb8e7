#pragma once

#include "continuation/step/stride.hpp"

namespace dda {

// Rungs that take a converged try back because a shorter step sees more. Each may do so a few times in a
// step.

/// The try lies far from what the tangent foresaw: another branch, perhaps.
std::optional<Outcome> refuse_stray(PathState& path, const Candidate& candidate, Stride& stride);
/// The limit point lies on the way and is not bracketed yet.
std::optional<Outcome> bracket_peak(PathState& path, const Candidate& candidate, Stride& stride);
/// A displacement gauge turns on the way.
std::optional<Outcome> bracket_turn(PathState& path, const Candidate& candidate, Stride& stride);
/// A peak or a turn may be hidden on the way.
std::optional<Outcome> look_between(PathState& path, const Candidate& candidate, Stride& stride);
/// The quadrature of the work misses a kink, or joints have snapped.
std::optional<Outcome> refine_coarse(PathState& path, const Candidate& candidate, Stride& stride);

}  // namespace dda
