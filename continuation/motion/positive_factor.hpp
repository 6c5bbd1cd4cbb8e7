#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace dda {

/// Cholesky factor of a symmetric matrix given by its lower triangle: CHOLMOD's L Lᵀ, by supernodes where these pay.
class PositiveFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  PositiveFactor();
  ~PositiveFactor();

  /// Chooses the order of elimination of a pattern.
  void analyse(const Matrix& lower);
  /// Of a matrix with that pattern; false where it is not positive definite.
  bool factorise(const Matrix& lower);
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve_all(const Eigen::MatrixXd& right) const;
  Eigen::Index num_rows() const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace dda
