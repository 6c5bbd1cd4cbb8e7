#include "models/body/block_matrix.hpp"

#include <algorithm>
#include <cassert>

#include "framework/base/threads.hpp"

namespace dda {
namespace {

constexpr std::size_t rows_at_once = 2000;

}  // namespace

BlockMatrix::BlockMatrix(std::size_t num_rows, std::vector<std::pair<BlockId, BlockId>> pairs,
                         std::size_t num_leading)
    : num_leading_(num_leading) {
  const std::size_t given = pairs.size();
  for (std::size_t p = 0; p < given; ++p) pairs.emplace_back(pairs[p].second, pairs[p].first);
  for (std::size_t i = 0; i < num_rows; ++i) pairs.emplace_back(BlockId{i}, BlockId{i});
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  row_start_.assign(num_rows + 1, 0);
  for (const auto& [row, column] : pairs) {
    ++row_start_[row.value() + 1];
    columns_.push_back(column.value());
  }
  for (std::size_t r = 0; r < num_rows; ++r) row_start_[r + 1] += row_start_[r];
  values_.assign(columns_.size(), Mat6::Zero());
}

std::size_t BlockMatrix::slot(BlockId i, BlockId j) const {
  const auto first = columns_.begin() + static_cast<std::ptrdiff_t>(row_start_[i.value()]);
  const auto last = columns_.begin() + static_cast<std::ptrdiff_t>(row_start_[i.value() + 1]);
  const auto found = std::lower_bound(first, last, j.value());
  assert(found != last && *found == j.value());
  return static_cast<std::size_t>(found - columns_.begin());
}

void BlockMatrix::multiply_add(std::span<const double> x, std::span<double> y) const {
  parallel_for(num_rows(), rows_at_once, [&](std::size_t r) {
    Vec6 sum = Vec6::Zero();
    for (std::size_t s = row_start_[r]; s < row_start_[r + 1]; ++s)
      sum.noalias() += values_[s] * Eigen::Map<const Vec6>(x.data() + 6 * columns_[s]);
    Eigen::Map<Vec6>(y.data() + 6 * r) += sum;
  });
}

void BlockMatrix::multiply_add_absolute(std::span<const double> x, std::span<double> y) const {
  parallel_for(num_rows(), rows_at_once, [&](std::size_t r) {
    Vec6 sum = Vec6::Zero();
    for (std::size_t s = row_start_[r]; s < row_start_[r + 1]; ++s)
      sum.noalias() += values_[s].cwiseAbs() * Eigen::Map<const Vec6>(x.data() + 6 * columns_[s]).cwiseAbs();
    Eigen::Map<Vec6>(y.data() + 6 * r) += sum;
  });
}

}  // namespace dda
