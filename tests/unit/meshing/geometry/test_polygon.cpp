#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "meshing/geometry/polygon.hpp"

namespace dda {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

const Polygon rectangle{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}};
const Polygon angle_section{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};

/// A star-shaped polygon: radii at ascending angles around the origin.
Polygon star(const std::vector<double>& radii) {
  Polygon polygon;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
    polygon.vertices.push_back(radii[i] * Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

Polygon random_star() {
  const auto steps = *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(*rc::gen::inRange(3, 12)),
                                                           rc::gen::inRange(20, 100));
  std::vector<double> radii;
  for (const int step : steps) radii.push_back(0.01 * step);
  return star(radii);
}

TEST(Moments, RectangleHasTheBookValues) {
  const Moments m = moments(rectangle);
  EXPECT_DOUBLE_EQ(m.area, 8);
  EXPECT_TRUE(m.centroid.isApprox(Vec2(2, 1)));
  EXPECT_NEAR(m.second(0, 0), 2 * std::pow(4, 3) / 12, 1e-12);
  EXPECT_NEAR(m.second(1, 1), 4 * std::pow(2, 3) / 12, 1e-12);
  EXPECT_NEAR(m.second(0, 1), 0, 1e-12);
}

TEST(Moments, NonConvexIsTheSumOfItsParts) {
  const Moments foot = moments({{{0, 0}, {3, 0}, {3, 1}, {0, 1}}}),
                leg = moments({{{0, 1}, {1, 1}, {1, 3}, {0, 3}}});
  const Moments whole = moments(angle_section);
  EXPECT_DOUBLE_EQ(whole.area, foot.area + leg.area);
  EXPECT_TRUE(whole.centroid.isApprox((foot.area * foot.centroid + leg.area * leg.centroid) / whole.area));
  Eigen::Matrix2d second = foot.second + leg.second;
  for (const Moments& part : {foot, leg}) {
    const Vec2 arm = part.centroid - whole.centroid;
    second += part.area * arm * arm.transpose();
  }
  EXPECT_TRUE(whole.second.isApprox(second));
}

RC_GTEST_PROP(Moments, FollowRotationAndTranslation, ()) {
  const Polygon polygon = random_star();
  const Eigen::Rotation2Dd turn(0.001 * *rc::gen::inRange(0, 6283));
  const Vec2 shift(*rc::gen::inRange(-1000, 1000), *rc::gen::inRange(-1000, 1000));
  Polygon moved = polygon;
  for (Vec2& x : moved.vertices) x = turn * x + shift;
  const Moments before = moments(polygon), after = moments(moved);
  RC_ASSERT(std::abs(after.area - before.area) < 1e-11);
  RC_ASSERT((after.centroid - (turn * before.centroid + shift)).norm() < 1e-11);
  const Eigen::Matrix2d r = turn.toRotationMatrix();
  RC_ASSERT((after.second - r * before.second * r.transpose()).norm() < 1e-11);
}

TEST(Moments, KeepTheirDigitsFarFromTheOrigin) {
  Polygon far = angle_section;
  for (Vec2& x : far.vertices) x += Vec2(3e3, -3e3);
  EXPECT_TRUE(moments(far).second.isApprox(moments(angle_section).second, 1e-12));
}

RC_GTEST_PROP(Polygon, ContainsItsStarCentreAndNothingOutsideItsBox, ()) {
  const Polygon polygon = random_star();
  RC_ASSERT(contains(polygon, Vec2::Zero(), 0));
  RC_ASSERT(!contains(polygon, bounding_box(polygon.vertices).high + Vec2(0.01, 0), 0.001));
  RC_ASSERT(!defect(polygon));
}

TEST(Polygon, ContainsTheOutlineWithinTolerance) {
  EXPECT_TRUE(contains(rectangle, {4, 1}, 1e-9));
  EXPECT_TRUE(contains(rectangle, {4.005, 1}, 0.01));
  EXPECT_FALSE(contains(rectangle, {4.02, 1}, 0.01));
  EXPECT_FALSE(contains(angle_section, {2, 2}, 0.1));
}

TEST(Polygon, ConvexityIgnoresAVertexOnASide) {
  EXPECT_TRUE(is_convex({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}}));
  EXPECT_FALSE(is_convex(angle_section));
}

TEST(Polygon, DefectsAreNamed) {
  EXPECT_FALSE(defect(angle_section));
  EXPECT_THAT(defect({{{0, 0}, {1, 0}}}), Optional(HasSubstr("fewer than three")));
  EXPECT_THAT(defect({{{0, 0}, {1, 0}, {2, 0}}}), Optional(HasSubstr("zero area")));
  EXPECT_THAT(defect({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}), Optional(HasSubstr("zero area")));
  EXPECT_THAT(defect({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}), Optional(HasSubstr("crosses itself")));
  EXPECT_THAT(defect({{{0, 0}, {2, 0}, {2, 2}, {0, 0}, {-1, 2}}}),
              Optional(HasSubstr("repeats the vertex (0, 0)")));
  EXPECT_THAT(defect({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 0}, {0, 4}}}),
              Optional(HasSubstr("crosses itself")));
}

TEST(Polygon, DropsVerticesOnStraightPieces) {
  EXPECT_EQ(without_collinear({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}}}, 1e-9).size(), 4u);
  EXPECT_EQ(without_collinear({{{1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}}, 1e-9).size(), 4u);
}

TEST(Polygon, OverlapOfConvexPolygons) {
  EXPECT_NEAR(convex_overlap(rectangle, {{{3, 1}, {5, 1}, {5, 5}, {3, 5}}}), 1, 1e-14);
  EXPECT_NEAR(convex_overlap(rectangle, {{{1, 0.5}, {2, 0.5}, {2, 1}}}), 0.25, 1e-14);
  EXPECT_EQ(convex_overlap(rectangle, {{{4, 0}, {5, 0}, {5, 2}, {4, 2}}}), 0);
}

TEST(Polygon, LeftPartAndItsComplementMakeTheWhole) {
  const Vec2 a(1, -1), b(2, 3);
  EXPECT_NEAR(signed_area(left_part(rectangle, a, b)) + signed_area(left_part(rectangle, b, a)), 8, 1e-14);
}

}  // namespace
}  // namespace dda
