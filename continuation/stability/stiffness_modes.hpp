#pragma once

#include "continuation/linear/direct/direct_solver.hpp"
#include "continuation/stability/eigenmodes.hpp"
#include "continuation/state/system.hpp"

namespace dda {

/// Which modes of a stiffness are wanted.
struct ModeRequest {
  int count = 6;
  Mass mass;  ///< M of blocks and jumps; identities for K φ = μ φ
  /// K*: of released points nothing is left, neither is what a consistent joint subtracts.
  bool is_physical = true;
};

/// Modes, and how many eigenvalues in all lie below zero where that is known.
struct StiffnessModes {
  std::optional<int> num_negative;
  Eigenmodes modes;
};

/// Lowest eigenpairs of the tangent stiffness at a state, with the flags of the system's history.
///
/// K is that of the path (System::use_path_tangent), and is inverted by its low-rank updates as long as K* is
/// the same matrix; otherwise K* is factorised. Friction makes K unsymmetric: the eigenpairs are then those
/// of its symmetric part. Nothing when K is singular. Throws std::runtime_error when they do not converge.
std::optional<StiffnessModes> stiffness_modes(System& system, const State& state,
                                              const DirectSolverChoice& solver, const ModeRequest& wanted);

}  // namespace dda
