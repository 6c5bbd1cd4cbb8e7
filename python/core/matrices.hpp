#pragma once

#include <vector>

#include "models/body/block_matrix.hpp"

namespace dda::python {

/// A BlockMatrix as scipy.sparse.bsr_matrix takes it: blocks 6 × 6 by rows, one after another.
struct BlockRows {
  std::vector<double> data;           ///< 36 per block
  std::vector<std::int64_t> columns;  ///< of each block
  std::vector<std::int64_t> starts;   ///< of each row among the blocks, and the end
};

BlockRows block_rows(const BlockMatrix& matrix);

}  // namespace dda::python
