#pragma once

#include <Eigen/LU>
#include <memory>
#include <span>
#include <vector>

#include "continuation/linear/direct_solver.hpp"
#include "models/equilibrium.hpp"

namespace dda {

/// The tangent of an equilibrium, factorised once and updated where points crack.
///
///     K = K_base + Uᵀ E U,     U = rows B of the changed points,  E = W (D − D_base), 2 × 2 per point
///     K⁻¹ b = y − Z (1 + E G)⁻¹ E U y,   y = K_base⁻¹ b,  Z = K_base⁻¹ Uᵀ,  G = U Z
///
/// Sherman-Morrison-Woodbury; columns of Z are computed when a point first changes and kept. `rebase` folds a
/// stiffness into K_base and starts again, which pays when many points have changed.
class LinearSystem {
 public:
  enum class Update { low_rank, refactorise };

  LinearSystem(const Equilibrium& equilibrium, const DirectSolverChoice& solver, Update update);

  /// Makes K the tangent with these D, 2 × 2 per crackable point. False when K is numerically singular.
  bool set_tangent(std::span<const Mat2> tangents);
  /// x = K⁻¹ b, both of size n.
  void solve(std::span<const double> b, std::span<double> x);
  /// y = K x.
  void multiply(std::span<const double> x, std::span<double> y) const;

  /// K_base⁻¹ of this vector (or of its negative) is computed once per base.
  void keep_solution_of(std::vector<double> b);

  /// Folds the stiffnesses into K_base. False when singular.
  bool rebase(std::span<const Mat2> tangents);
  /// Whether so many points have changed that a new base is cheaper: decided by counts, never by clocks.
  bool wants_rebase() const;

  /// What a restart must bring back: stiffness of the base, and the points whose columns are kept, in their order.
  const std::vector<Mat2>& base() const { return base_; }
  const std::vector<std::size_t>& updated_points() const { return updated_; }
  bool restore(std::span<const Mat2> base, std::span<const std::size_t> updated);

  std::size_t num_factorisations() const { return num_factorisations_; }
  std::size_t num_solves() const { return num_solves_; }

 private:
  std::size_t n() const { return equilibrium_.num_unknowns(); }
  void add_columns(std::size_t point);
  bool factor_small();
  void base_solve(std::span<const double> b, std::span<double> x);
  Vec2 rows_times(std::size_t point, std::span<const double> x) const { return equilibrium_.opening(point, x); }
  BlockMatrix matrix_with(std::span<const Mat2> tangents) const;

  const Equilibrium& equilibrium_;
  std::unique_ptr<DirectSolver> solver_;
  Update update_;
  std::vector<Mat2> base_, tangent_;
  std::vector<std::size_t> updated_;   ///< points with columns in z_, in order
  std::vector<int> slot_;              ///< point → index in updated_, −1 when none
  std::vector<double> z_;              ///< columns of K_base⁻¹ Uᵀ, n × 2 per updated point
  Eigen::MatrixXd g_;                  ///< U K_base⁻¹ Uᵀ, at least 2 · updated square
  std::vector<std::size_t> active_;    ///< updated points with E ≠ 0 now
  Eigen::PartialPivLU<Eigen::MatrixXd> small_;
  std::vector<double> kept_, kept_solution_;
  std::size_t num_factorisations_ = 0, num_solves_ = 0;
};

}  // namespace dda
