#pragma once

#include <optional>

#include "continuation/system.hpp"

namespace dda {

/// Sequentially linear steps from an equilibrium until `quantum` more energy has been dissipated [FL].
///
///     K_sec(κ) d̂ = ∂f/∂λ,  K_sec d_dead = f_dead      positive definite
///     λ = largest load factor at which no unbroken point exceeds its κ
///     κ of the point that decides grows by 8 %, capped at rupture; and again
///
/// For laws that unload to the origin every such state is an admissible equilibrium, whatever Newton says.
/// The way between them is no equilibrium path: its energy is booked as a jump. Nothing when no point limits
/// the load or the contact set of an intermediate state does not settle.
std::optional<Settled> sequentially_linear(System& system, const State& start, double quantum);

}  // namespace dda
