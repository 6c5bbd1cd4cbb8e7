#include <gmock/gmock.h>

#include "support/structure.hpp"

namespace dda {
namespace {

class OnSquare : public testing::Test {
 protected:
  Functional gauge(const std::string& yaml) const {
    const Equilibrium equilibrium = square_.equilibrium();
    return gauges()
        .choose(parse_yaml(yaml, "d"))
        .make()
        ->functional({square_.body(), equilibrium.stages().back().reactions});
  }
  StageLoads load(const std::string& yaml) const {
    StageLoads out = square_.no_loads();
    loads().choose(parse_yaml(yaml, "d")).make()->add_to(out, square_.body());
    return out;
  }
  /// Power of the load in the field u = a + G x.
  double power(const StageLoads& of, const Vec2& a, const Mat2& g) const {
    const std::vector<double> d = square_.field(a, g);
    double sum = 0;
    for (std::size_t i = 0; i < d.size(); ++i) sum += of.force[i] * d[i];
    return sum;
  }
  Vec2 displacement(std::size_t block, const Vec2& x, const std::vector<double>& d) const {
    return displacement_rows(x - square_.assembly().blocks[block].moments.centroid) *
           Eigen::Map<const Vec6>(d.data() + 6 * block);
  }
  static Mat2 gradient() {
    Mat2 g;
    g << 0.3, -0.2, 0.5, 0.7;
    return g;
  }
  const Structure square_{square_deck()};
  Random random_{4};
};

TEST_F(OnSquare, DisplacementOfAPointOfOneBlock) {
  const std::vector<double> d = random_.vector(24, 1);
  const double value = gauge("{type: displacement, at: [0.9, 0.1], direction: [3, 4]}").value(d, 0);
  EXPECT_NEAR(value, Vec2(0.6, 0.8).dot(displacement(1, {0.9, 0.1}, d)), 1e-14);
}

TEST_F(OnSquare, DisplacementWhereBlocksMeetIsTheirMeanOrThatOfOne) {
  const std::vector<double> d = random_.vector(24, 1);
  const Vec2 x(0.6, 0.45);
  double mean = 0;
  for (std::size_t b = 0; b < 4; ++b) mean += displacement(b, x, d).y() / 4;
  EXPECT_NEAR(gauge("{type: displacement, at: [0.6, 0.45], direction: [0, 1]}").value(d, 0), mean, 1e-14);
  EXPECT_NEAR(
      gauge("{type: displacement, at: [0.6, 0.45], inside: [0.8, 0.8], direction: [0, 1]}").value(d, 0),
      displacement(2, x, d).y(), 1e-14);
}

TEST_F(OnSquare, RelativeDisplacement) {
  const std::vector<double> d = random_.vector(24, 1);
  const Vec2 from(0.1, 0.1), to(0.9, 0.7), l = (to - from).normalized();
  EXPECT_NEAR(gauge("{type: relative_displacement, from: [0.1, 0.1], to: [0.9, 0.7]}").value(d, 0),
              l.dot(displacement(2, to, d) - displacement(0, from, d)), 1e-14);
}

TEST_F(OnSquare, ReactionIsTheForceOfTheSpringsOnTheStructure) {
  // A shift of the whole square by (1, 0) stretches every spring of the wall by 1; they pull back.
  const Equilibrium equilibrium = square_.equilibrium();
  const double stiffness = 1e5 * 3 * 0.7;
  const std::vector<double> d = square_.field({1, 0}, Mat2::Zero());
  EXPECT_NEAR(gauge("{type: reaction, of: wall.x}").value(d, 0) / (-4 * stiffness), 1, 1e-14);
  EXPECT_NEAR(gauge("{type: reaction, of: wall.y}").value(d, 0), 0, 1e-10);
  EXPECT_EQ(gauge("{type: reaction, of: wall.x, scale: -2}").value(d, 0), 8 * stiffness);
}

TEST_F(OnSquare, LoadGaugeIsTheScaledLoadFactor) {
  EXPECT_EQ(gauge("{type: load, scale: 250}").value(random_.vector(24, 1), 0.4), 100);
}

TEST_F(OnSquare, PointLoad) {
  const StageLoads found = load("{type: point_load, at: [0.6, 0.45], force: [2, -3]}");
  const Vec2 u = Vec2(1, 2) + gradient() * Vec2(0.6, 0.45);
  EXPECT_NEAR(power(found, {1, 2}, gradient()), Vec2(2, -3).dot(u), 1e-14);
  EXPECT_NEAR(found.resultant, std::sqrt(13.0), 1e-15);
}

TEST_F(OnSquare, EdgeTractionIsExactForLinearDisplacements) {
  const StageLoads found = load("{type: edge_traction, boundary: right, traction: [2, -3], pressure: 0.5}");
  // ∫ τ · u dA over x = 1 with thickness 0.7; the pressure acts against n = (1, 0).
  const Vec2 u = Vec2(1, 2) + gradient() * Vec2(1, 0.5);
  EXPECT_NEAR(power(found, {1, 2}, gradient()), 0.7 * Vec2(1.5, -3).dot(u), 1e-14);
  EXPECT_NEAR(found.resultant, 0.7 * Vec2(1.5, -3).norm(), 1e-14);
}

TEST_F(OnSquare, BodyForce) {
  const StageLoads everywhere = load("{type: body_force, force: [2, -3]}");
  const Vec2 u = Vec2(1, 2) + gradient() * Vec2(0.5, 0.5);
  EXPECT_NEAR(power(everywhere, {1, 2}, gradient()), 0.7 * Vec2(2, -3).dot(u), 1e-14);
  const auto& blocks = square_.assembly().blocks;
  const double mortar = blocks[0].moments.area + blocks[3].moments.area;
  EXPECT_NEAR(power(load("{type: body_force, force: [2, -3], materials: [mortar]}"), {0, 1}, Mat2::Zero()),
              -3 * 0.7 * mortar, 1e-14);
  EXPECT_NEAR(power(load("{type: body_force, force: [2, -3], regions: [b]}"), {0, 1}, Mat2::Zero()),
              -3 * 0.7 * blocks[1].moments.area, 1e-14);
}

TEST_F(OnSquare, InitialStressWorksAgainstTheStrain) {
  const StageLoads found = load("{type: initial_stress, xx: 2, yy: -1, xy: 0.5}");
  const double strain_work = 2 * 0.3 - 1 * 0.7 + 0.5 * (0.5 - 0.2);
  EXPECT_NEAR(power(found, {1, 2}, gradient()), -0.7 * strain_work, 1e-14);
  const StageLoads partly = load("{type: initial_stress, xx: 2, regions: [b]}");
  EXPECT_EQ(partly.initial_stress[1], Vec3(2, 0, 0));
  EXPECT_EQ(partly.initial_stress[0], Vec3(0, 0, 0));
  EXPECT_EQ(load("{type: initial_stress, xx: 2, materials: [mortar]}").initial_stress[3], Vec3(2, 0, 0));
}

TEST_F(OnSquare, PrescribedDisplacementDrivesASpring) {
  const StageLoads found =
      load("{type: prescribed_displacement, at: [1, 0.2], direction: [0, -2], displacement: 0.3}");
  ASSERT_EQ(found.driven.size(), 1u);
  EXPECT_EQ(found.driven[0].name, "");
  EXPECT_EQ(found.driven[0].prescribed, 0.3);
  const std::vector<double> d = random_.vector(24, 1);
  EXPECT_NEAR(found.driven[0].displacement.value(d, 0), -displacement(1, {1, 0.2}, d).y(), 1e-14);
}

// The right side of the square: block 1 up to y = 0.55, block 2 above.

TEST_F(OnSquare, LoadOverAPatchHasTheResultantAndMomentOfItsMiddle) {
  const StageLoads found = load("{type: point_load, over: [[1, 0.9], [1, 0.2]], force: [2, -3]}");
  const Vec2 u = Vec2(1, 2) + gradient() * Vec2(1, 0.55);
  EXPECT_NEAR(power(found, {1, 2}, gradient()), Vec2(2, -3).dot(u), 1e-14);
  EXPECT_NEAR(found.resultant, std::sqrt(13.0), 1e-15);
  EXPECT_NEAR(found.force[6 * 1], 2 * 0.35 / 0.7, 1e-14);
  EXPECT_NEAR(found.force[6 * 2], 2 * 0.35 / 0.7, 1e-14);
}

TEST_F(OnSquare, LoadOverAPatchIsAnEvenTraction) {
  const StageLoads patch = load("{type: point_load, over: [[1, 0], [1, 1]], force: [1.4, -2.1]}");
  const StageLoads traction = load("{type: edge_traction, boundary: right, traction: [2, -3]}");
  for (std::size_t i = 0; i < patch.force.size(); ++i) EXPECT_NEAR(patch.force[i], traction.force[i], 1e-14);
}

TEST_F(OnSquare, DisplacementOverAPatchIsTheMean) {
  const std::vector<double> d = random_.vector(24, 1);
  double mean = 0;
  constexpr int pieces = 7000;  // midpoints are exact where u is linear
  for (int i = 0; i < pieces; ++i) {
    const Vec2 x(1, 0.2 + 0.7 * (i + 0.5) / pieces);
    mean += displacement(x.y() < 0.55 ? 1 : 2, x, d).y() / pieces;
  }
  EXPECT_NEAR(gauge("{type: displacement, over: [[1, 0.2], [1, 0.9]], direction: [0, 3]}").value(d, 0), mean,
              1e-12);
  const StageLoads driven =
      load("{type: prescribed_displacement, over: [[1, 0.2], [1, 0.9]], direction: [0, 1]}");
  EXPECT_NEAR(driven.driven.at(0).displacement.value(d, 0), mean, 1e-12);
}

TEST_F(OnSquare, RotationOfAPatchIsThatOfARigidMotion) {
  Mat2 turn;
  turn << 0, -0.3, 0.3, 0;
  const Functional rotation =
      rotation_over(square_.body(), {{}, {}, std::vector<Spot>{Spot(1, 0.2), Spot(1, 0.9)}}, {});
  EXPECT_NEAR(rotation.value(square_.field({1, 2}, turn), 0), 0.3, 1e-14);
}

TEST_F(OnSquare, AMomentWorksOnTheRotationAlone) {
  Mat2 turn;
  turn << 0, -0.3, 0.3, 0;
  for (const char* place : {"at: [0.8, 0.8]", "at: [0.6, 0.45]", "over: [[1, 0.2], [1, 0.9]]"}) {
    const StageLoads found = load(std::string("{type: moment, moment: 5, ") + place + "}");
    EXPECT_NEAR(power(found, {1, 2}, Mat2::Zero()), 0, 1e-13) << place;
    EXPECT_NEAR(power(found, {1, 2}, turn), 5 * 0.3, 1e-13) << place;
    EXPECT_EQ(found.resultant, 0);
  }
}

TEST_F(OnSquare, AMomentOverAPatchIsATractionThatGrowsFromItsMiddle) {
  // t = 12 M s/(L³ thickness) along the normal, M = 5, over the whole right side; counter-clockwise is outward below.
  const StageLoads moment = load("{type: moment, over: [[1, 0], [1, 1]], moment: 5}");
  const StageLoads traction =
      load("{type: edge_traction, boundary: right, traction: [12*5/0.7*(0.5 - y), 0]}");
  for (std::size_t i = 0; i < moment.force.size(); ++i) EXPECT_NEAR(moment.force[i], traction.force[i], 1e-9);
}

TEST_F(OnSquare, RotationIsDualToAMoment) {
  const std::vector<double> d = random_.vector(24, 1);
  EXPECT_EQ(gauge("{type: rotation, at: [0.8, 0.8]}").value(d, 0), d[6 * 2 + 2]);
  for (const char* place : {"at: [0.6, 0.45]", "over: [[1, 0.2], [1, 0.9]]", "over: [[0, 0], [1, 0]]"}) {
    const std::string where(place);
    const StageLoads unit = load("{type: moment, moment: 1, " + where + "}");
    double work = 0;
    for (std::size_t i = 0; i < d.size(); ++i) work += unit.force[i] * d[i];
    EXPECT_NEAR(gauge("{type: rotation, " + where + "}").value(d, 0), work, 1e-12) << place;
    EXPECT_NEAR(gauge("{type: rotation, scale: -2, " + where + "}").value(d, 0), -2 * work, 1e-12);
  }
}

TEST_F(OnSquare, WhatIsNoPatchIsRefused) {
  const auto refusal = [&](const std::string& place) {
    try {
      load("{type: point_load, force: [0, 1], " + place + "}");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using testing::HasSubstr;
  EXPECT_THAT(refusal("over: [[1, 0.5], [1, 1.5]]"),
              HasSubstr("only 50 % of the patch from (1, 0.5) to (1, 1.5)"));
  EXPECT_THAT(refusal("over: [[0.2, 0.2], [0.4, 0.2]]"), HasSubstr("only 0 % of the patch"));
  EXPECT_THAT(refusal("over: [[1, 0.5]]"), HasSubstr("takes the two ends"));
  EXPECT_THAT(refusal("over: [[1, 0.5], [1, 0.5]]"), HasSubstr("are the same"));
  EXPECT_THAT(refusal("at: [1, 0.5], over: [[1, 0.2], [1, 0.9]]"), HasSubstr("give either `at`"));
  EXPECT_THAT(refusal("inside: [0.9, 0.5]"), HasSubstr("give either `at`"));
}

/// The square with named points.
std::string square_with_points() {
  std::string deck = square_deck();
  return deck.replace(deck.find("  boundaries:"), 0,
                      "  points: {low: [1, 0.2], high: [1, 0.9], middle: [0.6, 0.45], in_c: [0.8, 0.8]}\n");
}

TEST(NamedPoints, ServeWhereverAPlaceIsMeant) {
  const Structure square(square_with_points());
  Random random(7);
  const std::vector<double> d = random.vector(24, 1);
  const auto value = [&](const std::string& yaml) {
    return gauges().choose(parse_yaml(yaml, "d")).make()->functional({square.body(), {}}).value(d, 0);
  };
  EXPECT_EQ(value("{type: displacement, at: middle, inside: in_c, direction: [0, 1]}"),
            value("{type: displacement, at: [0.6, 0.45], inside: [0.8, 0.8], direction: [0, 1]}"));
  EXPECT_EQ(value("{type: displacement, over: [low, [1, 0.9]], direction: [0, 1]}"),
            value("{type: displacement, over: [[1, 0.2], high], direction: [0, 1]}"));
  EXPECT_EQ(value("{type: relative_displacement, from: middle, from_inside: in_c, to: low}"),
            value("{type: relative_displacement, from: [0.6, 0.45], from_inside: [0.8, 0.8], to: [1, 0.2]}"));
  for (const std::string more : {"point_load, force: [2, 3]", "prescribed_displacement, direction: [0, 1]"}) {
    StageLoads named = square.no_loads(), given = square.no_loads();
    loads().choose(parse_yaml("{type: " + more + ", at: low}", "d")).make()->add_to(named, square.body());
    loads()
        .choose(parse_yaml("{type: " + more + ", at: [1, 0.2]}", "d"))
        .make()
        ->add_to(given, square.body());
    EXPECT_EQ(named.force, given.force);
    EXPECT_EQ(named.driven.size(), given.driven.size());
  }
}

TEST(NamedPoints, AMisspeltNameIsToldWithItsPlaceAndTheNearest) {
  const Structure square(square_with_points());
  const auto refusal = [&](const Structure& of, const std::string& name) {
    try {
      gauges()
          .choose(parse_yaml("type: displacement\nat: " + name + "\ndirection: [0, 1]", "d.yaml"))
          .make()
          ->functional({of.body(), {}});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(square, "midle"), "d.yaml:2:5: unknown point 'midle'; did you mean 'middle'?");
  EXPECT_THAT(refusal(Structure(square_deck()), "midle"), testing::HasSubstr("the scene names no points"));
}

}  // namespace
}  // namespace dda
