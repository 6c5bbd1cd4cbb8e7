#pragma once

#include "continuation/solve/stepper.hpp"

namespace dda {

/// One step on all unknowns from its guess, iterated multipliers carried over until no gap is left; the
/// control has been started. With a line search the iteration is patient (WholeEquations::Aim).
Attempt whole_step(Stepper& stepper, const StepGoal& goal, Method method);

}  // namespace dda
