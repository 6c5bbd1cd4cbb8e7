#pragma once

#include "continuation/solve/stepper.hpp"

namespace dda {

/// One step with contact and friction solved exactly (reduced.hpp), iterated multipliers carried over until
/// no gap is left; the control has been started, and `guess` is where the search begins.
Attempt contact_step(System& system, const State& start, const ControlEquation& control, double step,
                     const State& guess, const StepperParameters& parameters, Thoroughness thoroughness);

}  // namespace dda
