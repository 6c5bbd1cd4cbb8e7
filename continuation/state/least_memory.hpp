#pragma once

#include <memory>

#include "continuation/linear/direct/direct_solver.hpp"
#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// What following a path takes at one time beside the model, at least [bytes].
///
/// The factor is counted by the solver's symbolic factorisation, the vectors are those that live in every step.
/// What cracks take beside them depends on the path: their columns, and a factor of their own where the tangent
/// is factorised anew.
struct LeastMemory {
  double factor = 0;   ///< of the intact stiffness
  double vectors = 0;  ///< of all unknowns and points
};

/// Counts; nothing is factorised. Throws std::runtime_error where the solver cannot analyse the stiffness.
LeastMemory least_memory(const Equilibrium& equilibrium, DirectSolver& solver);

/// A solver that has analysed the intact stiffness. Throws InputError where the least that a path takes is more
/// than there is (memory_limit).
std::unique_ptr<DirectSolver> affordable_solver(const Equilibrium& equilibrium,
                                                const DirectSolverChoice& choice);

}  // namespace dda
