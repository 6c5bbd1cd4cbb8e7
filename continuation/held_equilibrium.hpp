#pragma once

#include <optional>
#include <vector>

#include "continuation/loca/stepper.hpp"

namespace dda {

/// Newton's method for equilibrium with one linear gauge prescribed and the load factor free.
class HeldEquilibrium {
 public:
  HeldEquilibrium(System& system, const StepperParameters& parameters, const Functional& held, double value);

  /// With the history in force in the system. Converged states are improved once more: what is searched for
  /// are vertices of a straight path.
  std::optional<State> solve(State at);
  /// Of all solutions so far.
  int iterations() const { return iterations_; }

 private:
  bool converge(State& at);
  void correct(State& at, const std::vector<double>& residual, const std::vector<double>& slope);

  System& system_;
  const StepperParameters& parameters_;
  const Functional& held_;
  double value_;
  std::vector<double> per_d_;
  int iterations_ = 0;
};

}  // namespace dda
