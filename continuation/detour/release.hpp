#pragma once

#include <optional>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// Instantaneous release of points whose law loses its strength at once.
///
/// A point at its strength loses it along a straight path: its opening q is held (the component that its law
/// names) while what it loses runs linearly to zero and the load factor is free. When another point reaches
/// its strength on the way, the piece ends there; from then on all of them run to zero together and the
/// newest one is held. So the path is piecewise linear, and every vertex of it is found as the solution of an
/// equation, whatever the step size. The result depends on the size of the blocks; no objective peak is
/// claimed for it.

/// Whether a point stands at its strength or is partly released.
bool is_release_pending(const System& system);

/// A piece of the path along which points are released.
struct ReleasedPiece {
  Settled end;
  bool is_straight = true;  ///< asked only where the load factor changes its sign
};

/// How far a piece of a release may go, and what stays meanwhile.
struct ReleaseAim {
  const Functional* held = nullptr;  ///< none: the pending points' own opening; load control holds the load
  double most = 1;                   ///< share of what pending points still bear
};

/// Next vertex of a release from an equilibrium: all pending points released, or the next point at its
/// strength, or as far as is aimed at. Nothing when there is no equilibrium.
std::optional<ReleasedPiece> release_piece(Stepper& stepper, const State& start, const ReleaseAim& aim);

/// Everything pending released in full at a load factor given, and whatever is beyond its strength there: a
/// release that no continuous path leads through, because friction turns over on the way, jumps to an
/// equilibrium behind it. Nothing when there is none.
std::optional<Settled> release_at_load(Stepper& stepper, const State& start, double load_factor);

/// The same with the load factor free and a gauge held at a value.
std::optional<Settled> release_at_gauge(Stepper& stepper, const State& start, const WantedGauge& wanted);

}  // namespace dda
