#include <gtest/gtest.h>

#include <cmath>

#include "support/structure.hpp"

namespace dda {
namespace {

std::string beam(int columns, const std::string& law, const std::string& field) {
  return "scene:\n"
         "  regions: [{name: beam, material: stone, vertices: [[0, 0], [400, 0], [400, 100], [0, 100]]}]\n"
         "  boundaries: {left: [[0, 0], [0, 100]], right: [[400, 0], [400, 100]]}\n"
         "  subdivision: {type: grid, columns: " +
         std::to_string(columns) +
         ", rows: 5}\n"
         "materials: {stone: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0.2}}\n"
         "thickness: 100\n"
         "interfaces:\n  joints:\n    between: [stone, stone]\n    law: " +
         law + "\n" + (field.empty() ? "" : "    field: " + field + "\n") +
         "supports: {wall: {boundary: left, fix: xy}}\n"
         "stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]\n";
}

const std::string linear = "{type: linear_softening, tensile_strength: 3, cohesion: 5, fracture_energy: 0.1}";
const std::string varied = "{coefficient_of_variation: 0.2, correlation_length: 30, seed: 5}";

TEST(InterfaceFields, EveryPointHasTheStrengthOfItsPlaceWhateverTheBlocks) {
  const RandomField field(
      {.coefficient_of_variation = 0.2, .correlation_length = 30, .energy_exponent = 2, .seed = 5});
  for (const int columns : {20, 33}) {
    const Equilibrium equilibrium = Structure(beam(columns, linear, varied)).equilibrium();
    double lowest = 1, highest = 1;
    for (const InterfacePoint& point : equilibrium.interfaces().points) {
      const double f = field.factor(point.x), k = point.stiffness;
      EXPECT_EQ(point.strength_factor, f);
      EXPECT_NEAR(point.law->initial_kappa(k), 3 * f / k, 1e-14 * f);
      const Vec2 sliding(0, 1.0000001 * f / k * 3 / (5.0 / 3));
      EXPECT_NEAR(point.law->respond(sliding, {}, k).traction.y(), 5 * f, 1e-5 * f) << "cohesion";
      EXPECT_NEAR(point.law->accept({point.law->rupture_kappa(k), 0}, {}, k).dissipated, 0.1 * f * f,
                  1e-12 * f);
      lowest = std::min(lowest, f);
      highest = std::max(highest, f);
    }
    EXPECT_LT(lowest, 0.75);
    EXPECT_GT(highest, 1.3);
  }
}

/// l_ch of every place is that of the mean where energies go with the square of strengths.
TEST(InterfaceFields, TheEnergyExponentSetsTheSofteningSlope) {
  const auto slope_spread = [](const std::string& exponent) {
    const Structure made(
        beam(20, linear,
             "{coefficient_of_variation: 0.2, correlation_length: 30, energy_exponent: " + exponent + "}"));
    double spread = 0;
    const Equilibrium equilibrium = made.equilibrium();
    for (const InterfacePoint& point : equilibrium.interfaces().points)
      spread = std::max(spread, std::abs(point.law->steepest_slope() / (9 / 0.2) - 1));
    return spread;
  };
  EXPECT_LT(slope_spread("2"), 1e-14);
  EXPECT_GT(slope_spread("1"), 0.2);
}

/// A short, tough spot next to brittle ones: each side's stiffness bears the steepest of its points.
TEST(InterfaceFields, StiffnessExceedsTheSlopeOfEveryPoint) {
  const Structure made(beam(10, "{type: linear_softening, tensile_strength: 3, fracture_energy: 0.004}",
                            "{coefficient_of_variation: 0.2, correlation_length: 10, energy_exponent: 0}"));
  const Equilibrium equilibrium = made.equilibrium();
  for (const InterfacePoint& point : equilibrium.interfaces().points)
    EXPECT_GT(point.stiffness, 1.01 * point.law->steepest_slope());
  EXPECT_FALSE(equilibrium.interfaces().notices.empty()) << "the stiffness was raised";
}

TEST(InterfaceFields, NoVariationSharesTheLawOfAllPoints) {
  const Equilibrium equilibrium =
      Structure(beam(10, linear, "{coefficient_of_variation: 0, correlation_length: 30}")).equilibrium();
  const auto& points = equilibrium.interfaces().points;
  for (const InterfacePoint& point : points) EXPECT_EQ(point.law, points.front().law);
  EXPECT_FALSE(equilibrium.interfaces().has_fields);
}

TEST(InterfaceFields, ALawWithoutStrengthCannotVary) {
  for (const std::string law : {"{type: bonded}", "{type: friction, friction_angle: 30}"})
    EXPECT_THROW(Structure(beam(4, law, varied)).equilibrium(), InputError) << law;
}

/// Strength and energy of a side go with its projection on the given plane, with a floor where it lies across.
TEST(InterfaceFields, SidesAreAsStrongAsTheirProjectionOnAGivenPlane) {
  std::string deck = beam(20, linear, "");
  deck.replace(deck.find("{type: grid, columns: 20, rows: 5}"), 34, "{type: voronoi, blocks: 60}");
  deck.replace(deck.find("    law:"), 8, "    crack_normal: [2, 0]\n    law:");
  const Equilibrium equilibrium = Structure(deck).equilibrium();
  double lowest = 1, highest = 0;
  for (const InterfacePoint& point : equilibrium.interfaces().points) {
    const double k = point.stiffness, share = std::max(0.3, std::abs(point.normal.x()));
    EXPECT_NEAR(point.law->initial_kappa(k), 3 * share / k, 1e-14 / k);
    EXPECT_NEAR(point.law->accept({point.law->rupture_kappa(k), 0}, {}, k).dissipated, 0.1 * share, 1e-12);
    EXPECT_EQ(point.strength_factor, 1);
    lowest = std::min(lowest, share);
    highest = std::max(highest, share);
  }
  EXPECT_EQ(lowest, 0.3);
  EXPECT_GT(highest, 0.99);
}

}  // namespace
}  // namespace dda
