#include <gtest/gtest.h>

#include "meshing/assembly.hpp"
#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

TEST(BlocksAt, FindsAllThatTouchAPoint) {
  Assembly assembly;
  assembly.blocks = {square_at(0, 0), square_at(1, 0), square_at(1, 1)};
  EXPECT_EQ(blocks_at(assembly, {1, 1}, 1e-9), (std::vector{BlockId{0}, BlockId{1}, BlockId{2}}));
  EXPECT_EQ(blocks_at(assembly, {1.5, 0.5}, 1e-9), (std::vector{BlockId{1}}));
  EXPECT_TRUE(blocks_at(assembly, {0.5, 1.5}, 0.4).empty());
  EXPECT_EQ(blocks_at(assembly, {-0.01, 0.5}, 0.02), (std::vector{BlockId{0}}));
}

}  // namespace
}  // namespace dda
