#include <gmock/gmock.h>

#include "meshing/mirror.hpp"
#include "models/treatment/mirrored.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

TEST(Symmetry, TheImageMovesAndStrainsAsInAMirror) {
  const Vec2 normal = Vec2(0.6, -0.8);
  const Mat2 m = Mat2::Identity() - 2 * normal * normal.transpose();
  Vec6 d;
  d << 0.3, -0.2, 0.5, 0.1, -0.4, 0.7;
  const MotionRows rows{displacement_rows({0.4, 0.9}), strain_rows()}, image = mirrored(rows, normal);
  EXPECT_TRUE((image.displacement * d).isApprox(m * (rows.displacement * d), 1e-14));
  Mat2 strain;
  strain << d[3], d[5] / 2, d[5] / 2, d[4];
  const Mat2 turned = m * strain * m;
  const Vec3 expected(turned(0, 0), turned(1, 1), 2 * turned(0, 1));
  EXPECT_TRUE((image.strain * d).isApprox(expected, 1e-14));
}

TEST(Symmetry, ABoundaryBecomesSidesThatAreTheirOwnNeighbours) {
  const Structure square(square_deck());
  Assembly assembly = square.assembly();
  const std::size_t sides = assembly.sides.size(), boundary = assembly.boundary.size();
  Findings findings;
  add_mirror_sides(assembly, std::vector<Mirror>{{"left", "axis", {}}}, findings);
  EXPECT_TRUE(findings.empty());
  const std::size_t made = assembly.sides.size() - sides;
  EXPECT_EQ(assembly.boundary.size(), boundary - made);
  ASSERT_GT(made, 0u);
  double length = 0;
  for (std::size_t s = sides; s < assembly.sides.size(); ++s) {
    EXPECT_TRUE(assembly.sides[s].is_mirror());
    EXPECT_EQ(assembly.curves[static_cast<std::size_t>(*assembly.sides[s].curve)], "axis");
    length += (assembly.sides[s].end - assembly.sides[s].start).norm();
  }
  EXPECT_NEAR(length, 1, 1e-12);
}

}  // namespace
}  // namespace dda
