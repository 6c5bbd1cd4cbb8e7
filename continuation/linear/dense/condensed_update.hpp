#pragma once

#include <Eigen/Core>
#include <vector>

#include "continuation/linear/dense/dense_lu.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// (1 + G E) x = b for one E after another, 2 × 2 per point, with G fixed: points whose E stays what it was are
/// eliminated once (static condensation), so that an iteration costs what changes.
///
///     1 + G E = H (1 + M ΔE),     H = 1 + G E₀,     M = H⁻¹ G,     ΔE = E − E₀
///
/// E₀ is the first E of the steady points S, and zero at all others. At the points C that change, among them what
/// has turned out not to be steady,
///
///     (1 + M_CC ΔE) x_C = (H⁻¹ b)_C,     x = H⁻¹ b − M ΔE x_C
class CondensedUpdate {
 public:
  using Matrix = Eigen::MatrixXd;

  /// G, at least as large as the first E says.
  explicit CondensedUpdate(const Matrix& couplings) : g_(couplings) {}

  /// Eliminates the steady points, where there are enough of them.
  void begin(const std::vector<Mat2>& e, const std::vector<bool>& is_steady);
  void set(const std::vector<Mat2>& e);
  /// x ← (1 + G E)⁻¹ x. Refined, and by all points at once where the steady ones alone leave too little.
  void solve(Matrix& x);
  /// x −= G E y.
  void subtract_product(const Matrix& y, Matrix& x) const;

 private:
  using Points = std::vector<std::size_t>;

  bool eliminate(const std::vector<Mat2>& e, const std::vector<bool>& is_steady);
  void forget();
  /// They are in C from now on.
  void add_changing(const Points& points);
  void fill_changing(std::size_t first);
  /// x at the points of S and C for these b.
  Matrix condensed(const Matrix& b) const;
  double refine(const Matrix& b, Matrix& x) const;
  bool is_known(std::size_t point) const { return place_[point] >= 0 || is_changing_[point]; }
  Matrix couplings(const Points& rows, const Points& columns) const;

  const Matrix& g_;
  std::vector<Mat2> e_, e_steady_;  ///< E, E₀
  Points steady_, changing_;        ///< S, C
  Points outside_;                  ///< places in C of what is not in S
  std::vector<int> place_;          ///< point → place in S, −1 when none
  std::vector<bool> is_changing_;
  DenseLu lu_;           ///< of H_SS
  Matrix to_steady_;     ///< M_SC
  Matrix from_outside_;  ///< (G E₀)ᵀ of the points outside, a row per component of S
  Matrix between_;       ///< M_CC
  DenseLu small_;        ///< of 1 + M_CC ΔE
};

}  // namespace dda
