#pragma once

#include <span>
#include <vector>

#include "models/body/block_matrix.hpp"

namespace dda {

/// The mass of dynamic relaxation: one 6 × 6 block per block of the structure, for a time step of one.
///
///     M_i = γ/4 Σ_j ‖L_i⁻¹ K_ij L_j⁻ᵀ‖ K_ii,        K_ii = L_i L_iᵀ,   γ = 1.2
///
/// By Gershgorin's theorem for block matrices no eigenvalue of M⁻¹ K exceeds 4/γ, and central differences
/// with Δt = 1 are stable below 4. Cracks take stiffness away, K ≤ K0, so the mass of the intact structure
/// serves the whole path; γ leaves room for what the unsymmetric tangent of friction adds. M has the units of
/// K: rotations and strains need no scale of their own.
class FictitiousMass {
 public:
  /// K symmetric with positive definite diagonal blocks: throws std::invalid_argument for any other.
  explicit FictitiousMass(const BlockMatrix& stiffness);

  /// x ← M⁻¹ x, size 6 · blocks.
  void solve(std::span<double> x) const;
  /// M⁻¹ of a block.
  const Mat6& inverse(std::size_t i) const { return inverses_[i]; }

 private:
  std::vector<Mat6> inverses_;
};

}  // namespace dda
