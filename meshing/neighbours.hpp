#pragma once

#include <vector>

#include "meshing/assembly.hpp"

namespace dda {

/// What a named line of the scene is for.
enum class LineRole {
  interface,  ///< gives the sides on it the interface of that name
  boundary,   ///< gives the boundary pieces on it the boundary of that name
  slit        ///< blocks are not joined across it: a notch of zero width
};

/// A straight piece of a named line; `name` is an index into Assembly::curves or ::boundaries (unused for
/// slits).
struct LinePiece {
  LineRole role = LineRole::interface;
  int name = 0;
  Vec2 start, end;
};

/// Who touches whom, and what is left over. `used[i]` says whether line piece i lies on any side at all.
struct Neighbours {
  std::vector<Side> sides;             ///< in order of (first, place along its outline)
  std::vector<BoundarySide> boundary;  ///< in order of (block, place along its outline)
  std::vector<bool> used;
};

/// Finds every piece of contact between two blocks from their outlines alone.
///
/// Two edges of different blocks touch where they are collinear, opposite and overlap: the distance of
/// either from the line of the other is below 1e-9 of the scene's size. An edge may touch several blocks
/// (T-joints). Pieces shorter than 1e-6 of the shorter edge are dropped. `first` is the lower block number.
/// Line pieces are matched with the same tolerance and split the sides they end on.
/// Cost: O(n) for edges of similar length (uniform grid).
Neighbours find_neighbours(const std::vector<Block>& blocks, const std::vector<LinePiece>& lines);

}  // namespace dda
