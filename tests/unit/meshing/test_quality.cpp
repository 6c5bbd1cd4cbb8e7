#include <gtest/gtest.h>

#include "meshing/neighbours.hpp"
#include "meshing/quality.hpp"
#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

Assembly assembly_of(std::vector<Block> blocks) {
  Assembly assembly;
  assembly.blocks = std::move(blocks);
  assembly.sides = find_neighbours(assembly.blocks, {}).sides;
  return assembly;
}

TEST(Quality, CountsAndMeasures) {
  const Quality q =
      assess(assembly_of({square_at(0, 0), square_at(1, 0, 4, 1), block_of({{0, 1}, {1, 1}, {0, 2}})}));
  EXPECT_EQ(q.blocks_by_corners, (std::map<std::size_t, std::size_t>{{3, 1}, {4, 2}}));
  EXPECT_DOUBLE_EQ(q.area, 5.5);
  EXPECT_DOUBLE_EQ(q.area_ratio(), 8);
  EXPECT_NEAR(q.worst_aspect, 4, 1e-12);
  EXPECT_DOUBLE_EQ(q.shortest_side, 0.5);
  EXPECT_EQ(q.non_convex, 0u);
}

TEST(Quality, CountsReentrantBlocks) {
  EXPECT_EQ(assess(assembly_of({block_of({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})})).non_convex, 1u);
}

TEST(Quality, FloatingBlocksAreGroupsOfTheirOwn) {
  const auto groups = connected_groups(
      assembly_of({square_at(0, 0), square_at(5, 0), square_at(1, 0), square_at(6, 0), square_at(2, 1)}));
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0], (std::vector{BlockId{0}, BlockId{2}}));
  EXPECT_EQ(groups[1], (std::vector{BlockId{1}, BlockId{3}}));
  EXPECT_EQ(groups[2], (std::vector{BlockId{4}}));
}

}  // namespace
}  // namespace dda
