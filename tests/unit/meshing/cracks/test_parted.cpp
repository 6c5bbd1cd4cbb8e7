#include <gmock/gmock.h>

#include "meshing/cracks/chord.hpp"
#include "meshing/cracks/parted.hpp"
#include "unit/meshing/cracks/crack_scene.hpp"

namespace dda {
namespace {

double total_length(const std::vector<Side>& sides) {
  double out = 0;
  for (const Side& side : sides) out += (side.end - side.start).norm();
  return out;
}

/// 2 × 2 squares of side 2, through the lower two of which a crack runs at a height of 1, to x = 3.
class TwoCuts : public ::testing::Test {
 protected:
  Assembly whole_ = assembly_of(
      {square_at(0, 0, 2, 2), square_at(2, 0, 2, 2), square_at(0, 2, 2, 2), square_at(2, 2, 2, 2)});
  CrackGeometry cracks_{whole_};
};

TEST_F(TwoCuts, PartsAreBlocksWhereTheWholeWas) {
  ASSERT_TRUE(cracks_.cut(BlockId{0}, {0, 1}, {2, 1}, 0));
  ASSERT_TRUE(cracks_.cut(BlockId{1}, {2, 1}, {4, 1}, 0));
  const Parted out = parted(cracks_);
  ASSERT_EQ(out.assembly.num_blocks(), 6u);
  EXPECT_THAT(out.of_whole, ::testing::ElementsAre(::testing::ElementsAre(0, 1), ::testing::ElementsAre(2, 3),
                                                   ::testing::ElementsAre(4), ::testing::ElementsAre(5)));
  double area = 0;
  for (const Block& block : out.assembly.blocks) area += block.moments.area;
  EXPECT_NEAR(area, 16, 1e-12);
  EXPECT_NEAR(total_length(out.assembly.sides), total_length(whole_.sides) + 4, 1e-12);
  double outer = 0;
  for (const BoundarySide& side : out.assembly.boundary) outer += (side.end - side.start).norm();
  EXPECT_NEAR(outer, 16, 1e-12);
}

TEST_F(TwoCuts, SidesLieOnTheOutlinesOfBothTheirBlocks) {
  ASSERT_TRUE(cracks_.cut(BlockId{0}, {0, 1}, {2, 1}, 0));
  ASSERT_TRUE(cracks_.cut(BlockId{1}, {2, 1}, {4, 1}, 0));
  const Parted out = parted(cracks_);
  for (const Side& side : out.assembly.sides) {
    const Vec2 middle = (side.start + side.end) / 2;
    EXPECT_NE(side.first, side.second);
    for (const BlockId id : {side.first, side.second})
      EXPECT_LT(distance(middle, out.assembly.blocks[id.value()].outline), 1e-12);
  }
}

TEST_F(TwoCuts, IsTheWholeWithoutCuts) {
  const Parted out = parted(cracks_);
  EXPECT_EQ(out.assembly.num_blocks(), whole_.num_blocks());
  EXPECT_EQ(out.assembly.sides.size(), whole_.sides.size());
  EXPECT_EQ(out.at(BlockId{3}, {}), 3u);
}

}  // namespace
}  // namespace dda
