#pragma once

#include <string>
#include <vector>

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// A load or support that acts at one point, and the blocks that bear it there.
struct Bearing {
  std::string name;  ///< "support 'left' at (0, 0)"
  Vec2 at = Vec2::Zero();
  Position where;
  std::vector<BlockId> blocks;
};

/// The point loads, driven points and point supports of a deck. Patches and boundaries are none.
std::vector<Bearing> bearings_of(const Simulation& simulation);

/// Bearings on few small blocks that only crackable sides hold, one warning each: such blocks may be torn out
/// before the structure fails, and the peak is then theirs. Each proposes a patch (`over`).
std::vector<std::string> tearing_warnings(const Simulation& simulation);

/// √area of the blocks, in the mean [L].
double size_of(const Assembly& assembly, const Bearing& bearing);

/// "spread it over several blocks: `over: [[0, 0], [40, 0]]` instead of `at`": about the point, some six
/// blocks wide, on the longest straight boundary there.
std::string patch_proposal(const Assembly& assembly, const Bearing& bearing);

/// Area [L²], and whether a block is among others.
double area_of(const Assembly& assembly, const std::vector<BlockId>& blocks);
bool is_member(const std::vector<BlockId>& blocks, BlockId id);

/// Area of all blocks that hang together with one [L²].
double area_around(const Assembly& assembly, BlockId id);

/// Of what hangs together: more is a part of the structure, not a piece that is torn out of it.
inline constexpr double small_share = 0.05;

}  // namespace dda
