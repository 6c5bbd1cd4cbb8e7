#pragma once

#include <map>
#include <vector>

#include "meshing/assembly.hpp"

namespace dda {

/// How good the blocks of an assembly are, for `dda check` and the log.
struct Quality {
  std::map<std::size_t, std::size_t> blocks_by_corners;  ///< corners → number of blocks
  std::size_t non_convex = 0;
  double area = 0;           ///< of all blocks [L²]
  double smallest_area = 0;  ///< [L²]
  double largest_area = 0;   ///< [L²]
  double worst_aspect = 1;   ///< √(largest / smallest principal second moment of area); 1 for a square
  double shortest_side = 0;  ///< least of side length / √(block area)

  double area_ratio() const { return largest_area / smallest_area; }
};

Quality assess(const Assembly& assembly);

/// Blocks that hang together through sides, groups and blocks in order of number; more than one group means
/// floating parts.
std::vector<std::vector<BlockId>> connected_groups(const Assembly& assembly);
/// The same by those sides alone that hold, by their number.
std::vector<std::vector<BlockId>> connected_groups(const Assembly& assembly, const std::vector<bool>& holds);

}  // namespace dda
