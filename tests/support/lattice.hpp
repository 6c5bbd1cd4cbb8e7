#pragma once

#include <utility>
#include <vector>

#include "framework/base/index.hpp"

namespace dda {

/// Pairs of neighbours among blocks in columns, numbered upwards and column by column.
inline std::vector<std::pair<BlockId, BlockId>> neighbours_in_columns(std::size_t columns, std::size_t rows) {
  std::vector<std::pair<BlockId, BlockId>> out;
  for (std::size_t x = 0; x < columns; ++x)
    for (std::size_t y = 0; y < rows; ++y) {
      const std::size_t block = x * rows + y;
      if (y + 1 < rows) out.emplace_back(BlockId{block}, BlockId{block + 1});
      if (x + 1 < columns) out.emplace_back(BlockId{block}, BlockId{block + rows});
    }
  return out;
}

}  // namespace dda
