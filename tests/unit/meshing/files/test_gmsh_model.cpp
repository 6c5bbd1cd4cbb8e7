#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "meshing/files/gmsh_model.hpp"
#include "meshing/quality.hpp"
#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;

/// A file in a folder of its own, removed at the end.
class GmshFile {
 public:
  GmshFile(const std::string& name, const std::string& text)
      : folder_(std::filesystem::temp_directory_path() /
                ("dda_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))),
        path_(folder_ / name) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path_) << text;
  }
  ~GmshFile() { std::filesystem::remove_all(folder_); }
  std::string scene(const std::string& type, const std::string& rest = "") const {
    return "{type: " + type + ", file: '" + path_.string() + "'" + rest + "}";
  }

 private:
  std::filesystem::path folder_, path_;
};

/// Two plates of one material on a ligament (x = w/2) with a notch of no width below it.
const std::string plates = R"(
DefineConstant[h = {0.3}];
DefineConstant[w = {4, Name "geometry/width"}];
Point(1) = {0, 0, 0, h}; Point(2) = {w/2, 0, 0, h}; Point(3) = {w, 0, 0, h};
Point(4) = {w, 1, 0, h}; Point(5) = {w/2, 1, 0, h}; Point(6) = {0, 1, 0, h}; Point(7) = {w/2, 0.4, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 1};
Line(7) = {2, 7}; Line(8) = {7, 5};
Curve Loop(1) = {1, 7, 8, 5, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -8, -7}; Plane Surface(2) = {2};
Physical Surface("material:concrete", 1) = {1};
Physical Surface("material:concrete/right", 2) = {2};
Physical Curve("slit:notch", 1) = {7};
Physical Curve("interface:ligament", 2) = {8};
Physical Curve("boundary:left", 3) = {6};
Physical Point("gauge:mouth", 1) = {2};
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(GmshModel, NamesRegionsCurvesBoundariesAndPoints) {
  const Assembly a = mesh_of(GmshFile("plates.geo", plates).scene("geo"));
  ASSERT_EQ(a.regions.size(), 2u);
  EXPECT_EQ(a.regions[0].name, "concrete");
  EXPECT_EQ(a.regions[1].name, "right");
  EXPECT_EQ(a.regions[1].material, "concrete");
  EXPECT_NEAR(length_on_curve(a, "ligament"), 0.6, 1e-12);
  EXPECT_EQ(a.boundaries, std::vector<std::string>{"left"});
  EXPECT_TRUE(a.points.at("mouth").isApprox(Vec2(2, 0)));
  EXPECT_NEAR(total_area(a), 4, 1e-12);
  // The outline, and the notch from both sides.
  EXPECT_NEAR(boundary_length(a), 10 + 2 * 0.4, 1e-12);
  EXPECT_LT(uncovered_perimeter(a), 1e-12);
}

TEST(GmshModel, ParametersBySymbolOrOnelabName) {
  const GmshFile file("plates.geo", plates);
  const Assembly wide = mesh_of(file.scene("geo", ", parameters: {w: 6, h: 0.15}"));
  EXPECT_NEAR(total_area(wide), 6, 1e-12);
  EXPECT_GT(wide.num_blocks(), 2 * mesh_of(file.scene("geo")).num_blocks());
  EXPECT_NEAR(total_area(mesh_of(file.scene("geo", ", parameters: {geometry/width: 8}"))), 8, 1e-12);
  EXPECT_THAT(complaint(file.scene("geo", ", parameters: {hh: 1}")), HasSubstr("no parameter 'hh'"));
}

TEST(GmshModel, SubdivisionsOfAGeometryFile) {
  const GmshFile file("plates.geo", plates);
  for (const char* s :
       {"{type: triangles, size: 0.2}", "{type: quads, size: 0.2}", "{type: voronoi, blocks: 60}",
        "{type: triangles, size: 0.3, refine: {curve: ligament, size: 0.05}}"}) {
    const Assembly a = mesh_of(file.scene("geo", std::string(", subdivision: ") + s));
    EXPECT_NEAR(total_area(a), 4, 1e-9) << s;
    EXPECT_NEAR(length_on_curve(a, "ligament"), 0.6, 1e-9) << s;
    EXPECT_LT(uncovered_perimeter(a), 1e-5) << s;
    EXPECT_EQ(connected_groups(a).size(), 1u) << s;
  }
}

TEST(GmshModel, TheDeckMayAddLinesToAFile) {
  const Assembly a =
      mesh_of(GmshFile("plates.geo", plates).scene("geo", ", boundaries: {foot: [[0, 0], [4, 0]]}"));
  EXPECT_EQ(a.boundaries, (std::vector<std::string>{"left", "foot"}));
}

TEST(GmshModel, SyntaxErrorsCarryTheirLine) {
  EXPECT_THAT(
      complaint(GmshFile("bad.geo", "h = 1;\nPoint(1) = {0, 0, 0, h};\nLine(1) = {1, 2;\n").scene("geo")),
      HasSubstr("bad.geo:3:1: gmsh: syntax error"));
}

TEST(GmshModel, SurfacesWithoutMaterialAndUnknownRolesAreAllReported) {
  std::string text = replaced(plates, R"(Physical Surface("material:concrete/right", 2) = {2};)", "");
  text = replaced(text, "interface:ligament", "crack:ligament");
  const std::string said = complaint(GmshFile("plates.geo", text).scene("geo"));
  EXPECT_THAT(said, HasSubstr("surface 2 (centre 3, 0.5) has no material"));
  EXPECT_THAT(said,
              HasSubstr("unknown name 'crack:ligament'; expected boundary:NAME, interface:NAME, slit:NAME"));
}

TEST(GmshModel, AnEntityHasOneNamePerRole) {
  const std::string text = plates + "Physical Curve(\"boundary:support\", 9) = {6};\n";
  EXPECT_THAT(complaint(GmshFile("plates.geo", text).scene("geo")),
              HasSubstr("curve 6 (centre 0, 0.5) is in two groups: boundary:left and boundary:support"));
}

TEST(GmshModel, AlgorithmEightIsRefused) {
  EXPECT_THAT(complaint(GmshFile("plates.geo", plates + "Mesh.Algorithm = 8;\n").scene("geo")),
              HasSubstr("Mesh.Algorithm 8"));
}

/// A unit square of two triangles and a quadrilateral beside it, as gmsh's older format has it.
const std::string old_mesh = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 3 "interface:joint"
2 1 "material:stone"
2 2 "material:brick"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 2 0 0
6 2 1 0
$EndNodes
$Elements
4
1 1 2 3 7 2 3
2 2 2 1 8 1 2 3
3 2 2 1 8 1 3 4
4 3 2 2 9 2 5 6 3
$EndElements
)";

TEST(GmshModel, ReadsAMeshOfVersion22) {
  const Assembly a = mesh_of(GmshFile("old.msh", old_mesh).scene("msh"));
  EXPECT_EQ(assess(a).blocks_by_corners, (std::map<std::size_t, std::size_t>{{3, 2}, {4, 1}}));
  EXPECT_NEAR(length_on_curve(a, "joint"), 1, 1e-14);
  EXPECT_EQ(a.regions[1].material, "brick");
}

/// Version 2.1 has the same text and is read by gmsh.
TEST(GmshModel, ReadsAMeshAsGmshDoes) {
  const std::string text =
      replaced(replaced(old_mesh, "4\n1 1 2 3 7 2 3", "5\n9 15 2 4 5 2\n1 1 2 3 7 2 3"),
               "3\n1 3 \"interface:joint\"", "4\n0 4 \"gauge:foot\"\n1 3 \"interface:joint\"");
  const Assembly own = mesh_of(GmshFile("own.msh", text).scene("msh"));
  const Assembly other = mesh_of(GmshFile("other.msh", replaced(text, "2.2 0 8", "2.1 0 8")).scene("msh"));
  ASSERT_EQ(own.num_blocks(), other.num_blocks());
  for (std::size_t b = 0; b < own.num_blocks(); ++b) {
    EXPECT_EQ(own.blocks[b].outline.vertices, other.blocks[b].outline.vertices);
    EXPECT_EQ(own.blocks[b].region, other.blocks[b].region);
  }
  EXPECT_EQ(own.points, other.points);
  EXPECT_EQ(own.curves, other.curves);
  EXPECT_EQ(length_on_curve(own, "joint"), length_on_curve(other, "joint"));
}

TEST(GmshModel, AMeshMissingAMaterialIsRefusedAsGmshDoes) {
  const std::string text = replaced(old_mesh, "4 3 2 2 9", "4 3 2 0 9");
  for (const char* version : {"2.2 0 8", "2.1 0 8"})
    EXPECT_THAT(complaint(GmshFile("a.msh", replaced(text, "2.2 0 8", version)).scene("msh")),
                HasSubstr("surface 9 (centre 1.5, 0.5) has no material"))
        << version;
}

TEST(GmshModel, ABrokenMeshIsRefusedWithItsLine) {
  const auto said = [](const std::string& what, const std::string& by) {
    return complaint(GmshFile("a.msh", replaced(old_mesh, what, by)).scene("msh"));
  };
  EXPECT_THAT(said("3 1 1 0", "3 1 x 0"), HasSubstr("a.msh:14:1: expected y, got 'x'"));
  EXPECT_THAT(said("2 5 6 3", "2 5 60 3"), HasSubstr("a.msh:24:1: there is no node 60"));
  EXPECT_THAT(said("4 3 2 2 9", "4 16 2 2 9"), HasSubstr("a.msh:24:1: the mesh has elements that are no"));
  EXPECT_THAT(said("$EndElements", ""), HasSubstr("there is no $EndElements"));
  EXPECT_THAT(said("6\n1 0 0 0", "600000\n1 0 0 0"), HasSubstr("600000 nodes do not fit into the file"));
  EXPECT_THAT(said("$Elements", "Elements"), HasSubstr("a.msh:19:1: expected a section, got 'Elements'"));
}

TEST(GmshModel, ReadsAMeshOfVersion41) {
  const std::string text = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
0 7 "point:corner"
1 2 "boundary:foot"
2 1 "material:stone"
$EndPhysicalNames
$Entities
1 1 1 0
5 1 0 0 1 7
3 0 0 0 1 0 0 1 -2 2 5 -6
1 0 0 0 1 1 0 1 1 1 3
$EndEntities
$Nodes
2 4 1 4
1 3 1 2
1
2
0 0 0 0
1 0 0 1
2 1 0 2
3
4
1 1 0
0 1 0
$EndNodes
$Elements
2 3 1 3
1 3 1 1
3 1 2
2 1 2 2
1 1 2 3
2 1 3 4
$EndElements
)";
  const Assembly a = mesh_of(GmshFile("new.msh", text).scene("msh"));
  EXPECT_EQ(a.num_blocks(), 2u);
  EXPECT_EQ(a.sides.size(), 1u);
  EXPECT_EQ(a.boundaries, std::vector<std::string>{"foot"});
  EXPECT_EQ(a.points.at("corner"), Vec2(1, 0));
}

TEST(GmshModel, AMeshMayNotOverlapLeaveThePlaneOrBeCutAgain) {
  EXPECT_THAT(complaint(GmshFile("a.msh", replaced(old_mesh, "5 2 0 0", "5 2 0 1")).scene("msh")),
              HasSubstr("leaves the plane"));
  EXPECT_THAT(complaint(GmshFile("a.msh", replaced(old_mesh, "2 5 6 3", "1 5 6 4")).scene("msh")),
              HasSubstr("overlaps"));
  EXPECT_THAT(
      complaint(GmshFile("a.msh", old_mesh).scene("msh", ", subdivision: {type: voronoi, blocks: 3}")),
      HasSubstr("must be 'given'"));
}

}  // namespace
}  // namespace dda
