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
  /// More than `most_points` are not tried: dense equations grow with the third power.
  ContactSolver(Stepper& stepper, const State& near, std::size_t most_points)
      : stepper_(stepper), system_(stepper.system()), most_points_(most_points) {
    prepare(near);
  }

  /// Walks begin at the start of the step: between it and what is wanted they are equilibria of the path.
  /// Nothing with initial stress, where no joint is in contact, where more than `most_points` points would
  /// take part, and where there is no equilibrium.
  std::optional<Reduced> solve(const StepGoal& goal);
  /// Whether to walk at once, as where Newton's method has ended far away on a singular matrix.
  void try_newton(bool on) { tries_newton_ = on; }
  /// Whether the last call has walked at once.
  bool has_walked() const { return !tries_newton_ || (points_ && points_->only_touch()); }

 private:
  void prepare(const State& near);
  std::optional<Reduced> solve_sum(const ControlSum& sum, const StepGoal& goal, const State& guess);
  std::optional<Reduced> iterate(const State& start, const State& guess, double step);
  std::optional<Reduced> solve_from(const Iterate& at, double step, Method method);
  void refine(Reduced& found, double step);

  Stepper& stepper_;
  System& system_;
  std::size_t most_points_;
  bool tries_newton_ = true;
  std::optional<CrackedEquations> points_;
};

}  // namespace dda
