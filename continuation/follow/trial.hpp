#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

/// On the straight way from one state to another, or, with shares beyond 0 and 1, beyond them.
State between(const State& a, const State& b, double share);

// Trying a step, and what is done with its end.

/// Tries a step of this length along the leaving tangent; nothing when it is rejected.
std::optional<Candidate> try_step(PathState& path, const Move& move, double amount,
                                  Thoroughness thoroughness = Thoroughness::usual);

/// What an attempt has found, if that is the next point of this path; else it is rejected.
std::optional<Candidate> judged(PathState& path, const Attempt& tried, const std::string& control);

/// Whether a candidate that cannot be shortened any more is rejected as a jump.
bool refuse_jump(PathState& path, const Candidate& candidate, const std::string& control);

/// Moves on to a candidate and remembers what it changes.
Point keep(PathState& path, Candidate candidate, StepKind kind);

/// Accepts an equilibrium that no control led to; a wanted value can be passed but not landed on. It may not create
/// energy, but for so much where the structure itself has become another one [FL].
std::optional<Point> jump_to(PathState& path, Candidate beyond, StepKind kind, double bearable = 0);

}  // namespace dda
