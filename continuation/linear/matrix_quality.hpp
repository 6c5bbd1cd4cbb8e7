#pragma once

#include "models/body/block_matrix.hpp"

namespace dda {

/// How well systems with a symmetric matrix A can be solved.
///
/// All numbers are those of the matrix scaled to a diagonal of ones, which does not depend on units:
///
///     Â = S A S,     S = diag(1/√|a_ii|), or what makes the row's largest entry 1 where a_ii = 0
///
/// A single block that nothing but weak springs holds is therefore well conditioned; two such blocks that
/// hang together are not.
struct MatrixQuality {
  /// ‖Â‖₁ ‖Â⁻¹‖₁, the second norm estimated from below, seldom by more than a factor of 3 (N. J. Higham, *ACM
  /// Transactions on Mathematical Software* 14 (1988) 381–396). Infinite beyond 1/ε = 4.5·10¹⁵, where
  /// round-off decides.
  double condition = 0;
  /// Magnitudes of the pivots of Â = LDLᵀ in the order in which MUMPS eliminates; null ones, below ε ‖Â‖₁, do
  /// not count.
  double smallest_pivot = 0;
  double largest_pivot = 0;
  /// Eigenvalues μ of Â below −τ, and those with |μ| < τ, τ = 10⁻¹³ ‖Â‖₁. The second are rigid motions and
  /// mechanisms, also those that weak springs of the default stiffness hold.
  int negative_pivots = 0;
  int null_pivots = 0;
};

/// Factorises three times: Â, and Â ± τ, whose negative pivots are as many as their negative eigenvalues.
/// (The pivots of Â itself do not show how singular it is: where round-off makes the eigenvalue of a rigid
/// motion z some ε, it makes the pivot at unknown i some ε |z|²/z_i².) Only the lower triangle is factorised.
/// Needs an MPI session; throws std::runtime_error when MUMPS runs out of memory.
MatrixQuality assess(const BlockMatrix& a);

/// Eigenvalues of Â within ±τ: of a matrix with exact multipliers, those of the redundant ones.
/// Factorises twice.
int num_redundant(const BlockMatrix& a);

}  // namespace dda
