#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/base/index.hpp"
#include "meshing/geometry/polygon.hpp"

namespace dda {

/// One block: its outline, the integrals over it, and the material region it was cut from.
struct Block {
  Polygon outline;
  Moments moments;
  int region = 0;  ///< index into Assembly::regions
};

/// A straight piece of contact between two blocks.
///
/// Walks counter-clockwise along the outline of `first`: s = (end − start)/length is the tangent and
/// n = (s_y, −s_x) the normal, outward of `first`. A side of a block that touches two neighbours (a T-joint)
/// gives two pieces. On a plane of symmetry `second` is `first`: what lies behind is the block's mirror image.
struct Side {
  BlockId first, second;
  Vec2 start, end;
  std::optional<int> curve;  ///< index into Assembly::curves when the piece lies on a named interface

  bool is_mirror() const { return first == second; }
};

/// A straight piece of the outer boundary, counter-clockwise along its block.
struct BoundarySide {
  BlockId block;
  Vec2 start, end;
  std::optional<int> boundary;  ///< index into Assembly::boundaries when it lies on a named boundary
};

/// A part of the scene of one material; its blocks are joined to each other.
struct Region {
  std::string name;
  std::string material;
};

/// What meshing makes and mechanics reads: blocks and who touches whom. Immutable once built.
struct Assembly {
  std::vector<Region> regions;
  std::vector<std::string> curves;      ///< names of interfaces
  std::vector<std::string> boundaries;  ///< names of outer boundaries
  std::map<std::string, Vec2> points;   ///< that the deck may name
  std::vector<Block> blocks;
  std::vector<Side> sides;
  std::vector<BoundarySide> boundary;

  std::size_t num_blocks() const { return blocks.size(); }
};

/// Blocks whose closed outline contains x within `tolerance` [L], in order of number.
std::vector<BlockId> blocks_at(const Assembly& assembly, const Vec2& x, double tolerance);

}  // namespace dda
