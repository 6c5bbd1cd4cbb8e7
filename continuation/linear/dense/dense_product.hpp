#pragma once

#include <Eigen/Core>

namespace dda {

/// Aᵀ B, by the machine's BLAS.
Eigen::MatrixXd product_of_transpose(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                     const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace dda
