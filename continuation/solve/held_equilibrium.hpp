#pragma once

#include <memory>
#include <optional>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// Equilibrium with one linear gauge prescribed and the load factor free: by Newton's method with a line search; where joints
/// are in contact, contact and friction are solved exactly, first where no damage grows beside them, else where Newton's
/// method runs in circles.
class HeldEquilibrium {
 public:
  HeldEquilibrium(Stepper& stepper, const Functional& held, double value);

  /// With the history in force in the system. Converged states are improved once more: what is searched for
  /// are vertices of a straight path.
  std::optional<State> solve(const State& at);
  /// Of all solutions so far.
  int iterations() const { return iterations_; }

 private:
  State on_gauge(const StepGoal& goal);
  std::optional<State> taken(const Attempt& attempt);

  Stepper& stepper_;
  const Functional& held_;
  double value_;
  std::unique_ptr<ControlEquation> control_;
  bool only_touches_ = false;  ///< no damage grows in any joint
  int iterations_ = 0;
};

}  // namespace dda
