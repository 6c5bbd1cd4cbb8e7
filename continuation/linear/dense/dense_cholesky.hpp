#pragma once

#include <Eigen/Core>

namespace dda {

/// A = L Lᵀ of a symmetric positive definite matrix, by the machine's LAPACK: its lower triangle becomes L. False when
/// a pivot is not positive.
bool factor_cholesky(Eigen::MatrixXd& a);

/// L becomes the lower triangle of L Lᵀ.
void square_of_factor(Eigen::MatrixXd& l);

/// B ← B L⁻ᵀ.
void divide_by_transpose(const Eigen::MatrixXd& l, Eigen::MatrixXd& b);

/// The lower triangle of A −= B Bᵀ.
void subtract_square(const Eigen::MatrixXd& b, Eigen::MatrixXd& a);

}  // namespace dda
