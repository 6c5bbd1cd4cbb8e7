#pragma once

#include <optional>

#include "continuation/solve/equations/cracked_equations.hpp"
#include "continuation/solve/reduced.hpp"

namespace dda {

/// Contact and friction solved exactly on the points that are not held as in the intact structure, with
/// Newton's method for what cracks around it, also under frozen damage, iterated multipliers and controls
/// that look at every point.
///
/// The base is chosen once, by the state that the step begins to search at: the intact structure, with the
/// damage of the history where so much has cracked that columns for all of it would cost more; contact of
/// separate bodies is closed and held in it. The points' equations are kept from call to call of one step,
/// as while multipliers are iterated.
class ContactSolver {
 public:
  struct Limits {
    std::size_t points;    ///< more are not tried: dense equations grow with the third power
    std::size_t searched;  ///< among more no other way is sought where the straight one leads nowhere
  };
  ContactSolver(Stepper& stepper, const State& near, const Limits& limits)
      : stepper_(stepper), system_(stepper.system()), limits_(limits) {
    prepare(near);
  }

  /// Walks begin at the start of the step: between it and what is wanted they are equilibria of the path.
  /// Nothing with initial stress, where no joint is in contact, where more points than the limit would
  /// take part, and where there is no equilibrium.
  std::optional<Reduced> solve(const StepGoal& goal);
  /// Whether to walk at once, as where Newton's method has ended far away on a singular matrix.
  void try_newton(bool on) { tries_newton_ = on; }
  /// Whether the last call has walked at once.
  bool has_walked() const { return !tries_newton_ || (points_ && points_->only_touch()); }

 private:
  void prepare(const State& near);
  CrackedEquations::Rule rule() const;
  std::optional<Reduced> solve_sum(const ControlSum& sum, const StepGoal& goal, const State& guess);
  std::optional<Reduced> iterate(const State& start, const State& guess, double step);
  std::optional<Reduced> solve_from(const Iterate& at, double step, Method method);
  void refine(Reduced& found, double step);

  Stepper& stepper_;
  System& system_;
  Limits limits_;
  bool tries_newton_ = true;
  std::optional<CrackedEquations> points_;
};

}  // namespace dda
