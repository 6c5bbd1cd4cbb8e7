#pragma once

#include <optional>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// The equilibrium to which a structure goes on dynamically while a gauge is held, as in a test that prescribes it:
///
///     K_sec(κ) d = f,  g(d) = ḡ,  with contact and friction solved exactly;      κ ← max(κ, equivalent opening);      and again
///
/// until no opening asks for more damage. Without friction each half of this staggered iteration (alternate minimisation)
/// lowers the energy, and damage only grows, so that it ends; it converges linearly, and near its end Newton's method with all
/// that cracks takes over. Where it is slow damage is grown ahead of what is asked for, by at most 8 % of κ. Nothing when no such
/// equilibrium was found. History and multipliers of the system stay as they are; what was spent on the way is none of an
/// equilibrium path, and booked as a jump.
std::optional<Settled> staggered_at_gauge(Stepper& stepper, const State& start, const WantedGauge& wanted);

}  // namespace dda
