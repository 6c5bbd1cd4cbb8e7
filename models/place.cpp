#include "models/place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/suggestion.hpp"

namespace dda {
namespace {

/// How far outside its block a point of the deck may lie: round-off of its coordinates [L].
double tolerance(const Assembly& assembly) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Block& block : assembly.blocks)
    for (const Vec2& v : block.outline.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
  return 1e-7 * (high - low).norm();
}

}  // namespace

std::vector<BlockId> blocks_of(const Assembly& assembly, const Place& place, const Position& where) {
  const double tol = tolerance(assembly);
  auto found = blocks_at(assembly, place.at, tol);
  if (found.empty())
    throw InputError(
        where, fmt::format("the point ({:g}, {:g}) lies outside every block; move it onto the structure",
                           place.at.x(), place.at.y()));
  if (!place.inside) return found;
  const auto chosen = blocks_at(assembly, *place.inside, tol);
  std::erase_if(found, [&](BlockId id) { return std::ranges::find(chosen, id) == chosen.end(); });
  if (found.empty())
    throw InputError(where,
                     fmt::format("no block contains both `at` ({:g}, {:g}) and `inside` ({:g}, {:g}); move "
                                 "`inside` closer to `at`, into the block that is meant",
                                 place.at.x(), place.at.y(), place.inside->x(), place.inside->y()));
  return found;
}

Functional displacement_at(const Assembly& assembly, const Place& place, const Vec2& direction,
                           const Position& where) {
  Functional out;
  const auto blocks = blocks_of(assembly, place, where);
  for (const BlockId id : blocks) {
    const Vec2 offset = place.at - assembly.blocks[id.value()].moments.centroid;
    out.rows.emplace_back(
        id, displacement_rows(offset).transpose() * direction / static_cast<double>(blocks.size()));
  }
  return out;
}

std::vector<BoundaryPoint> boundary_points(const Assembly& assembly, const std::string& name,
                                           const Position& where) {
  const auto known = std::ranges::find(assembly.boundaries, name);
  if (known == assembly.boundaries.end())
    throw InputError(where, fmt::format("unknown boundary '{}'{}", name, suggest(name, assembly.boundaries)));
  const int index = static_cast<int>(known - assembly.boundaries.begin());
  std::vector<BoundaryPoint> points;
  for (const BoundarySide& side : assembly.boundary) {
    if (side.boundary != index) continue;
    const Vec2 edge = side.end - side.start;
    const Vec2 normal = Vec2(edge.y(), -edge.x()) / edge.norm();
    for (const double xi : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
      points.push_back({side.block, side.start + xi * edge, normal, 0.5 * edge.norm()});
  }
  return points;
}

}  // namespace dda
