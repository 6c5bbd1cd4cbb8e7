#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "meshing/neighbours.hpp"
#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

using Pairs = std::multiset<std::pair<std::size_t, std::size_t>>;

Pairs pairs_of(const Neighbours& found) {
  Pairs pairs;
  for (const Side& side : found.sides) pairs.emplace(side.first.value(), side.second.value());
  return pairs;
}

/// A wall of bricks in running bond: every horizontal side has T-joints.
std::vector<Block> wall(int columns, int rows) {
  std::vector<Block> blocks;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      blocks.push_back(square_at(column + 0.5 * (row % 2), 0.4 * row, 1, 0.4));
  return blocks;
}

TEST(Neighbours, TwoSquaresShareOneSide) {
  const Neighbours found = find_neighbours({square_at(0, 0), square_at(1, 0)}, {});
  ASSERT_EQ(found.sides.size(), 1u);
  EXPECT_EQ(found.sides[0].first, BlockId{0});
  EXPECT_EQ(found.sides[0].second, BlockId{1});
  EXPECT_EQ(found.sides[0].start, Vec2(1, 0));
  EXPECT_EQ(found.sides[0].end, Vec2(1, 1));
  EXPECT_EQ(found.boundary.size(), 6u);
}

TEST(Neighbours, NormalPointsOutOfTheFirstBlock) {
  for (const Side& side : find_neighbours(wall(4, 4), {}).sides) {
    const Vec2 s = side.end - side.start, n(s.y(), -s.x());
    const Vec2 from = wall(4, 4)[side.first.value()].moments.centroid,
               to = wall(4, 4)[side.second.value()].moments.centroid;
    EXPECT_GT(n.dot(to - from), 0);
  }
}

TEST(Neighbours, TJointGivesTwoSidesOnOneEdge) {
  const Neighbours found =
      find_neighbours({square_at(0, 0, 2, 1), square_at(0, 1, 0.7, 1), square_at(0.7, 1, 1.3, 1)}, {});
  EXPECT_EQ(pairs_of(found), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_NEAR(length(found.sides[0].start, found.sides[0].end), 1.3, 1e-15);
  EXPECT_NEAR(length(found.sides[1].start, found.sides[1].end), 0.7, 1e-15);
}

TEST(Neighbours, APartlyCoveredEdgeLeavesABoundary) {
  const Neighbours found = find_neighbours({square_at(0, 0, 3, 1), square_at(1, 1)}, {});
  ASSERT_EQ(found.sides.size(), 1u);
  EXPECT_EQ(found.boundary.size(), 3u + 2u + 3u);
}

TEST(Neighbours, CornersAndParallelsDoNotTouch) {
  EXPECT_TRUE(find_neighbours({square_at(0, 0), square_at(1, 1)}, {}).sides.empty());
  EXPECT_TRUE(find_neighbours({square_at(0, 0), square_at(1 + 1e-6, 0)}, {}).sides.empty());
  EXPECT_EQ(find_neighbours({square_at(0, 0), square_at(1 + 1e-11, 0)}, {}).sides.size(), 1u);
}

TEST(Neighbours, OverlapsShorterThanAMillionthAreDropped) {
  EXPECT_TRUE(find_neighbours({square_at(0, 0), square_at(1, 1 - 1e-7)}, {}).sides.empty());
  EXPECT_EQ(find_neighbours({square_at(0, 0), square_at(1, 1 - 1e-5)}, {}).sides.size(), 1u);
}

TEST(Neighbours, ASlitPartsBlocksAndSplitsTheSideItEndsOn) {
  const std::vector<LinePiece> slit{{LineRole::slit, 0, {1, -1}, {1, 0.25}}};
  const Neighbours found = find_neighbours({square_at(0, 0), square_at(1, 0)}, slit);
  ASSERT_EQ(found.sides.size(), 1u);
  EXPECT_EQ(found.sides[0].start, Vec2(1, 0.25));
  EXPECT_EQ(found.boundary.size(), 6u + 2u);
  EXPECT_TRUE(found.used[0]);
}

TEST(Neighbours, NamedLinesNameSidesAndBoundary) {
  const std::vector<LinePiece> lines{{LineRole::interface, 3, {1, 0.5}, {1, 1}},
                                     {LineRole::boundary, 2, {0, 0}, {0.5, 0}},
                                     {LineRole::interface, 1, {0.5, 0}, {0.5, 1}}};
  const Neighbours found = find_neighbours({square_at(0, 0), square_at(1, 0)}, lines);
  ASSERT_EQ(found.sides.size(), 2u);
  EXPECT_FALSE(found.sides[0].curve);
  EXPECT_EQ(found.sides[1].curve, 3);
  ASSERT_EQ(found.boundary.size(), 7u);
  EXPECT_EQ(found.boundary[0].boundary, 2);
  EXPECT_FALSE(found.boundary[1].boundary);
  EXPECT_EQ(found.used, (std::vector<bool>{true, true, false}));
}

TEST(Neighbours, CollinearPiecesOfOneNameDoNotSplitASide) {
  const std::vector<LinePiece> lines{{LineRole::interface, 0, {1, 0}, {1, 0.3}},
                                     {LineRole::interface, 0, {1, 1}, {1, 0.3}}};
  EXPECT_EQ(find_neighbours({square_at(0, 0), square_at(1, 0)}, lines).sides.size(), 1u);
}

RC_GTEST_PROP(Neighbours, AreTheSameInAnyPlaceScaleAndDirection, ()) {
  const std::vector<Block> blocks = wall(5, 6);
  const Eigen::Rotation2Dd turn(0.001 * *rc::gen::inRange(0, 6283));
  const double scale = std::pow(10.0, *rc::gen::inRange(-6, 6));
  const Vec2 shift = 5e3 * scale * Vec2(*rc::gen::inRange(-1, 2), *rc::gen::inRange(-1, 2));
  const bool mirrored = *rc::gen::arbitrary<bool>();
  std::vector<Block> moved;
  for (const Block& block : blocks) {
    Polygon outline = block.outline;
    for (Vec2& x : outline.vertices) x = scale * (turn * Vec2(mirrored ? -x.x() : x.x(), x.y())) + shift;
    moved.push_back(block_of(counter_clockwise(outline).vertices));
  }
  RC_ASSERT(pairs_of(find_neighbours(moved, {})) == pairs_of(find_neighbours(blocks, {})));
}

TEST(Neighbours, SidesAndBoundaryCoverEveryPerimeter) {
  Assembly assembly;
  assembly.blocks = wall(7, 5);
  const Neighbours found = find_neighbours(assembly.blocks, {});
  assembly.sides = found.sides;
  assembly.boundary = found.boundary;
  EXPECT_LT(uncovered_perimeter(assembly), 1e-12);
}

TEST(Neighbours, AreFoundOfTwentyThousandBlocks) {
  EXPECT_EQ(find_neighbours(wall(200, 100), {}).sides.size(), 199u * 100u + 399u * 99u);
}

}  // namespace
}  // namespace dda
