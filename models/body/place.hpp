#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/base/errors.hpp"
#include "framework/deck/document/spot.hpp"
#include "models/body/body.hpp"
#include "models/body/functional.hpp"

namespace dda {

/// A place of the structure given in the deck: a point, or a straight patch of the boundary over which what
/// acts is spread evenly.
struct Place {
  std::optional<Spot> at;      ///< the point
  std::optional<Spot> inside;  ///< a point inside the block that is meant, or on its side of a slit
  std::optional<std::vector<Spot>> over;  ///< both ends of the patch
};

/// Coordinates of a spot. Throws InputError where the scene names no such point.
Vec2 locate(const Assembly& assembly, const Spot& spot);

/// Blocks that carry the point `at`, sharing it equally. Throws InputError when it lies outside every block.
std::vector<BlockId> blocks_of(const Assembly& assembly, const Place& place, const Position& where);

/// Mean displacement along `direction` (length kept): of the blocks that meet at the point, or over the
/// patch,
///
///     l·ū = 1/L ∫ l·u ds,     dual to the traction F/(L · thickness) of a force F
///
/// exact with two Gauss points per piece of a side.
Functional displacement_at(const Body& body, const Place& place, const Vec2& direction,
                           const Position& where);

/// Mean rotation of the patch, that of the straight line closest to n·u: 12/L³ ∫ s n·u ds, s from its middle.
Functional rotation_over(const Body& body, const Place& place, const Position& where);

/// A functional with the length of the patch that it stands for [L].
using PartOfPatch = std::pair<Functional, double>;

/// By how much each point of a patch departs from the straight line closest to n·u [L]:
///
///     dᵢ = n·uᵢ − ū − sᵢ θ̄,     Σ Lᵢ dᵢ = Σ Lᵢ sᵢ dᵢ = 0
///
/// with its mean and its mean rotation. Each knows of all blocks there. Throws InputError beyond 400 points.
std::vector<PartOfPatch> departures_over(const Body& body, const Place& place, const Position& where);

/// A point on the boundary with its share of the length; two Gauss points per straight piece.
struct BoundaryPoint {
  BlockId block;
  Vec2 x;
  Vec2 normal;    ///< outward
  double length;  ///< [L]
};

/// Points of a named boundary, of every piece into which cuts divide a side. Throws InputError listing the names
/// when the boundary does not exist.
std::vector<BoundaryPoint> boundary_points(const Body& body, const std::string& name, const Position& where);

/// The same of whole sides, for springs: they stay where they are when a cut ends on their side, and hold the part of
/// the block that they stand on.
std::vector<BoundaryPoint> held_points(const Body& body, const std::string& name, const Position& where);

/// Points of the patch, piece by piece along the sides of the blocks. Throws InputError unless outer sides of
/// blocks cover the straight line between its ends exactly once; `inside` chooses between the faces of a
/// slit.
std::vector<BoundaryPoint> patch_points(const Body& body, const Place& place, const Position& where);

}  // namespace dda
