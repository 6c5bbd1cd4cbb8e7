#pragma once

#include <span>
#include <vector>

#include "meshing/cracks/crack_geometry.hpp"

namespace dda {

/// What cracks have made of an assembly: every part of a cut block is a block.
struct Parted {
  /// Where a block of it comes from.
  struct Piece {
    BlockId whole;
    std::vector<JumpId> jumps;  ///< by which it moves beside the block it is of
  };

  Assembly assembly;
  std::vector<Piece> pieces;                       ///< of each of its blocks
  std::vector<std::vector<std::size_t>> of_whole;  ///< its blocks, by the block they are of

  /// The one of these that moves by these jumps.
  std::size_t at(BlockId whole, std::span<const JumpId> jumps) const;
};

/// Parts of a block come where the block was, in their order; regions, names and points stay.
Parted parted(const CrackGeometry& cracks);

}  // namespace dda
