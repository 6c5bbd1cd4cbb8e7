#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "meshing/cracks/chord.hpp"

namespace dda {
namespace {

constexpr double tol = 1e-9;
const Polygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
/// A U, open at the top.
const Polygon trough{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};

TEST(Chord, EntersFromAnEdgeAndFromAVertex) {
  EXPECT_TRUE(enters(square, {0.5, 0}, {0, 1}, tol));
  EXPECT_FALSE(enters(square, {0.5, 0}, {0, -1}, tol));
  EXPECT_FALSE(enters(square, {0.5, 0}, {1, 0}, tol)) << "along the edge";
  EXPECT_TRUE(enters(square, {0, 0}, {1, 1}, tol));
  EXPECT_FALSE(enters(square, {0, 0}, {1, -0.1}, tol));
  EXPECT_FALSE(enters(square, {0, 0}, {1, 0}, tol));
  EXPECT_FALSE(enters(square, {2, 2}, {-1, -1}, tol)) << "off the outline";
  EXPECT_TRUE(enters(trough, {1, 1}, {-1, 1}, tol)) << "reentrant vertex";
  EXPECT_FALSE(enters(trough, {1, 1}, {1, 1}, tol));
}

TEST(Chord, LeavesANonConvexPolygonWhereItFirstMeetsIt) {
  EXPECT_TRUE(exit_of(trough, {0, 1.5}, {1, 0}, tol)->isApprox(Vec2(1, 1.5)));
  EXPECT_TRUE(exit_of(trough, {0, 0.5}, {1, 0}, tol)->isApprox(Vec2(3, 0.5)));
  EXPECT_EQ(*exit_of(trough, {0, 1}, {1, 0}, tol), Vec2(1, 1)) << "a vertex exactly";
}

TEST(Chord, EndsAtAVertexWithinTheTolerance) {
  const auto at = exit_of(square, {0.5, 0}, Vec2(0.5 - 0.3e-9, 1), tol);
  EXPECT_EQ(*at, Vec2(1, 1));
}

TEST(Chord, DividesIntoLeftAndRight) {
  const auto [left, right] = divided(trough, {1.5, 0}, {1.5, 1}, tol);
  EXPECT_DOUBLE_EQ(signed_area(left), 2.5);
  EXPECT_DOUBLE_EQ(signed_area(right), 2.5);
  EXPECT_LT(moments(left).centroid.x(), 1.5);
  EXPECT_GT(moments(right).centroid.x(), 1.5);
}

TEST(Chord, DividesFromVertexToVertex) {
  const auto [left, right] = divided(square, {0, 0}, {1, 1}, tol);
  EXPECT_EQ(left.size(), 3u);
  EXPECT_EQ(right.size(), 3u);
  EXPECT_DOUBLE_EQ(signed_area(left), 0.5);
}

TEST(Chord, AlongAnEdgeCutsNothingOff) {
  for (const auto& [p, q] : {std::pair(Vec2(0, 0), Vec2(1, 0)), std::pair(Vec2(1, 0), Vec2(0.2, 0)),
                             std::pair(Vec2(0.2, 0), Vec2(0.7, 0)), std::pair(Vec2(0.7, 0), Vec2(0, 0))}) {
    const auto [left, right] = divided(square, p, q, tol);
    EXPECT_EQ(std::min(signed_area(left), signed_area(right)), 0);
  }
}

TEST(Chord, DistanceIsZeroInside) {
  EXPECT_EQ(distance({0.5, 0.5}, square), 0);
  EXPECT_DOUBLE_EQ(distance({2, 0.5}, square), 1);
}

Polygon random_star() {
  const auto steps = *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(*rc::gen::inRange(3, 12)),
                                                           rc::gen::inRange(20, 100));
  Polygon out;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps.size());
    out.vertices.push_back(0.01 * steps[i] * Vec2(std::cos(angle), std::sin(angle)));
  }
  return out;
}

RC_GTEST_PROP(Chord, PartsAddUpAndAreSimple, ()) {
  const Polygon polygon = random_star();
  const auto edge = *rc::gen::inRange<std::size_t>(0, polygon.size());
  const double share = 0.01 * *rc::gen::inRange(1, 100);
  const Vec2 along = polygon.at(edge + 1) - polygon.at(edge), from = polygon.at(edge) + share * along;
  const double angle = 0.001 * *rc::gen::inRange(1, 3141);  // counter-clockwise of the edge: inwards
  const Vec2 direction = std::cos(angle) * along + std::sin(angle) * Vec2(-along.y(), along.x());
  RC_ASSERT(enters(polygon, from, direction, tol));
  const auto to = exit_of(polygon, from, direction, tol);
  RC_ASSERT(to.has_value());
  const auto [left, right] = divided(polygon, from, *to, tol);
  const double all = signed_area(polygon), one = signed_area(left), other = signed_area(right);
  RC_ASSERT(one > -1e-12 && other > -1e-12);
  RC_ASSERT(std::abs(one + other - all) <= 1e-13 * all);
  for (const Polygon& part : {left, right})
    if (signed_area(part) > 1e-6) RC_ASSERT(!defect(part));
}

}  // namespace
}  // namespace dda
