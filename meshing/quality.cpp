#include "meshing/quality.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "framework/base/disjoint_sets.hpp"

namespace dda {
namespace {

double aspect(const Block& block) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(block.moments.second,
                                                                 Eigen::EigenvaluesOnly);
  return std::sqrt(principal.eigenvalues()[1] / principal.eigenvalues()[0]);
}

double shortest_side(const Block& block) {
  double shortest = (block.outline.at(1) - block.outline.at(0)).norm();
  for (std::size_t i = 1; i < block.outline.size(); ++i)
    shortest = std::min(shortest, (block.outline.at(i + 1) - block.outline.at(i)).norm());
  return shortest / std::sqrt(block.moments.area);
}

void include(Quality& quality, const Block& block) {
  ++quality.blocks_by_corners[block.outline.size()];
  quality.non_convex += is_convex(block.outline) ? 0 : 1;
  quality.area += block.moments.area;
  quality.smallest_area = std::min(quality.smallest_area, block.moments.area);
  quality.largest_area = std::max(quality.largest_area, block.moments.area);
  quality.worst_aspect = std::max(quality.worst_aspect, aspect(block));
  quality.shortest_side = std::min(quality.shortest_side, shortest_side(block));
}

}  // namespace

Quality assess(const Assembly& assembly) {
  Quality quality;
  if (assembly.blocks.empty()) return quality;
  quality.smallest_area = assembly.blocks[0].moments.area;
  quality.shortest_side = shortest_side(assembly.blocks[0]);
  for (const Block& block : assembly.blocks) include(quality, block);
  return quality;
}

std::vector<std::vector<BlockId>> connected_groups(const Assembly& assembly) {
  return connected_groups(assembly, std::vector<bool>(assembly.sides.size(), true));
}

std::vector<std::vector<BlockId>> connected_groups(const Assembly& assembly, const std::vector<bool>& holds) {
  DisjointSets sets(assembly.num_blocks());
  for (std::size_t s = 0; s < assembly.sides.size(); ++s)
    if (holds[s]) sets.merge(assembly.sides[s].first.value(), assembly.sides[s].second.value());
  std::map<std::size_t, std::vector<BlockId>> groups;  // by lowest block
  for (std::size_t b = 0; b < sets.size(); ++b) groups[sets.representative(b)].push_back(BlockId{b});
  std::vector<std::vector<BlockId>> result;
  for (auto& [lowest, members] : groups) result.push_back(std::move(members));
  return result;
}

}  // namespace dda
