#pragma once

#include <optional>

#include "continuation/contact/cracked_points.hpp"
#include "continuation/solve/reduced.hpp"

namespace dda {

/// How contacts are solved.
struct ContactSettings {
  int max_iterations = 15;
  std::size_t most_points = 1500;  ///< more are not tried: dense equations grow with the third power
  double tolerance = 1e-9;         ///< of the equations of the whole structure, relative
};

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
  ContactSolver(System& system, const State& near, const ContactSettings& settings)
      : system_(system), settings_(settings) {
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
  std::optional<Reduced> solve_sum(const ControlSum& sum, const State& start, const State& guess);
  std::optional<Reduced> solve_tangents(const StepGoal& goal);
  std::optional<int> iterate(const State& start, const State& guess);
  void refine(Reduced& found);

  System& system_;
  ContactSettings settings_;
  bool tries_newton_ = true;
  std::optional<CrackedPoints> points_;
};

}  // namespace dda
