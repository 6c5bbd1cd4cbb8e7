#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/cracks/divided_block.hpp"

namespace dda {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Polygon outline{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
constexpr DividedBlock::Smallest smallest{1e-9, 1e-9};
const JumpId a{0}, b{1}, c{2};

TEST(DividedBlock, WhatLiesRightOfACutJumps) {
  DividedBlock block(outline);
  ASSERT_TRUE(block.divide(a, {1, 0}, {1, 4}, smallest));
  EXPECT_THAT(block.part_at({0.5, 2}).jumps, IsEmpty());
  EXPECT_THAT(block.part_at({3, 2}).jumps, ElementsAre(a));
  EXPECT_DOUBLE_EQ(signed_area(block.parts()[0].outline) + signed_area(block.parts()[1].outline), 16);
}

/// Three strips, cut in either order and direction: across each cut the displacement jumps by its own jump alone.
TEST(DividedBlock, PartsBeyondALaterCutMoveWithIt) {
  DividedBlock block(outline);
  ASSERT_TRUE(block.divide(a, {1, 0}, {1, 4}, smallest));
  ASSERT_TRUE(block.divide(b, {3, 4}, {3, 0}, smallest));
  EXPECT_THAT(block.part_at({3.5, 2}).jumps, ElementsAre(a));
  EXPECT_THAT(block.part_at({2, 2}).jumps, ElementsAre(a, b)) << "right of a downward cut lies the left";
  EXPECT_THAT(block.part_at({0.5, 2}).jumps, ElementsAre(b)) << "hangs on what lies right of the second cut";
  ASSERT_FALSE(block.divide(c, {1, 2}, {0, 2}, smallest)) << "begins on another cut";
}

TEST(DividedBlock, RefusesWhatIsNoCut) {
  DividedBlock block(outline);
  EXPECT_FALSE(block.divide(a, {0, 0}, {4, 0}, smallest)) << "along an edge";
  EXPECT_FALSE(block.divide(a, {1, 0}, {1, 3}, smallest)) << "ends within";
  EXPECT_FALSE(block.divide(a, {1, 1}, {1, 4}, smallest)) << "begins within";
  EXPECT_FALSE(block.divide(a, {1e-10, 0}, {0, 1e-10}, smallest)) << "cuts nothing off";
  ASSERT_TRUE(block.divide(a, {1, 0}, {1, 4}, smallest));
  EXPECT_FALSE(block.divide(b, {0, 2}, {4, 2}, smallest)) << "crosses another cut";
  EXPECT_EQ(block.parts().size(), 2u);
}

/// What is left of an upright cut is cut in two up to it: across it the lower piece and the upper one jump by what
/// lies between them as well.
TEST(DividedBlock, ACutMayEndOnAnother) {
  DividedBlock block(outline);
  ASSERT_TRUE(block.divide(a, {2, 0}, {2, 4}, smallest));
  ASSERT_TRUE(block.divide(b, {0, 1}, {2, 1}, smallest));
  EXPECT_EQ(block.parts().size(), 3u);
  const std::vector<JumpId> lower = block.beside({2, 0.5}, {0, 1}).jumps,
                            upper = block.beside({2, 3}, {0, 1}).jumps;
  EXPECT_THAT(lower, ElementsAre(b)) << "right of the second cut";
  EXPECT_THAT(upper, IsEmpty());
  EXPECT_THAT(block.beside({2, 0.5}, {0, -1}).jumps, ElementsAre(a));
  EXPECT_THAT(block.beside({2, 3}, {0, -1}).jumps, ElementsAre(a));
  EXPECT_THAT(block.part_at({1, 0.5}).jumps, ElementsAre(b));
  EXPECT_FALSE(block.divide(c, {2, 1}, {4, 1}, smallest)) << "begins on another cut";
}

TEST(DividedBlock, TakesASliver) {
  DividedBlock block(outline);
  EXPECT_TRUE(block.divide(a, {4 - 1e-6, 0}, {4 - 1e-6, 4}, smallest));
  EXPECT_THAT(block.part_at({4, 2}).jumps, ElementsAre(a));
  EXPECT_THAT(block.part_at({3.9, 2}).jumps, IsEmpty());
}

}  // namespace
}  // namespace dda
