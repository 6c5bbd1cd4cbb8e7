// Unilateral contact with friction and elastic joints between two blocks, under every treatment.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/stepped.hpp"

namespace dda::verification {
namespace {

constexpr double young = 1000, height = 10, width = 40, thickness = 2, area = width * thickness;

/// Two blocks one upon the other: the lower held at its foot, the upper guided against rotation. `treatment`
/// and `law` are YAML, `rest` the upper block's supports, stages and gauges.
std::string two_blocks(const std::string& treatment, const std::string& law, const std::string& rest,
                       double lower_modulus = young) {
  return fmt::format(R"(
scene:
  regions:
    - {{name: lower, material: below, vertices: [[0, 0], [{0}, 0], [{0}, {1}], [0, {1}]]}}
    - {{name: upper, material: above, vertices: [[0, {1}], [{0}, {1}], [{0}, {2}], [0, {2}]]}}
  boundaries: {{foot: [[0, 0], [{0}, 0]], head: [[0, {2}], [{0}, {2}]]}}
thickness: {3}
materials:
  below: {{type: linear_elastic, young_modulus: {4}, poisson_ratio: 0}}
  above: {{type: linear_elastic, young_modulus: {5}, poisson_ratio: 0}}
interfaces:
  contact: {{between: [below, above], points: midpoint, treatment: {6}, law: {7}}}
supports:
  foot: {{boundary: foot, fix: xy}}
  guide: {{at: [{8}, {9}], fix: rotation}}
{10})",
                     width, height, 2 * height, thickness, lower_modulus, young, treatment, law, width / 2,
                     1.5 * height, rest);
}

const std::vector<std::string> treatments_of_joints{"consistent", "{type: penalty, factor: 50}", "lagrange",
                                                    "augmented_lagrangian",
                                                    "{type: augmented_lagrangian, factor: 0.5}"};

/// Compliance 1/k that the treatment itself adds to a joint that holds, blocks of equal modulus [L³/F].
double own_compliance(const std::string& treatment) {
  return treatment.find("penalty") == std::string::npos ? 0 : height / (50 * young);
}

/// The same of a joint that only touches, multipliers keeping some there: δ/((1 + δ) k), with δ = 1e-3 and k
/// = 10 E/h (`lagrange`), or 1/(factor + contact_factor) in h/E.
double compliance_of_contact(const std::string& treatment) {
  if (treatment == "lagrange") return 1e-3 / 1.001 * height / (10 * young);
  if (treatment == "augmented_lagrangian") return height / (1.1e4 * young);
  if (treatment.find("augmented") != std::string::npos) return height / (10000.5 * young);
  return own_compliance(treatment);
}

class Contact : public testing::TestWithParam<std::string> {
 protected:
  /// Gaps left by δ = 1e-9 (Lagrange) and 1e-8 (augmented Lagrangian); springs of the foot and the drive,
  /// together 3e-5 of the blocks' compliance.
  static constexpr double exact = 5e-5;
};

/// The head is lowered, lifted and lowered again: pressure only, and only where the blocks meet.
TEST_P(Contact, OpensFreelyAndCloses) {
  Stepped pair(
      two_blocks(GetParam(), "{type: friction, friction_angle: 20}", R"(  side: {at: [20, 15], fix: x}
stages:
  - loads: [{type: prescribed_displacement, name: head, at: [20, 20], direction: [0, 1], displacement: 0.1}]
)"));
  const double compliance = 2 * height / young + compliance_of_contact(GetParam());
  for (const double lift : {-0.6, 0.5, -1.0, -0.2, 0.4, 1.0, -0.8}) {
    const Attempt tried = pair.to(lift);
    ASSERT_TRUE(tried.converged) << lift << ": " << tried.reason;
    const double expected = lift < 0 ? 0.1 * lift * area / compliance : 0;
    EXPECT_NEAR(pair.force().x(), expected, exact * 0.1 * area / compliance) << lift;
    EXPECT_NEAR(pair.reaction("head"), expected, exact * 0.1 * area / compliance) << lift;
    const double gap = lift < 0 ? -expected / area * compliance_of_contact(GetParam()) : -0.1 * lift;
    EXPECT_NEAR(pair.jump(0).x(), -gap, exact * 0.1) << lift;
  }
}

/// Pressed by N and pushed to and fro: sticks up to N tan φ, slides there, sticks again on the way back.
TEST_P(Contact, SlidesAtTheFrictionAngle) {
  constexpr double pressure = 3, angle = 30;
  Stepped pair(two_blocks(GetParam(), "{type: friction, friction_angle: 30}", R"(stages:
  - loads: [{type: edge_traction, boundary: head, traction: [0, -3]}]
  - loads: [{type: prescribed_displacement, name: push, at: [20, 15], direction: [1, 0], displacement: 0.1}]
)"));
  const Attempt pressed = pair.to(1);
  ASSERT_TRUE(pressed.converged) << pressed.reason;
  EXPECT_NEAR(pair.traction(0).x(), -pressure, exact * pressure);
  pair.next_stage();
  const double limit = pressure * std::tan(angle * std::acos(-1.0) / 180);
  for (const double push : {0.1, 2.0, 3.0, 2.9, 1.0, -1.0, -0.9, 4.0}) {
    const Attempt tried = pair.to(push);
    ASSERT_TRUE(tried.converged) << push << ": " << tried.reason;
    const double held = std::abs(pair.traction(0).y());
    EXPECT_NEAR(std::abs(pair.reaction("push")), held * area, exact * limit * area);
    if (push == 0.1 || push == 2.9 || push == -0.9)
      EXPECT_LT(held, 0.99 * limit) << push;
    else
      EXPECT_NEAR(pair.reaction("push"), (push < 0 || push == 1.0 ? -1 : 1) * limit * area,
                  exact * limit * area)
          << push;
    EXPECT_NEAR(pair.traction(0).x(), -pressure, exact * pressure) << push;
  }
}

/// On a slope: a body force at an angle to the joint, its normal part first; below the friction angle it
/// stays.
TEST_P(Contact, HoldsOnASlopeBelowTheFrictionAngle) {
  for (const double slope : {25.0, 29.5}) {
    const double radians = slope * std::acos(-1.0) / 180, weight = 0.2;
    Stepped pair(two_blocks(GetParam(), "{type: friction, friction_angle: 30}",
                            fmt::format("stages:\n  - loads: [{{type: body_force, force: [0, {:.17g}]}}]\n"
                                        "  - loads: [{{type: body_force, force: [{:.17g}, 0]}}]\n",
                                        -weight * std::cos(radians), weight * std::sin(radians))));
    const Attempt pressed = pair.to(1);
    ASSERT_TRUE(pressed.converged) << pressed.reason;
    pair.next_stage();
    // An augmentation overshoots by the change of its step, which must stay below the friction limit.
    for (int step = 1; step <= 100; ++step) {
      const Attempt tried = pair.to(0.01 * step);
      ASSERT_TRUE(tried.converged) << slope << ": " << tried.reason;
    }
    EXPECT_NEAR(pair.traction(0).x(), -weight * height * std::cos(radians), 1e-6);
    EXPECT_NEAR(std::abs(pair.traction(0).y()), weight * height * std::sin(radians), 1e-6);
    EXPECT_FALSE(pair.system().history()[0].sliding);
    // The consistent joint closes in the mean of its blocks' stresses: no more than their own deformation.
    const double allowed = GetParam() == "consistent" ? height / young : compliance_of_contact(GetParam());
    EXPECT_LT(std::abs(pair.jump(0).y()), (allowed + 1e-6 * height / young) * weight * height);
  }
}

INSTANTIATE_TEST_SUITE_P(Treatments, Contact, testing::ValuesIn(treatments_of_joints));

class ElasticJoint : public testing::TestWithParam<std::string> {};

/// Blocks and layer in series: u = σ (2 H/E + 1/K) in tension and compression, in shear the layer's own.
TEST_P(ElasticJoint, AddsItsComplianceInSeries) {
  for (const double stiffness : {5.0, 50.0, 5000.0}) {
    Stepped pair(two_blocks(GetParam(),
                            fmt::format("{{type: elastic, normal_stiffness: {}, shear_stiffness: {}}}",
                                        stiffness, 0.5 * stiffness),
                            R"(stages:
  - loads: [{type: edge_traction, boundary: head, traction: [0.3, 1]}]
gauges:
  lift: {type: relative_displacement, from: [20, 0], to: [20, 20], direction: [0, 1]}
)"));
    for (const double load : {1.0, -2.0}) {
      const Attempt tried = pair.to(load);
      ASSERT_TRUE(tried.converged) << tried.reason;
      const double compliance = 2 * height / young + 1 / stiffness + own_compliance(GetParam());
      EXPECT_NEAR(pair.gauge("lift") / (load * compliance), 1, 1e-7) << stiffness;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Treatments, ElasticJoint, testing::ValuesIn(treatments_of_joints));

/// D4: a block hung from its head is pulled down onto a fixed one by F: without contact its foot would sink
/// Δ0 = F/k, k = E A/H. With springs p and n augmentations Δ0 (k/(k + p))^(n+1) is left.
class AugmentedContact : public testing::TestWithParam<std::pair<double, int>> {
 protected:
  /// Blocks of equal height: the joint's unit of stiffness is twice the k of both in series.
  static constexpr double stiff = 1e3 * young;
  static std::string deck(double ratio) {
    return two_blocks(
        fmt::format("{{type: augmented_lagrangian, factor: {:.17g}, contact_factor: 1e12}}", 0.5 * ratio),
        "{type: friction}", R"(  head: {boundary: head, fix: y}
  side: {at: [20, 15], fix: x}
stages:
  - loads: [{type: point_load, at: [20, 10], inside: [20, 10.1], force: [0, -80]}]
)",
        stiff);
  }
  static constexpr double force = 80, sunk = force * height / (young * area);
};

TEST_P(AugmentedContact, PenetrationShrinksGeometrically) {
  const double ratio = GetParam().first;
  for (int n = 0; n < std::min(GetParam().second, 12); ++n) {
    Stepped pair(deck(ratio), {.tolerance = 1e-14, .max_iterations = n, .predicted = false});
    const Attempt tried = pair.to(1);
    EXPECT_FALSE(tried.converged);
    // The gap is given in units of the traction that the springs and multipliers now carry, over twice E/H.
    const double left = std::pow(1 / (1 + ratio), n + 1), carried = 1 - left;
    constexpr double equilibrium = 1e-10;  // what Newton's tolerance leaves of the traction
    EXPECT_NEAR(tried.gap, 2 * left / carried, 1e-4 * tried.gap + equilibrium) << n << ": " << tried.reason;
  }
}

TEST_P(AugmentedContact, NumberOfIterationsIsThatOfTheGeometricSequence) {
  Stepped pair(deck(GetParam().first), {.tolerance = 2e-8, .max_iterations = 300, .predicted = false});
  const Attempt tried = pair.to(1);
  ASSERT_TRUE(tried.converged) << tried.reason;
  EXPECT_EQ(tried.multiplier_iterations, GetParam().second);
  EXPECT_LT(std::abs(pair.jump(0).x()), 1.001e-8 * sunk);
  EXPECT_NEAR(pair.force().x(), -force / (1 + young / stiff), 1e-4 * force);
}

INSTANTIATE_TEST_SUITE_P(Ratios, AugmentedContact,
                         testing::Values(std::pair(0.1, 193), std::pair(1.0, 26), std::pair(10.0, 7),
                                         std::pair(100.0, 3)));

}  // namespace
}  // namespace dda::verification
