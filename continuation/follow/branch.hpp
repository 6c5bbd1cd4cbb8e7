#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

// Where a path may branch: the first equilibrium that another branch leaves, and the branch that nature
// takes.

/// Puts into a point how stable the equilibrium is at which the walker stands.
void judge_stability(const PathState& path, Point& point);

/// Where a step has passed a bifurcation: the first equilibrium beyond it, which bisection brings within 1e-6
/// of the load and of the displacement.
std::optional<Candidate> first_unstable(PathState& path, const Candidate& beyond, double amount,
                                        const Move& move);

/// At a bifurcation: leaves by the branch on which the load falls fastest per dissipated energy, and by a
/// branch of that one where it is not stable either.
void choose_branch(PathState& path, Point& point);

}  // namespace dda
