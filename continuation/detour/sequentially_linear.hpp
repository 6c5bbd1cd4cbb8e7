#pragma once

#include <optional>

#include "continuation/state/system.hpp"

namespace dda {

/// Sequentially linear steps from an equilibrium until `quantum` more energy has been dissipated [FL], or as
/// far as they lead.
///
///     K_sec(κ) d̂ = ∂f/∂λ
///     K_sec d_dead = f_dead − Bᵀ W (t − D_sec q)
///     λ = largest load factor at which no unbroken point exceeds its κ
///     κ of the point that decides grows by 8 %, capped at rupture, what slides has slid; and again
///
/// with t ≠ D_sec q only where friction has slid. Joints whose multipliers are iterated have their own
/// stiffness p̄ in K_sec; what that leaves open is carried over until it leaves no gap.
/// For laws that unload to the origin every such state is an admissible equilibrium, whatever Newton says;
/// K_sec is positive definite without friction. The way between them is no equilibrium path: its energy is
/// booked as a jump. Nothing when no point limits the load or the contact set of the first state does not
/// settle.
std::optional<Settled> sequentially_linear(System& system, const State& start, double quantum);

}  // namespace dda
