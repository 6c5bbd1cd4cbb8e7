#pragma once

#include <Eigen/Core>

#include "models/body/block_matrix.hpp"

namespace dda {

/// All entries of a block matrix.
inline Eigen::MatrixXd dense(const BlockMatrix& a) {
  const auto n = static_cast<Eigen::Index>(6 * a.num_rows());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s)
      out.block<6, 6>(static_cast<Eigen::Index>(6 * r), static_cast<Eigen::Index>(6 * a.columns()[s])) =
          a.value(s);
  return out;
}

}  // namespace dda
