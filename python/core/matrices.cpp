#include "python/core/matrices.hpp"

namespace dda::python {

BlockRows block_rows(const BlockMatrix& matrix) {
  BlockRows out;
  out.columns.assign(matrix.columns().begin(), matrix.columns().end());
  out.starts.assign(matrix.row_start().begin(), matrix.row_start().end());
  out.data.reserve(36 * matrix.num_stored());
  for (std::size_t slot = 0; slot < matrix.num_stored(); ++slot) {
    const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> block = matrix.value(slot);
    out.data.insert(out.data.end(), block.data(), block.data() + block.size());
  }
  return out;
}

}  // namespace dda::python
