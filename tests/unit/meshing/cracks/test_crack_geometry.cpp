#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "unit/meshing/cracks/crack_scene.hpp"

namespace dda {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// 2 × 2 squares of side 2.
Assembly four_squares() {
  return assembly_of(
      {square_at(0, 0, 2, 2), square_at(2, 0, 2, 2), square_at(0, 2, 2, 2), square_at(2, 2, 2, 2)});
}

/// Areas of parts, lengths of pieces, and by which jumps they move.
std::vector<double> measured(const CrackGeometry& cracks) {
  std::vector<double> out;
  const Assembly& all = cracks.assembly();
  const auto note = [&](const Vec2& start, const Vec2& end) {
    out.insert(out.end(), {start.x(), start.y(), end.x(), end.y()});
  };
  const auto note_jumps = [&](const std::vector<JumpId>& jumps) {
    for (const JumpId jump : jumps) out.push_back(static_cast<double>(jump.value()));
    out.push_back(-1);
  };
  for (std::size_t b = 0; b < all.num_blocks(); ++b)
    for (const Part& part : cracks.parts(BlockId{b})) {
      for (const Vec2& x : part.outline.vertices) note(x, x);
      note_jumps(part.jumps);
    }
  for (std::size_t s = 0; s < all.sides.size(); ++s)
    for (const SidePiece& piece : cracks.pieces_of_side(s)) {
      note(piece.start, piece.end);
      note_jumps(piece.first);
      note_jumps(piece.second);
      out.push_back(piece.cut ? static_cast<double>(*piece.cut) : -1);
    }
  for (std::size_t s = 0; s < all.boundary.size(); ++s)
    for (const BoundaryPiece& piece : cracks.pieces_of_boundary(s)) {
      note(piece.start, piece.end);
      note_jumps(piece.jumps);
    }
  return out;
}

void expect_sums(const CrackGeometry& cracks) {
  const Assembly& all = cracks.assembly();
  for (std::size_t b = 0; b < all.num_blocks(); ++b) {
    const auto parts = cracks.parts(BlockId{b});
    double area = 0;
    for (const Part& part : parts) area += signed_area(part.outline);
    if (!parts.empty()) {
      EXPECT_NEAR(area, all.blocks[b].moments.area, 1e-13 * area);
    }
  }
  for (std::size_t s = 0; s < all.sides.size(); ++s) {
    double sum = 0;
    for (const SidePiece& piece : cracks.pieces_of_side(s)) sum += length(piece.start, piece.end);
    EXPECT_NEAR(sum, length(all.sides[s].start, all.sides[s].end), 1e-13 * sum);
  }
  double boundary = 0;
  for (std::size_t s = 0; s < all.boundary.size(); ++s)
    for (const BoundaryPiece& piece : cracks.pieces_of_boundary(s))
      boundary += length(piece.start, piece.end);
  EXPECT_NEAR(boundary, boundary_length(all), 1e-13 * boundary);
}

TEST(CrackGeometry, FindsTheBlockAheadAndWhereALineLeavesIt) {
  const Assembly assembly = four_squares();
  const CrackGeometry cracks(assembly);
  EXPECT_EQ(cracks.block_ahead({1, 0}, {0, 1}), BlockId{0});
  EXPECT_EQ(cracks.block_ahead({2, 1}, {1, 0.1}), BlockId{1});
  EXPECT_EQ(cracks.block_ahead({2, 1}, {-1, 0.1}), BlockId{0});
  EXPECT_EQ(cracks.block_ahead({2, 2}, {1, 1}), BlockId{3});
  EXPECT_FALSE(cracks.block_ahead({1, 0}, {0, -1}));
  EXPECT_FALSE(cracks.block_ahead({2, 0}, {0, 1})) << "along a side";
  EXPECT_TRUE(cracks.exit(BlockId{0}, {1, 0}, {0, 1})->isApprox(Vec2(1, 2)));
}

TEST(CrackGeometry, ACrackDividesBlocksAndTheSidesItEndsOn) {
  const Assembly assembly = four_squares();
  CrackGeometry cracks(assembly);
  EXPECT_EQ(run_straight(cracks, {1, 0}, {0, 1}), 2);
  EXPECT_EQ(cracks.num_jumps(), 2u);
  expect_sums(cracks);
  const auto between = cracks.sides_at({1, 2});
  ASSERT_EQ(between.size(), 1u);
  const auto pieces = cracks.pieces_of_side(between[0]);
  ASSERT_EQ(pieces.size(), 2u);
  for (const SidePiece& piece : pieces) {
    const bool is_right = piece.start.x() + piece.end.x() > 2;
    EXPECT_EQ(piece.first.size(), is_right ? 1u : 0u);
    EXPECT_EQ(piece.second.size(), is_right ? 1u : 0u);
    if (is_right) {
      EXPECT_NE(piece.first[0], piece.second[0]);
    }
  }
  EXPECT_THAT(cracks.jumps_at(BlockId{0}, {0.5, 1}), IsEmpty());
  EXPECT_THAT(cracks.jumps_at(BlockId{0}, {1.5, 1}), ElementsAre(JumpId{0}));
  EXPECT_TRUE(cracks.is_touched(cracks.sides_at({2, 1})[0])) << "moves with the right part";
}

TEST(CrackGeometry, CutsOnlyThePieceOfANonConvexBlockThatIsNextToTheTip) {
  const Assembly assembly = assembly_of(
      {block_of({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), square_at(1, 1)});
  CrackGeometry cracks(assembly);
  EXPECT_EQ(run_straight(cracks, {0, 1.5}, {1, 0}), 3) << "a leg, the square between, the other leg";
  expect_sums(cracks);
  ASSERT_EQ(cracks.parts(BlockId{0}).size(), 3u);
  EXPECT_THAT(cracks.jumps_at(BlockId{0}, {0.5, 1.8}), ElementsAre(JumpId{2})) << "hangs on the base";
  EXPECT_THAT(cracks.jumps_at(BlockId{0}, {1.5, 0.5}), ElementsAre(JumpId{0}, JumpId{2}));
  EXPECT_THAT(cracks.jumps_at(BlockId{0}, {2.5, 1.8}), ElementsAre(JumpId{0}));
}

TEST(CrackGeometry, AnotherCrackMayCrossABlockThatIsCut) {
  const Assembly assembly = four_squares();
  CrackGeometry cracks(assembly);
  ASSERT_TRUE(cracks.cut(BlockId{0}, {0.5, 0}, {0.5, 2}, 0));
  ASSERT_TRUE(cracks.cut(BlockId{0}, {1.5, 0}, {1.5, 2}, 1));
  expect_sums(cracks);
  EXPECT_EQ(cracks.parts(BlockId{0}).size(), 3u);
}

/// Two upright cuts, and one that runs into the second of them from the right.
TEST(CrackGeometry, ACrackMayEndOnAnotherAndCutsOffAPartThere) {
  const Assembly assembly = four_squares();
  CrackGeometry cracks(assembly);
  ASSERT_TRUE(cracks.cut(BlockId{0}, {0.5, 0}, {0.5, 2}, 0));
  ASSERT_TRUE(cracks.cut(BlockId{0}, {1.5, 0}, {1.5, 2}, 1));
  const auto meets = cracks.exit(BlockId{0}, {2, 1}, {-1, 0.1});
  ASSERT_TRUE(meets);
  EXPECT_TRUE(meets->isApprox(Vec2(1.5, 1.05)));
  EXPECT_FALSE(cracks.is_on_crack(Vec2(2, 1), 2));
  EXPECT_TRUE(cracks.is_on_crack(*meets, 2));
  EXPECT_TRUE(cracks.is_on_crack(*meets, 1)) << "its own way, from the side";
  EXPECT_FALSE(cracks.is_on_crack({1.5, 2}, 1)) << "its own end";
  ASSERT_TRUE(cracks.cut(BlockId{0}, {2, 1}, *meets, 2));
  expect_sums(cracks);
  EXPECT_EQ(cracks.parts(BlockId{0}).size(), 4u);
  EXPECT_FALSE(cracks.block_ahead(*meets, {-1, 0.1})) << "it ends there";
  EXPECT_EQ(cracks.pieces_of_cut(cracks.cuts()[0]).size(), 1u);
  EXPECT_EQ(cracks.pieces_of_cut(cracks.cuts()[1]).size(), 2u);
  const JumpId first{0}, second{1}, third{2};
  EXPECT_THAT(cracks.across(cracks.cut_of(first), {0.5, 1}).right, ElementsAre(first));
  EXPECT_THAT(cracks.across(cracks.cut_of(third), {1.8, 1}).right, ElementsAre(third));
  const auto below = cracks.across(cracks.cut_of(second), {1.5, 0.5}),
             above = cracks.across(cracks.cut_of(second), {1.5, 1.5});
  EXPECT_NE(below.right.size() + below.left.size(), above.right.size() + above.left.size())
      << "one of the two pieces beside it moves by the third jump";
  for (const auto& across : {below, above}) EXPECT_THAT(across.right, testing::Contains(second));
}

TEST(CrackGeometry, OpensSidesOnceAndFindsTheWayAlongThem) {
  const Assembly assembly = four_squares();
  CrackGeometry cracks(assembly);
  const auto way = cracks.way_along({2, 0}, {0.05, 1});
  ASSERT_TRUE(way);
  EXPECT_EQ(way->end, Vec2(2, 2));
  EXPECT_NEAR(way->angle, std::atan(0.05), 1e-14);
  ASSERT_TRUE(cracks.open(way->side, {2, 0}, way->end, 0));
  EXPECT_EQ(cracks.num_jumps(), 0u);
  EXPECT_FALSE(cracks.open(way->side, {2, 0}, way->end, 0));
  ASSERT_EQ(cracks.pieces_of_side(way->side).size(), 1u);
  EXPECT_EQ(cracks.pieces_of_side(way->side)[0].cut, 0u);
  const auto on = cracks.way_along({2, 2}, {0.05, 1});
  EXPECT_EQ(on->end, Vec2(2, 4));
  EXPECT_NE(on->side, way->side);
}

TEST(CrackGeometry, OpensAPartOfASide) {
  const Assembly assembly = four_squares();
  CrackGeometry cracks(assembly);
  ASSERT_TRUE(cracks.cut(BlockId{0}, {1, 0}, {2, 1.5}, 0));
  const auto way = cracks.way_along({2, 1.5}, {0, 1});
  ASSERT_TRUE(way);
  ASSERT_TRUE(cracks.open(way->side, {2, 1.5}, way->end, 0));
  const auto pieces = cracks.pieces_of_side(way->side);
  ASSERT_EQ(pieces.size(), 2u);
  for (const SidePiece& piece : pieces) EXPECT_EQ(piece.cut.has_value(), piece.start.y() + piece.end.y() > 3);
  expect_sums(cracks);
}

RC_GTEST_PROP(CrackGeometry, PartsAndPiecesAddUpOnVoronoiCells, ()) {
  const Assembly assembly = voronoi_beam(40, *rc::gen::inRange(1, 20));
  CrackGeometry cracks(assembly);
  const int cracks_wanted = *rc::gen::inRange(1, 4);
  int cuts = 0;
  for (int i = 0; i < cracks_wanted; ++i)
    cuts += run_straight(cracks, {0.01 * *rc::gen::inRange(100, 2900), 0},
                         {0.01 * *rc::gen::inRange(-150, 150), 1});
  RC_ASSERT(cuts > 0);
  expect_sums(cracks);
}

RC_GTEST_PROP(CrackGeometry, DroppingTheLastCutsRestoresExactly, ()) {
  const Assembly assembly = voronoi_beam(30, *rc::gen::inRange(1, 20));
  CrackGeometry cracks(assembly);
  std::vector<std::vector<double>> before{measured(cracks)};
  const auto grow = [&](Vec2 tip, const Vec2& direction) {
    for (;;) {
      const auto block = cracks.block_ahead(tip, direction);
      const auto exit = block ? cracks.exit(*block, tip, direction) : std::nullopt;
      if (!exit || !cracks.cut(*block, tip, *exit, 0)) return;
      tip = *exit;
      before.push_back(measured(cracks));
    }
  };
  for (int i = 0; i < 3; ++i)
    grow({0.01 * *rc::gen::inRange(100, 2900), 0}, {0.01 * *rc::gen::inRange(-150, 150), 1});
  while (!cracks.empty()) {
    before.pop_back();
    cracks.drop_last();
    RC_ASSERT(measured(cracks) == before.back());
  }
}

RC_GTEST_PROP(CrackGeometry, TheSameCutsGiveTheSameBits, ()) {
  const Assembly assembly = voronoi_beam(30, *rc::gen::inRange(1, 20));
  CrackGeometry cracks(assembly), again(assembly);
  run_straight(cracks, {0.01 * *rc::gen::inRange(100, 2900), 0}, {0.01 * *rc::gen::inRange(-150, 150), 1});
  for (const Cut& cut : cracks.cuts()) RC_ASSERT(again.cut(cut.block, cut.start, cut.end, cut.crack));
  RC_ASSERT(measured(again) == measured(cracks));
}

RC_GTEST_PROP(CrackGeometry, FollowsTurnedMirroredAndScaledScenes, ()) {
  const Assembly assembly = voronoi_beam(30, *rc::gen::inRange(1, 20));
  const Placement placement{.angle = 0.001 * *rc::gen::inRange(0, 6283),
                            .shift = Vec2(*rc::gen::inRange(-100, 100), *rc::gen::inRange(-100, 100)),
                            .scale = *rc::gen::element(1e-3, 1.0, 1e3),
                            .is_mirrored = *rc::gen::arbitrary<bool>()};
  const Assembly placed = placement.of(assembly);
  CrackGeometry cracks(assembly), other(placed);
  const Vec2 tip(0.01 * *rc::gen::inRange(100, 2900), 0), direction(0.01 * *rc::gen::inRange(-150, 150), 1);
  RC_ASSERT(run_straight(cracks, tip, direction) ==
            run_straight(other, placement.at(tip), placement.direction(direction)));
  for (std::size_t i = 0; i < cracks.cuts().size(); ++i) {
    const Cut &one = cracks.cuts()[i], &two = other.cuts()[i];
    RC_ASSERT(one.block == two.block);
    const double size = placement.scale * (30 + placement.shift.norm());
    RC_ASSERT((placement.at(one.start) - two.start).norm() < 1e-12 * size);
    RC_ASSERT((placement.at(one.end) - two.end).norm() < 1e-12 * size);
  }
  expect_sums(other);
}

}  // namespace
}  // namespace dda
