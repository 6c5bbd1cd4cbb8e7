#pragma once

#include "continuation/equation/control_equation.hpp"

namespace dda {

/// What one step is to find: the equilibrium where a control's equation holds at s = `step`.
struct StepGoal {
  const State& start;  ///< the equilibrium where the step begins, s = 0
  ControlEquation& control;
  double step = 0;
  const State& guess;  ///< where the search begins
  /// Whether equilibrium is judged by the full residual, whatever unknowns it is found in.
  bool is_audited = true;
};

}  // namespace dda
