#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "models/load/load.hpp"
#include "models/load/quadrature.hpp"
#include "support/structure.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

/// A dam with an upright and an inclined face, of blocks as a subdivision makes them.
std::string dam(const std::string& subdivision) {
  return R"(
scene:
  regions: [{material: concrete, vertices: [[0, 0], [3, 0], [1, 4], [0, 4]]}]
  boundaries: {upright: [[0, 0], [0, 4]], inclined: [[3, 0], [1, 4]]}
  subdivision: )" +
         subdivision + R"(
thickness: 2
materials: {concrete: {type: linear_elastic, young_modulus: 30, poisson_ratio: 0.2}}
supports: {ground: {at: [0, 0], fix: xy}, other: {at: [3, 0], fix: y}}
stages: [{loads: [{type: point_load, at: [0, 4], force: [1, 0]}]}]
)";
}

struct Resultant {
  Vec2 force;
  double moment;  ///< about the origin
};

class VaryingLoad : public testing::TestWithParam<std::string> {
 protected:
  Resultant of(const std::string& load) const {
    StageLoads stage = dam_.no_loads();
    loads().choose(parse_yaml(load, "deck.yaml")).make()->add_to(stage, dam_.body());
    Mat2 turn;
    turn << 0, -1, 1, 0;
    const auto power = [&](const Vec2& a, const Mat2& g) {
      const std::vector<double> d = dam_.field(a, g);
      return std::inner_product(d.begin(), d.end(), stage.force.begin(), 0.0);
    };
    return {{power({1, 0}, Mat2::Zero()), power({0, 1}, Mat2::Zero())}, power({0, 0}, turn)};
  }
  static void expect(const Resultant& found, const Vec2& force, double moment) {
    const double size = force.norm() + std::abs(moment);
    EXPECT_NEAR(found.force.x(), force.x(), 1e-10 * size);
    EXPECT_NEAR(found.force.y(), force.y(), 1e-10 * size);
    EXPECT_NEAR(found.moment, moment, 1e-10 * size);
  }
  const Structure dam_{dam(GetParam())};
};

TEST_P(VaryingLoad, WaterOnAnUprightFace) {
  // ½ ρ g H² per thickness, H/3 above the ground.
  const double f = 2 * 10 * 4 * 4 / 2.0;
  expect(of("{type: edge_traction, boundary: upright, pressure: 10*(4 - y)}"), {f, 0}, -f * 4 / 3);
  expect(of("{type: edge_traction, boundary: upright, traction: [10*(4 - y), 0]}"), {f, 0}, -f * 4 / 3);
}

TEST_P(VaryingLoad, WaterUpToALevelWithinASide) {
  const double h = 2.7183, f = 2 * 10 * h * h / 2;
  expect(of("{type: edge_traction, boundary: upright, pressure: \"10*max(0, 2.7183 - y)\"}"), {f, 0},
         -f * h / 3);
  expect(of("{type: edge_traction, boundary: upright, pressure: \"y < 2.7183 ? 10*(2.7183 - y) : 0\"}"),
         {f, 0}, -f * h / 3);
}

TEST_P(VaryingLoad, WaterOnAnInclinedFace) {
  // By components: sideways as on an upright face, downwards the weight of the water above, a triangle of area 4.
  const double sideways = 2 * 10 * 8, weight = 2 * 10 * 4;
  expect(of("{type: edge_traction, boundary: inclined, pressure: 10*(4 - y)}"), {-sideways, -weight},
         sideways * 4 / 3 - weight * (3 - 2 / 3.0));
}

TEST_P(VaryingLoad, AJumpOfTractionAlongAFace) {
  expect(of("{type: edge_traction, boundary: upright, traction: [\"y > 1.3 ? 5 : 0\", 0]}"), {2 * 5 * 2.7, 0},
         -2 * 5 * 2.7 * 2.65);
}

TEST_P(VaryingLoad, SmoothTractionsOfAnyShape) {
  // ∫ sin(πy/4) dy = 8/π over the face, by symmetry about its middle.
  expect(of("{type: edge_traction, boundary: upright, traction: [0, sin(pi*y/4)]}"),
         {0, 16 / std::numbers::pi}, 0);
}

TEST_P(VaryingLoad, BodyForces) {
  // b = (0, -x) over the trapezoid 0 ≤ x ≤ 3 − y/2: ∫ x dA = ∫ (3 − y/2)²/2 dy, ∫ x² dA = ∫ (3 − y/2)³/3 dy.
  const double first = (27 - 1) / 3.0, second = (81 - 1) / 6.0;
  expect(of("{type: body_force, force: [0, -x]}"), {0, -2 * first}, -2 * second);
  // Of density 2 below y = 1.5, 1 above.
  const double below = 3 * 1.5 - 1.5 * 1.5 / 4, all = 8;
  const auto found = of("{type: body_force, force: [0, \"y < 1.5 ? -2 : -1\"]}");
  EXPECT_NEAR(found.force.y(), -2 * (all + below), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Subdivisions, VaryingLoad,
                         testing::Values("given", "{type: squares, size: 0.7}",
                                         "{type: voronoi, blocks: 30}"));

TEST(VaryingLoads, StressWithoutStrainIsTheMeanOfEachBlock) {
  const Structure on(dam("{type: squares, size: 0.7}"));
  StageLoads stage = on.no_loads();
  loads()
      .choose(parse_yaml("{type: initial_stress, xx: -5*(4 - y), xy: 3}", "deck.yaml"))
      .make()
      ->add_to(stage, on.body());
  for (std::size_t b = 0; b < on.assembly().num_blocks(); ++b) {
    const Vec2& c = on.assembly().blocks[b].moments.centroid;
    EXPECT_NEAR((stage.initial_stress[b] - Vec3(-5 * (4 - c.y()), 0, 3)).norm(), 0, 1e-9);
  }
}

TEST(VaryingLoads, ConstantExpressionsAreTheSameLoad) {
  const Structure on(dam("given"));
  const auto force = [&](const std::string& load) {
    StageLoads stage = on.no_loads();
    loads().choose(parse_yaml(load, "deck.yaml")).make()->add_to(stage, on.body());
    return stage.force;
  };
  EXPECT_EQ(force("{type: edge_traction, boundary: upright, traction: [3, -2]}"),
            force("{type: edge_traction, boundary: upright, traction: [2 + 1, \"-4/2\"]}"));
  const std::vector<double> even = force("{type: body_force, force: [3, -2]}"),
                            varying = force("{type: body_force, force: [3 + 0*x, -2]}");
  for (std::size_t i = 0; i < even.size(); ++i) EXPECT_NEAR(varying[i], even[i], 1e-10 * 48) << i;
}

TEST(VaryingLoads, WhatIsWrongIsTold) {
  const Structure on(dam("given"));
  const auto said = [&](const std::string& load) {
    return messages([&] {
      StageLoads stage = on.no_loads();
      loads().choose(parse_yaml(load, "deck.yaml")).make()->add_to(stage, on.body());
    });
  };
  EXPECT_THAT(said("{type: edge_traction, boundary: upright, pressure: 1/x}"),
              testing::HasSubstr("deck.yaml:1:52: '1/x' is no finite number at (0, "));
  EXPECT_THAT(
      said("{type: edge_traction, boundary: upright, pressure: g*(4 - y)}"),
      testing::HasSubstr("deck.yaml:1:52: pressure: expected a number or an expression of x and y, found "
                         "'g*(4 - y)': 'g' is no variable"));
  EXPECT_THAT(said("{type: edge_traction, boundary: upright, traction: 3*y}"),
              testing::HasSubstr("expected two components [fx, fy]"));
}

TEST(Quadrature, ExactOnPolygonsThatAreNotConvex) {
  // An L of 1 × 3 and 2 × 1, and a function that is no number outside of it.
  const Polygon corner{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
  const auto f = [](const Vec2& x) -> Integrals {
    EXPECT_TRUE((x.x() <= 1 || x.y() <= 1) && x.x() >= 0 && x.y() >= 0);
    return Integrals::Constant(x.x() * x.x() * x.y());
  };
  EXPECT_NEAR(integral(corner, f)[3], 1 / 3.0 * 9 / 2 + (27 - 1) / 3.0 / 2, 1e-12);
}

TEST(Quadrature, FindsWhatIsNarrow) {
  const auto strip = [](double t) -> Integrals { return Integrals::Constant(std::abs(t - 0.613) < 0.01); };
  EXPECT_NEAR(integral(0, 1, strip, halvings_of_side(false))[0], 0.02, 1e-10);
}

TEST(Quadrature, KnowsWhatNothingNarrowHidesIn) {
  const auto is_plain = [](const std::string& text) { return Formula(nullptr, text, {}).is_plain(); };
  for (const char* text : {"2*x + y/3", "-(x^2)*1.5", "9810*(40 - y)"}) EXPECT_TRUE(is_plain(text)) << text;
  for (const char* text : {"1/x", "max(0, y)", "x < 1 ? 1 : 0", "exp(-x)", "y / (x + 1)"})
    EXPECT_FALSE(is_plain(text)) << text;
}

TEST(Quadrature, ComesToAnEndWhateverItIsAsked) {
  int asked = 0;
  integral(0, 1, [&](double t) -> Integrals {
    ++asked;
    return Integrals::Constant(std::sin(1e9 * t));
  });
  EXPECT_LT(asked, 40'000);
}

}  // namespace
}  // namespace dda
