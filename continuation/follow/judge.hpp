#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

// Whether a converged state is the next point of the path.

/// Work of the step less what it stored and dissipated [FL].
double missing_work(const PathState& path, const Candidate& candidate);

/// Whether more work of the step than `most` is neither stored nor dissipated, nor lost in rounding:
/// quadrature error, or a jump.
bool loses_work(const PathState& path, const Candidate& candidate, double most);

/// Whether a step only opens, closes and slides joints, so that many kinks may lie in it.
bool only_touches(const PathState& path, const Candidate& candidate);

/// Whether the quadrature of the work misses a kink within the step: the energy balance of a run is the sum
/// of these.
bool is_coarse(const PathState& path, const Candidate& candidate);

/// Why a converged state is no result: what nothing holds, or a point that bears more than its strength; nothing
/// when it is one.
std::optional<Stopped> unsoundness(const PathState& path, const Candidate& candidate);

/// What a step leaves unaccounted for, where it is more than the chord of a path may; "" where it is not.
std::string jump_of(const PathState& path, const Candidate& candidate);

/// Why a converged state is not the next point of a path.
struct Objection {
  std::string why;                   ///< "" when it is
  std::optional<Stop> unsound = {};  ///< why it is no result at all, where it is none
  bool is_beside_load = false;       ///< joints move far while the load and its displacement stay
};
/// Steps that only open, close and slide joints have none for what they leave unaccounted for, as long as they may
/// be shortened: see `jump_of`.
Objection objection_to(const PathState& path, const Candidate& candidate);

/// Whether less was put in than is stored and spent, by more than damage that grows ahead of openings, what tolerances
/// leave, and more than is bearable [FL]: nearly all that an event spends, which grows one κ, a quarter of what a jump does, which
/// ends where all of them have been asked for, and whose friction is counted along its chord.
bool creates_energy(const PathState& path, const Candidate& beyond, StepKind kind, double bearable = 0);

}  // namespace dda
