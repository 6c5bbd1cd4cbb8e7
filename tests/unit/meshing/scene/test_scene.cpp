#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/quality.hpp"
#include "meshing/scene/scene.hpp"
#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;

class EverySubdivision : public ::testing::TestWithParam<const char*> {};

TEST_P(EverySubdivision, FillsTheNotchedBeamAndFollowsItsLines) {
  const Assembly a = mesh_of(notched_beam(GetParam()));
  EXPECT_NEAR(total_area(a), 30000, 1e-4);
  EXPECT_NEAR(length_on_curve(a, "ligament"), 84, 1e-9);
  EXPECT_NEAR(boundary_length(a), 800 + 2 * 16, 1e-9);
  EXPECT_LT(uncovered_perimeter(a), 1e-4);
  EXPECT_EQ(connected_groups(a).size(), 1u);
  double top = 0;
  for (const BoundarySide& side : a.boundary)
    if (side.boundary) top += length(side.start, side.end);
  EXPECT_NEAR(top, 100, 1e-9);
}

TEST_P(EverySubdivision, IsRepeatable) {
  const Assembly a = mesh_of(notched_beam(GetParam())), b = mesh_of(notched_beam(GetParam()));
  ASSERT_EQ(a.num_blocks(), b.num_blocks());
  for (std::size_t i = 0; i < a.num_blocks(); ++i)
    EXPECT_EQ(a.blocks[i].outline.vertices, b.blocks[i].outline.vertices);
  ASSERT_EQ(a.sides.size(), b.sides.size());
}

TEST_P(EverySubdivision, IsEchoedAsItWasRead) {
  const Scene scene = scene_from(notched_beam(GetParam()));
  const Node echo = scene_schema().echo(scene);
  EXPECT_EQ(scene_schema().echo(scene_schema().read(echo)), echo);
}

INSTANTIATE_TEST_SUITE_P(Scene, EverySubdivision,
                         ::testing::Values("given", "{type: triangles, size: 12}", "{type: quads, size: 12}",
                                           "{type: triangles, size: 25, refine: {curve: ligament, size: 4}}",
                                           "{type: voronoi, blocks: 455}",
                                           "{type: voronoi, size: 15, seed: 9}",
                                           "{type: grid, columns: 6, rows: 5}",
                                           "{type: grid, columns: 6, rows: 5, shape: triangles}",
                                           "{type: squares, size: 12, angle: 30}",
                                           "{type: bricks, length: 24, height: 9}",
                                           "{type: bricks, length: 24, height: 10, bond: flemish}",
                                           "{type: bricks, length: 20, height: 10, bond: stack}",
                                           "{type: bricks, length: 25, height: 12, bond: english}"));

/// A plate on a beam: one block beside many, joined along all of what they share, whichever is named first.
TEST(Scene, LeavesARegionUndividedBesideEverySubdivision) {
  const std::string beam = "{material: concrete, vertices: [[0, 0], [300, 0], [300, 100], [0, 100]]}",
                    plate =
                        "{material: steel, undivided: true, vertices: [[131, 100], [172, 100], [172, "
                        "110], [131, 110]]}";
  for (const std::string subdivision :
       {"given", "{type: triangles, size: 12}", "{type: quads, size: 12}", "{type: voronoi, size: 15}",
        "{type: squares, size: 12, angle: 30}", "{type: bricks, length: 24, height: 9}"})
    for (const bool is_first : {false, true}) {
      const Assembly a =
          mesh_of("{regions: [" + (is_first ? plate + ", " + beam : beam + ", " + plate) +
                  "], curves: {bed: [[131, 100], [172, 100]]}, boundaries: {top: [[131, 110], [172, 110]]}, "
                  "subdivision: " +
                  subdivision + "}");
      EXPECT_NEAR(total_area(a), 30410, 1e-4) << subdivision;
      EXPECT_EQ(std::ranges::count(a.blocks, is_first ? 0 : 1, &Block::region), 1) << subdivision;
      EXPECT_EQ(a.regions[static_cast<std::size_t>(a.blocks.back().region)].material, "steel") << subdivision;
      EXPECT_EQ(a.blocks.back().outline.vertices.size(), 4u) << subdivision;
      EXPECT_NEAR(length_on_curve(a, "bed"), 41, 1e-9) << subdivision;
      EXPECT_NEAR(boundary_length(a), 800 + 20, 1e-9) << subdivision;
      EXPECT_EQ(connected_groups(a).size(), 1u) << subdivision;
    }
}

/// With its optimisation gmsh turns one of these squares inside out.
TEST(Quads, DoNotFoldOver) {
  const Assembly a =
      mesh_of(R"({regions: [{material: concrete, vertices: [[0, 0], [300, 0], [300, 100], [0, 100]]}],
    slits: {notch: [[150, 0], [150, 16.666666666666668]]}, subdivision: {type: quads, size: 2.7386127875258306}})");
  EXPECT_NEAR(total_area(a), 30000, 1e-6);
  EXPECT_EQ(connected_groups(a).size(), 1u);
}

TEST(Scene, EveryRegisteredSubdivisionIsTestedHere) {
  std::vector<std::string> names;
  for (const FamilyMember* member : subdivisions().entries()) names.push_back(member->name);
  EXPECT_EQ(names, (std::vector<std::string>{"bricks", "given", "grid", "quads", "squares", "triangles",
                                             "voronoi"}));
}

TEST(Scene, ARegionAloneIsSubdivided) {
  for (const char* subdivision : {"{type: triangles, size: 0.3}", "{type: quads, size: 0.3}",
                                  "{type: voronoi, blocks: 20}", "{type: grid, columns: 4, rows: 4}"}) {
    const Assembly a =
        mesh_of(std::string("regions: [{material: m, vertices: [[0, 0], [1, 0], [1, 1], [0, 1]]}]\n"
                            "subdivision: ") +
                subdivision);
    EXPECT_GE(a.num_blocks(), 16u) << subdivision;
    EXPECT_NEAR(total_area(a), 1, 1e-9) << subdivision;
  }
}

TEST(Scene, BlocksKeepTheirRegionsHoweverMany) {
  for (const char* subdivision : {"{type: triangles, size: 0.5}", "{type: voronoi, blocks: 60}"}) {
    std::string yaml = "regions:\n";
    for (int i = 0; i < 12; ++i)
      yaml += "  - {name: r" + std::to_string(i) + ", material: m, vertices: [[" + std::to_string(i) +
              ", 0], [" + std::to_string(i + 1) + ", 0], [" + std::to_string(i + 1) + ", 1], [" +
              std::to_string(i) + ", 1]]}\n";
    for (const Block& block : mesh_of(yaml + "subdivision: " + subdivision).blocks)
      EXPECT_EQ(block.region, static_cast<int>(block.moments.centroid.x())) << subdivision;
  }
}

TEST(Scene, QuadsAreMostlyQuads) {
  const auto corners = assess(mesh_of(notched_beam("{type: quads, size: 12}"))).blocks_by_corners;
  ASSERT_TRUE(corners.count(4));
  EXPECT_LT(corners.count(3) ? corners.at(3) : 0u, corners.at(4) / 10);
}

TEST(Scene, SlitsInsideARegionAreFollowedByAllThatCut) {
  for (const char* subdivision :
       {"{type: triangles, size: 0.3}", "{type: quads, size: 0.3}", "{type: voronoi, blocks: 40}"}) {
    const Assembly a =
        mesh_of(std::string("regions: [{material: stone, vertices: [[0, 0], [4, 0], [4, 3], [0, 3]]}]\n"
                            "slits: {crack: [[1, 3], [1.5, 1.4]]}\nsubdivision: ") +
                subdivision);
    EXPECT_NEAR(boundary_length(a), 14 + 2 * std::hypot(0.5, 1.6), 1e-6) << subdivision;
    EXPECT_EQ(connected_groups(a).size(), 1u) << subdivision;
  }
}

TEST(Scene, RegionsTakeTheirMaterialsNameWhenTheyHaveNone) {
  const Assembly a = mesh_of("regions: [{material: stone, vertices: [[0, 0], [0, 1], [1, 1], [1, 0]]}]");
  EXPECT_EQ(a.regions[0].name, "stone");
  EXPECT_DOUBLE_EQ(a.blocks[0].moments.area, 1);  // given clockwise, kept counter-clockwise
}

TEST(Scene, EverythingWrongWithPolygonsIsSaidAtOnceWithItsPlace) {
  const std::string said = complaint(
      "regions:\n"
      "  - {name: flat, material: m, vertices: [[0, 0], [1, 0], [2, 0]]}\n"
      "  - {name: bow, material: m, vertices: [[0, 0], [2, 2], [2, 0], [0, 2]]}\n"
      "  - {name: a, material: m, vertices: [[5, 0], [7, 0], [7, 2], [5, 2]]}\n"
      "  - {name: b, material: m, vertices: [[6, 1], [8, 1], [8, 3], [6, 3]]}\n");
  EXPECT_THAT(said, HasSubstr("deck.yaml:2:5: region 'flat' has zero area"));
  EXPECT_THAT(said, HasSubstr("deck.yaml:3:5: region 'bow' crosses itself"));
  EXPECT_THAT(said, HasSubstr("deck.yaml:5:5: region 'b' overlaps region 'a'"));
}

TEST(Scene, NonConvexOverlapsAreFoundAndCommonBordersAreNone) {
  const std::string angle =
      "regions:\n  - {name: l, material: m, vertices: [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]]}\n";
  EXPECT_EQ(complaint(angle + "  - {name: q, material: m, vertices: [[1, 1], [3, 1], [3, 3], [1, 3]]}\n"),
            "");
  EXPECT_THAT(
      complaint(angle + "  - {name: q, material: m, vertices: [[0.9, 1], [3, 1], [3, 3], [0.9, 3]]}\n"),
      HasSubstr("overlaps"));
}

TEST(Scene, KeysHaveToFitTheType) {
  EXPECT_THAT(complaint("{type: polygons}"), HasSubstr("at least one entry of 'regions'"));
  EXPECT_THAT(complaint("{type: geo}"), HasSubstr("needs the parameter 'file'"));
  EXPECT_THAT(complaint("{type: geo, file: nowhere.geo}"), HasSubstr("nowhere.geo"));
  EXPECT_THAT(complaint(notched_beam("triangles")), HasSubstr("'size'"));
  EXPECT_THAT(complaint(notched_beam("{type: voronoi, blocks: 5, size: 3}")),
              HasSubstr("either 'blocks' or 'size'"));
  EXPECT_THAT(complaint(notched_beam("{type: triangles, size: 9, refine: {curve: ligamnt, size: 2}}")),
              HasSubstr("no curve 'ligamnt'"));
  EXPECT_THAT(complaint("regions: [{material: m, vertices: [[0, 0], [.nan, 0], [1, 1]]}]"),
              HasSubstr("deck.yaml:1:"));
}

TEST(Scene, ALineThatLiesOnNoBlockIsReported) {
  EXPECT_THAT(complaint("regions: [{material: m, vertices: [[0, 0], [1, 0], [1, 1]]}]\ncurves: {joint: "
                        "[[0.2, 0.1], [0.8, 0.1]]}\n"),
              HasSubstr("curve 'joint' lies on no side of any block"));
}

}  // namespace
}  // namespace dda
