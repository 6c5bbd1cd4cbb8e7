#pragma once

#include <Eigen/Core>
#include <vector>

namespace dda {

/// P A = L U of a square matrix, with row exchanges, by the machine's LAPACK.
class DenseLu {
 public:
  /// False when a pivot is zero or not finite; the factors are then of no use.
  bool compute(Eigen::MatrixXd a);
  /// A⁻¹ B.
  Eigen::MatrixXd solve(Eigen::MatrixXd b) const;

 private:
  Eigen::MatrixXd lu_;
  std::vector<int> exchanges_;  ///< row i was exchanged with row exchanges_[i] − 1, in this order
};

}  // namespace dda
