#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

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

  /// w = L⁻¹ P b, P the order of elimination: bᵀ A⁻¹ b is wᵀ w. Where b has few entries w has not many.
  struct Half {
    using Span = std::pair<Eigen::Index, Eigen::Index>;  ///< begin, size
    Eigen::VectorXd values;
    std::vector<Span> spans;  ///< outside these it is zero

    double dot(const Half& other) const;
    void add_to(Eigen::VectorXd& sum, double factor) const;
  };
  /// Several threads may call this.
  Half half_of(const Eigen::VectorXd& right) const;
  /// Pᵀ L⁻ᵀ w: the other half of a solution.
  Eigen::VectorXd other_half_of(Eigen::VectorXd w) const;
  Eigen::Index num_rows() const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace dda
