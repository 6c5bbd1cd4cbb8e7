#pragma once

#include <memory>
#include <optional>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// Equilibrium with one linear gauge prescribed and the load factor free, by Newton's method with a line
/// search; where joints are in contact and that runs in circles, contact and friction solved exactly.
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
  int iterations_ = 0;
};

}  // namespace dda
