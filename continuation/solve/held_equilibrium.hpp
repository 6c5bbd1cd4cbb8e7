#pragma once

#include <optional>
#include <vector>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// Newton's method for equilibrium with one linear gauge prescribed and the load factor free, with a line
/// search on the residual.
class HeldEquilibrium {
 public:
  HeldEquilibrium(System& system, const StepperParameters& parameters, const Functional& held, double value);

  /// With the history in force in the system. Converged states are improved once more: what is searched for
  /// are vertices of a straight path.
  std::optional<State> solve(State at);
  /// Of all solutions so far.
  int iterations() const { return iterations_; }

 private:
  struct Correction {
    std::vector<double> d;
    double load_factor;
  };

  std::optional<State> solve_by_newton(State at);
  std::optional<State> solve_contacts_from(const State& at);
  bool converge(State& at);
  bool meets_gauge(const State& at) const;
  Correction correct(const State& at, const std::vector<double>& residual, const std::vector<double>& slope);
  State search(const State& from, const Correction& correction, double norm) const;
  static State moved(const State& from, const Correction& correction, double share);

  System& system_;
  const StepperParameters& parameters_;
  const Functional& held_;
  double value_;
  std::vector<double> per_d_;
  int iterations_ = 0;
};

}  // namespace dda
