#pragma once

#include "continuation/solve/stepper.hpp"

namespace dda {

/// What TrilinosModule's steps do.
Attempt loca_controlled_step(System& system, const StepGoal& goal, const StepperParameters& parameters);
Attempt loca_arc_length_step(System& system, const State& start, const ArcLength& arc,
                             const StepperParameters& parameters);

}  // namespace dda
