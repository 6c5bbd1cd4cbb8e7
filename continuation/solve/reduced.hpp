#pragma once

#include <functional>
#include <optional>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// What was found on the cracked points alone.
struct Reduced {
  State state;
  std::vector<double> x;  ///< of the cracked points
  bool converged = true;
  int iterations = 0;
  double residual = 0;  ///< ‖R‖, from the cracked points alone [F]
};

/// Newton's method on the cracked points alone (CrackedEquations). The state that is found is
/// looked at in full: points that crack there are taken in and the iteration starts again from the guess, so
/// that it goes the way of Newton's method for all unknowns. It is a better guess and no more: equilibrium is
/// judged by the full residual. Nothing where the points' equations are none of all: where no base is kept, with
/// initial stress or iterated multipliers, and where more points crack than a base bears beside it.
std::optional<Reduced> solve_reduced(Stepper& stepper, const StepGoal& goal);

/// Under a control that looks at every point: its tangent is a gauge, taken anew at each state that `solve` has found
/// with the one before prescribed, from where the last has ended. Nothing where that finds nothing.
std::optional<Reduced> solve_tangents(
    System& system, const StepGoal& goal,
    const std::function<std::optional<Reduced>(const ControlSum& sum, const State& guess)>& solve);

/// Whether joints have come to lie much farther from the guess than this is from the start of the step: beside contact
/// Newton's method may end on another path.
bool strays(const System& system, const State& found, const State& start, const State& guess);
/// Points without columns that are not as in the base at a state.
std::vector<std::size_t> newly_cracked(System& system, const LinearSystem& linear, const State& at);
/// Points that are not held at a state as in the intact structure.
std::size_t num_changed(System& system, const State& at);
/// Those among them that were bonded.
std::size_t num_cracked(System& system, const State& at);

}  // namespace dda
