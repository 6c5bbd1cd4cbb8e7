#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/errors.hpp"
#include "meshing/assembly.hpp"
#include "models/functional.hpp"

namespace dda {

/// A point of the structure given in the deck: where, and which block when several meet there.
struct Place {
  Vec2 at = Vec2::Zero();
  std::optional<Vec2> inside;  ///< a point inside the block that is meant
};

/// Blocks that carry the place, sharing it equally. Throws InputError when it lies outside every block.
std::vector<BlockId> blocks_of(const Assembly& assembly, const Place& place, const Position& where);

/// Mean displacement along `direction` (length kept) of the blocks that meet at the place.
Functional displacement_at(const Assembly& assembly, const Place& place, const Vec2& direction,
                           const Position& where);

/// Points of a named boundary: two Gauss points per side with their share of its length [L].
struct BoundaryPoint {
  BlockId block;
  Vec2 x;
  Vec2 normal;    ///< outward
  double length;  ///< [L]
};
/// Throws InputError listing the names when the boundary does not exist.
std::vector<BoundaryPoint> boundary_points(const Assembly& assembly, const std::string& name,
                                           const Position& where);

}  // namespace dda
