#pragma once

#include "continuation/solve/stepper.hpp"

namespace dda {

/// One step with contact and friction solved exactly (contact_solver.hpp), iterated multipliers carried over
/// until no gap is left; the control has been started.
Attempt contact_step(Stepper& stepper, const StepGoal& goal, Thoroughness thoroughness);

/// Up to so many cracked points it is tried before Newton's method on all unknowns.
inline constexpr std::size_t few_cracked = 200;

/// Points that may take part in it: everywhere where bodies touch that were never bonded, and elsewhere few
/// until shorter steps have not helped, since their dense equations grow with the third power.
std::size_t most_contacts(const System& system, Thoroughness thoroughness);

}  // namespace dda
