#pragma once

#include "continuation/linear/direct/direct_solver.hpp"
#include "continuation/walk/walker.hpp"

namespace dda {

/// A way on from an equilibrium: the direction, and the flags of the points that load along it.
struct Branch {
  Tangent leaving;
  std::vector<History> flags;
  std::optional<int> num_negative;  ///< of the stiffness with these flags

  /// Negative eigenvalues beyond that of a limit point: with any, other branches leave from here as well.
  int surplus() const {
    return num_negative ? std::abs(*num_negative - (leaving.load_factor < 0 ? 1 : 0)) : 0;
  }
};

/// Other branches that leave an equilibrium at which the stiffness, every point on its damage surface
/// loading, has negative eigenvalues beyond the one of a limit point.
///
/// With the negative eigenvectors φ and the direction ḋ along which all of those points load, scaled to unit
/// dissipation c·ḋ = 1,
///
///     ψ = φ − (c·φ) ḋ
///
/// dissipates nothing at first order: along ḋ + a ψ, |a| → ∞, points that ψ opens load and those that it
/// closes unload. Each sign of each ψ gives a set to start from; points that turn back are taken off, points
/// on their surface that would open are added, until the set and its direction agree. Sets that do not
/// settle, or lead to a branch found before, are dropped.
std::vector<Branch> branches_at(System& system, const Candidate& here, const DirectSolverChoice& solver);

}  // namespace dda
