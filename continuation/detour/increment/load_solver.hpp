#pragma once

#include <memory>
#include <optional>
#include <string>

#include "continuation/solve/stepper.hpp"
#include "framework/deck/family.hpp"

namespace dda {

/// What a search for the equilibrium under one load came to.
struct Found {
  std::optional<State> state;  ///< nothing when there is none, or none was found
  int newton_iterations = 0;
  int relaxation_iterations = 0;  ///< residuals that were evaluated
  std::string why;                ///< it failed
};

/// Finds the equilibrium under a prescribed load factor, R(d, λ; h) = 0 with the history h in force.
///
/// A state counts as one by the measure and the tolerance of Newton's method (System::excess_residual,
/// `path.newton.tolerance`), whichever member found it. The history of the system stays.
class LoadSolver {
 public:
  virtual ~LoadSolver() = default;
  /// Whether it solves with tangents.
  virtual bool needs_tangents() const { return true; }
  /// Why it cannot serve this structure; "" when it can.
  virtual std::string refusal(const Equilibrium&) const { return {}; }
  /// From a state near by. Iterated multipliers of the system are left as they were last.
  virtual Found solve(Stepper& stepper, const State& from, double load_factor) = 0;
};

using LoadSolverFamily = Family<LoadSolver>;
using LoadSolverChoice = Choice<LoadSolver>;

/// The registry behind `path.control.solver`.
LoadSolverFamily& load_solvers();

}  // namespace dda
