#include "meshing/mirror.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

/// Whether all pieces lie on the line through the first of them.
bool is_straight(std::span<const BoundarySide> pieces) {
  constexpr double share = 1e-9;  // of the largest distance
  const Vec2 from = pieces.front().start, along = (pieces.front().end - from).normalized();
  double off = 0, size = 0;
  for (const BoundarySide& piece : pieces)
    for (const Vec2& end : {piece.start, piece.end}) {
      off = std::max(off, std::abs(cross(along, end - from)));
      size = std::max(size, (end - from).norm());
    }
  return off <= share * size;
}

}  // namespace

void add_mirror_sides(Assembly& assembly, std::span<const Mirror> mirrors, Findings& findings) {
  for (const Mirror& mirror : mirrors) {
    const auto name = std::ranges::find(assembly.boundaries, mirror.boundary);
    const auto number = static_cast<int>(name - assembly.boundaries.begin());
    const auto pieces = std::ranges::stable_partition(
        assembly.boundary, [&](const BoundarySide& side) { return side.boundary != number; });
    if (name == assembly.boundaries.end() || pieces.empty()) {
      findings.add(mirror.where, name == assembly.boundaries.end()
                                     ? "unknown boundary '" + mirror.boundary + "'" +
                                           suggest(mirror.boundary, assembly.boundaries)
                                     : "boundary '" + mirror.boundary + "' is another interface already");
      continue;
    }
    if (!is_straight(pieces))
      findings.add(mirror.where,
                   "boundary '" + mirror.boundary + "' is no plane of symmetry: it is not straight");
    const auto curve = static_cast<int>(assembly.curves.size());
    assembly.curves.push_back(mirror.curve);
    for (const BoundarySide& piece : pieces)
      assembly.sides.push_back({piece.block, piece.block, piece.start, piece.end, curve});
    assembly.boundary.erase(pieces.begin(), pieces.end());
  }
}

}  // namespace dda
