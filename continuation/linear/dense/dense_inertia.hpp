#pragma once

#include <Eigen/Core>
#include <optional>

namespace dda {

/// How many eigenvalues of a symmetric matrix are above zero, from the pivots of A = L D Lᵀ, 1 × 1 and 2 × 2
/// (Bunch-Kaufman, by the machine's LAPACK; Sylvester's law of inertia). Nothing when A is singular.
std::optional<int> num_positive_eigenvalues(Eigen::MatrixXd a);

}  // namespace dda
