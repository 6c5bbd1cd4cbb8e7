#pragma once

#include "continuation/handover/handover.hpp"

namespace dda {

/// Poses in which bodies are strained, joints opened and supports stretched as at the end of a path, whatever they have turned
/// by: the least
///
///     ½ Σ V (E − ε):C:(E − ε) + ½ Σ W k |g − g'|² + ½ Σ k (l − l')²
///
/// E and ε the strains of Green and of the path, g and g' the jumps of places across joints in the frame that turns with their
/// sides and of the path, with what the joints bear as secant k, l and l' what springs hold. A rotation that is small on
/// the path moves what is joined to a body far from its centroid by half its square: by that joints would be torn open.
/// Where blocks of second order are of first from here on: their equilibrium under the loads of the path, or, where these
/// have fallen, nearly the shape of the path.
Poses finite_poses(const Pieces& pieces, const PathEnd& end, const Handover& from);

}  // namespace dda
