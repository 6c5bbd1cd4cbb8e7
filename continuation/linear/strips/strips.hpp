#pragma once

#include <span>
#include <vector>

#include "models/body/block_matrix.hpp"

namespace dda {

/// The blocks of a structure in strips, one behind the other, and what lies between each two and keeps them apart:
///
///     strip 0 | between 0 | strip 1 | between 1 | …
///
/// No block of a strip is coupled with one of another strip, nor what lies between two with what lies between two
/// others.
struct Strips {
  std::vector<std::vector<std::size_t>> strips;   ///< blocks of each, ascending
  std::vector<std::vector<std::size_t>> between;  ///< one less

  /// What a strip is coupled with: before it, then behind it.
  std::vector<std::size_t> border_of(std::size_t strip) const;
};

/// Divides by levels of neighbours (George 1971): the blocks at distance 0, 1, 2, … from one at an end of the
/// structure. Each strip has about its share of the blocks, and between two of them lie blocks of the smallest
/// level near there. Fewer strips than shares where there are too few levels.
Strips strips_of(const BlockMatrix& a, std::span<const double> shares);

}  // namespace dda
