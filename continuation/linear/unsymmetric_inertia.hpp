#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace dda {

/// An unsymmetric stiffness K = H + S, H symmetric and S skew, by what it makes of forces b and motions x. Of
/// updates it is enough to know it at the updated points.
struct UnsymmetricStiffness {
  using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
  Eigen::Index size = 0;
  Operator metric;             ///< forces M x, M symmetric and positive definite
  Operator flexibility;        ///< H⁻¹ b
  Operator whole_flexibility;  ///< K⁻¹ b
  Operator skew_forces;        ///< S x
};

/// How many eigenvalues of K φ = μ |H| φ are real and negative, by p = n₋(H), which must be known: the
/// motions that diverge from the equilibrium under dead load. |H| is H with the sign of p motions X = H⁻¹ b
/// reversed, for p forces b under which H softens, bᵀ H⁻¹ b < 0; of a symmetric K the number is p. With
///
///     C = bᵀ K⁻¹ b,  p × p,     q = n₋(sym C),     sign det C = sign det K
///
///     p = 0            none, nor any with a negative real part, whatever the metric (Bendixson; the
///                      second-order work of every motion is positive, Hill)
///     q = 0            none: in coordinates with H = diag(−1, 1), (1 + s) sym T(−s) of the Schur complement
///                      T(μ) of K − μ |H| on the p motions grows with s, and sym T(0) is congruent to sym C
///     q = 1, det < 0   one; p = 1: the real parts sum to n − 2 and none exceeds 1, so that one at most is
///                      negative, and the sign of the determinant says whether it is
///     p = q > 1        p, if bᵀ H⁻¹ b + XᵀSᵀ (H⁻¹ + |V V|) S X < 0, V V = X (−bᵀ X)⁻¹ Xᵀ: then G K with
///                      G = diag(−1, 1) has a positive definite symmetric part (Lyapunov; Ostrowski and
///                      Schneider 1962)
///
/// Nothing where none of these decides, where no such b is found, or where only weak springs hold the structure.
std::optional<int> num_negative_eigenvalues(const UnsymmetricStiffness& k, int of_symmetric_part);

}  // namespace dda
