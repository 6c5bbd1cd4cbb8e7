#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

// What a converged step may have passed over, or hide between its ends: the limit point, a gauge that turns
// back and forward again.

/// What a step has been taken in parts for.
struct Looks {
  bool for_peak = false, for_turn = false;
};

/// Share of the step at which the limit point is to be sought, when the step crosses it and the peak is not
/// yet bracketed: where the tangents of both ends meet, an upper bound of a concave load and exact at a kink.
std::optional<double> before_peak(const PathState& path, const Candidate& candidate);

/// Share of the step at which a displacement gauge turns, where the rows at both ends would show the turn
/// lower than it is by half the depth of one that is to be seen: so that a turn and the next, each cut off,
/// stay two.
std::optional<double> before_turn(const PathState& path, const Candidate& candidate);

/// Share of the step after which it is to be looked at: the next corner of a law, or half way. Asked for
/// where a peak or a turn may be hidden; nothing elsewhere.
std::optional<double> before_hidden_turn(const PathState& path, const Candidate& candidate, double amount);

/// Whether the load may have turned above the peak by more than half of its tolerance; where no crack grows, whether it has. So many looks in a row
/// that found no higher load end them: a plateau has corners in every step.
bool may_hide_peak(const PathState& path, const Candidate& candidate);

/// Whether a displacement gauge may have turned back and forward again by more than the depth that is to be
/// seen. A turn back by d between two ways forward leaves a kink of d and of what the way forward lacks; the
/// bend of a smooth step at the default accuracy leaves up to two such depths. So many looks in a row that
/// found no turn end them, until the next one.
bool may_hide_turns(const PathState& path, const Candidate& candidate);

/// Counts the looks that found nothing.
void note_looks(PathState& path, const Looks& looks, const Candidate& candidate);

}  // namespace dda
