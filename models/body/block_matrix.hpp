#pragma once

#include <span>
#include <utility>
#include <vector>

#include "framework/base/index.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// Sparse matrix of 6 × 6 blocks, compressed by rows: block row r holds columns()[row_start()[r] …
/// row_start()[r+1]). The pattern (every diagonal block and both halves of each pair) is fixed at
/// construction. Rows from num_leading() on are multipliers: coupled with leading rows only.
class BlockMatrix {
 public:
  BlockMatrix(std::size_t num_rows, std::vector<std::pair<BlockId, BlockId>> pairs)
      : BlockMatrix(num_rows, std::move(pairs), num_rows) {}
  BlockMatrix(std::size_t num_rows, std::vector<std::pair<BlockId, BlockId>> pairs, std::size_t num_leading);

  std::size_t num_rows() const { return row_start_.size() - 1; }
  std::size_t num_leading() const { return num_leading_; }
  std::size_t num_stored() const { return columns_.size(); }
  const std::vector<std::size_t>& row_start() const { return row_start_; }
  const std::vector<std::size_t>& columns() const { return columns_; }
  const Mat6& value(std::size_t slot) const { return values_[slot]; }

  /// Adds m to the block (i, j), which must be in the pattern.
  void add(BlockId i, BlockId j, const Mat6& m) { values_[slot(i, j)] += m; }
  /// y += A x; x and y of length 6 · num_rows().
  void multiply_add(std::span<const double> x, std::span<double> y) const;
  /// y += |A| |x|: what rounding in A x is relative to.
  void multiply_add_absolute(std::span<const double> x, std::span<double> y) const;

 private:
  std::size_t slot(BlockId i, BlockId j) const;

  std::size_t num_leading_;
  std::vector<std::size_t> row_start_;
  std::vector<std::size_t> columns_;
  std::vector<Mat6> values_;
};

}  // namespace dda
