#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/quality.hpp"
#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;

/// A wall of 4 × 3, in two regions, with a window in one of them and a door that crosses both and the foot.
std::string wall(const std::string& subdivision, const std::string& holes) {
  return "{regions: [{name: left, material: stone, vertices: [[0, 0], [2.5, 0], [2.5, 3], [0, 3]]}, "
         "{name: right, material: stone, vertices: [[2.5, 0], [4, 0], [4, 3], [2.5, 3]]}], "
         "boundaries: {foot: [[0, 0], [4, 0]]}, holes: {" +
         holes + "}, subdivision: " + subdivision + "}";
}

const std::string window = "window: [[0.5, 1], [0.5, 2], [1.25, 2.25], [1.5, 1]]",
                  door = "door: [[2, -1], [3, -1], [3, 2], [2, 2]]";

double length_of(const Assembly& assembly, const std::string& name) {
  const auto at = std::ranges::find(assembly.boundaries, name) - assembly.boundaries.begin();
  double sum = 0;
  for (const BoundarySide& side : assembly.boundary)
    if (side.boundary == static_cast<int>(at)) sum += length(side.start, side.end);
  return sum;
}

class HolesIn : public ::testing::TestWithParam<const char*> {};

TEST_P(HolesIn, AreEmptyAndTheirOutlinesBoundaries) {
  const Assembly a = mesh_of(wall(GetParam(), window + ", " + door));
  EXPECT_NEAR(total_area(a), 12 - 1 - 2, 1e-6);
  EXPECT_NEAR(length_of(a, "window"), 1 + std::hypot(0.75, 0.25) + std::hypot(0.25, 1.25) + 1, 1e-6);
  EXPECT_NEAR(length_of(a, "door"), 2 + 1 + 2, 1e-6);
  EXPECT_NEAR(length_of(a, "foot"), 3, 1e-6);
  EXPECT_LT(uncovered_perimeter(a), 1e-6);
  EXPECT_EQ(connected_groups(a).size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Scene, HolesIn,
                         ::testing::Values("{type: triangles, size: 0.4}", "{type: quads, size: 0.4}",
                                           "{type: voronoi, size: 0.4}", "{type: voronoi, size: 2}",
                                           "{type: squares, size: 0.3, angle: 20}",
                                           "{type: bricks, length: 0.5, height: 0.25}"));

TEST(Holes, MayCutARegionInTwo) {
  const Assembly a = mesh_of(
      "{regions: [{material: stone, vertices: [[0, 0], [4, 0], [4, 1], [0, 1]]}], holes: {gap: [[1, -1], [2, "
      "-1], [2, 2], [1, 2]]}}");
  ASSERT_EQ(a.num_blocks(), 2U);
  EXPECT_NEAR(total_area(a), 3, 1e-12);
  EXPECT_NEAR(length_of(a, "gap"), 2, 1e-12);
  EXPECT_EQ(connected_groups(a).size(), 2U);
}

TEST(Holes, ThatAreNoneAreTold) {
  const std::string cells = "{type: voronoi, size: 0.4}";
  EXPECT_THAT(complaint(wall("given", window)),
              HasSubstr("region 'left' is to be one block and has a hole inside"));
  EXPECT_THAT(complaint(wall(cells, "far: [[9, 9], [10, 9], [10, 10]]")),
              HasSubstr("hole 'far' lies in no region"));
  EXPECT_THAT(complaint(wall(cells, "bow: [[1, 1], [2, 2], [2, 1], [1, 2]]")),
              HasSubstr("hole 'bow' crosses itself"));
  EXPECT_THAT(complaint(wall(cells, window + ", other: [[1, 1], [2, 1], [2, 2]]")),
              HasSubstr("hole 'other' overlaps hole 'window'"));
  EXPECT_THAT(complaint(wall(cells, "foot: [[1, 1], [2, 1], [2, 2]]")),
              HasSubstr("'foot' is a boundary and a hole"));
  EXPECT_THAT(complaint(wall(cells, "all: [[-1, -1], [2.5, -1], [2.5, 4], [-1, 4]]")),
              HasSubstr("no block lies in region 'left'"));
  EXPECT_THAT(complaint("{type: geo, holes: {a: [[0, 0], [1, 0], [0, 1]]}}"),
              HasSubstr("'holes' belong to a scene of type polygons"));
}

}  // namespace
}  // namespace dda
