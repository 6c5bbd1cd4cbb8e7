#pragma once

#include <set>
#include <vector>

#include "continuation/course/path_state.hpp"

namespace dda {

// What steps that change cuts through blocks share.

/// Mean σ of each block where the walker stands: (σx, σy, τxy) [F/L²].
std::vector<Vec3> block_stress(PathState& path);

/// The same, and its rates along the way on which the path leaves there.
BlockStress growing_stress(PathState& path);

/// What directions of cracks may ask of the structure where the walker stands: stress is that of the first block at
/// a point; energy is released by the structure once the points of the cuts that are in tension bear none, those that are
/// pressed staying closed,
///
///     ΔΠ = ½ rᵀ K⁻¹ r       R = r then, K without these points and the broken ones; all others held as they are
CrackFront::Surroundings around(PathState& path);

/// Cracks on whose segment ahead energy has been spent, by the histories of the structure's points: where a crack has
/// grown by a step that passes strengths, points ahead of others crack, too. Such a segment stays where it is.
std::set<int> spent_on(const PathState& path, const std::vector<History>& history);

/// The equilibrium with the cuts that there are now at the same displacement of the load, or before it has begun without
/// any, damage growing as it must.
std::optional<Candidate> standing_still(PathState& path);

/// Makes the structure anew for the cuts that there are now; `before` are those that it was made for.
void follow_cuts(PathState& path, const std::vector<Cut>& before);

}  // namespace dda
