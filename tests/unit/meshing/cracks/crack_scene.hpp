#pragma once

#include <Eigen/Geometry>
#include <numbers>

#include "meshing/cracks/crack_geometry.hpp"
#include "meshing/neighbours.hpp"
#include "unit/meshing/scene_example.hpp"

namespace dda {

/// Blocks of one region with who touches whom.
inline Assembly assembly_of(std::vector<Block> blocks) {
  Assembly out;
  out.regions = {{"body", "body"}};
  out.blocks = std::move(blocks);
  Neighbours found = find_neighbours(out.blocks, {});
  out.sides = std::move(found.sides);
  out.boundary = std::move(found.boundary);
  return out;
}

/// x → scale · (R(angle) x + shift), mirrored in y before it on request.
struct Placement {
  double angle = 0;
  Vec2 shift = Vec2::Zero();
  double scale = 1;
  bool is_mirrored = false;

  Vec2 direction(const Vec2& v) const {
    return Eigen::Rotation2Dd(angle) * Vec2(v.x(), is_mirrored ? -v.y() : v.y());
  }
  Vec2 at(const Vec2& x) const { return scale * (direction(x) + shift); }
  Assembly of(const Assembly& assembly) const {
    std::vector<Block> blocks;
    for (const Block& block : assembly.blocks) {
      Polygon outline;
      for (const Vec2& x : block.outline.vertices) outline.vertices.push_back(at(x));
      blocks.push_back(block_of(counter_clockwise(outline).vertices));
    }
    return assembly_of(std::move(blocks));
  }
};

inline Assembly voronoi_beam(int blocks, int seed) {
  return mesh_of(
      "regions: [{material: body, vertices: [[0, 0], [30, 0], [30, 10], [0, 10]]}]\n"
      "subdivision: {type: voronoi, blocks: " +
      std::to_string(blocks) + ", seed: " + std::to_string(seed) + "}\n");
}

/// Cuts block after block along a straight line until it ends; the number of cuts.
inline int run_straight(CrackGeometry& cracks, Vec2 tip, const Vec2& direction) {
  for (int n = 0;; ++n) {
    const auto block = cracks.block_ahead(tip, direction);
    const auto exit = block ? cracks.exit(*block, tip, direction) : std::nullopt;
    if (!exit || !cracks.cut(*block, tip, *exit, 0)) return n;
    tip = *exit;
  }
}

}  // namespace dda
