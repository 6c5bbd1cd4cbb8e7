// Unloading and loading again: legs of one path against closed forms, under every treatment.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/chain.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

constexpr double area = Chain::area;

struct Joint {
  std::string treatment;
  double compliance;  ///< that the treatment adds while the joint is intact or closed [mm³/N]
  double exact;       ///< what the treatment's own iteration allows
};

void PrintTo(const Joint& joint, std::ostream* out) { *out << joint.treatment; }

/// Perturbation δ of Lagrange joints, whose unit is 10 E/d.
constexpr double perturbation = 1e-7 / (10 * Chain::young / Chain::side);
const std::vector<Joint> joints{{"consistent", 0, 1e-8},
                                {"{type: penalty, stiffness: 1000}", 1e-3, 1e-8},
                                {"lagrange", perturbation, 1e-8},
                                {"augmented_lagrangian", 0, 1e-6}};

/// The bar with one joint of linear softening: pulled to an elongation, unloaded, pulled again to rupture.
class UnloadedBar : public testing::TestWithParam<Joint> {
 protected:
  static constexpr double strength = 3, energy = 0.1, critical = 2 * energy / strength;
  static constexpr double turned = 0.04, all = energy * area;
  static constexpr double body = 2 * Chain::side / Chain::young;

  static Trace follow_to(double lowest_load) {
    const Chain chain{
        .laws = {fmt::format("{{type: linear_softening, tensile_strength: {}, fracture_energy: {}}}",
                             strength, energy)},
        .treatment = GetParam().treatment,
        .stages = fmt::format(
            "  - {{name: pull, loads: [{{type: edge_traction, boundary: right, traction: [1, 0]}}], until: "
            "{{elongation: {}}}}}\n"
            "  - {{name: back, unload: true, until: {{load: {}}}}}\n"
            "  - {{name: again}}\n",
            turned, lowest_load)};
    return follow(chain.deck());
  }
  static double elastic(double stress) { return stress * (body + GetParam().compliance); }
  static double envelope(double stress) { return elastic(stress) + critical * (1 - stress / strength); }
  /// Stress of the envelope at the elongation where the load is turned.
  static double turning_stress() {
    return (critical - turned) / (critical / strength - body - GetParam().compliance);
  }
  /// Straight to the origin, and closed beyond it with the full stiffness.
  static double unloaded(double stress) {
    return stress > 0 ? turned * stress / turning_stress() : elastic(stress);
  }
  static bool is_unloading(const Traced& at) { return at.control == "unloading"; }
  static void expect_elongation(const Traced& at, double expected) {
    EXPECT_NEAR(at.gauges.at("elongation"), expected, GetParam().exact * critical) << "load " << at.load;
  }
  /// Every point of the three legs.
  static void expect_legs(const Trace& trace, double lowest_load) {
    const auto& points = trace.points;
    const auto first = std::ranges::find_if(points, is_unloading);
    ASSERT_NE(first, points.end()) << trace.ending.reason;
    const auto again = std::find_if_not(first, points.end(), is_unloading);
    for (auto at = points.begin(); at != first; ++at) expect_elongation(*at, envelope(at->load / area));
    EXPECT_NEAR((first - 1)->gauges.at("elongation"), turned, GetParam().exact * turned);
    const double spent = (first - 1)->dissipated;
    EXPECT_NEAR(spent, all * (1 - turning_stress() / strength), GetParam().exact * all);
    for (auto at = first; at != again; ++at) {
      expect_elongation(*at, unloaded(at->load / area));
      EXPECT_NEAR(at->dissipated, spent, 1e-12 * all);
    }
    EXPECT_NEAR((again - 1)->load, lowest_load, 1e-9 * strength * area);
    bool on_envelope = false, returned = false;
    for (auto at = again; at != points.end(); ++at) {
      expect_elongation(*at, on_envelope ? envelope(at->load / area) : unloaded(at->load / area));
      if (std::abs(at->gauges.at("elongation") - turned) > GetParam().exact * turned) continue;
      on_envelope = returned = true;
      EXPECT_NEAR(at->load / area, turning_stress(), GetParam().exact * strength);
      EXPECT_NEAR(at->dissipated, spent, GetParam().exact * all);
    }
    EXPECT_TRUE(returned) << "loaded again, the bar cracks on where it was left";
  }
  static void expect_rupture(const Trace& trace, double balance = GetParam().exact) {
    EXPECT_EQ(trace.ending.reason, "complete rupture");
    EXPECT_NEAR(trace.last().load, 0, GetParam().exact * strength * area);
    EXPECT_NEAR(trace.last().dissipated, all, GetParam().exact * all);
    EXPECT_NEAR(trace.last().work, all, balance * all);
    for (const Traced& at : trace.points)
      EXPECT_NEAR(at.work, at.stored + at.dissipated, balance * all) << "load " << at.load;
  }
};

TEST_P(UnloadedBar, GoesStraightToTheOriginAndBack) {
  const Trace trace = follow_to(0);
  expect_legs(trace, 0);
  expect_rupture(trace);
}

/// Multipliers of augmented Lagrangian joints jump where a joint closes; its path is not followed through
/// that.
class ClosedBar : public UnloadedBar {};

TEST_P(ClosedBar, ClosesUnderPressureWithItsFullStiffness) {
  const Trace trace = follow_to(-20000);
  expect_legs(trace, -20000);
  constexpr double promised = 1e-3;  // a step over the contact's kink measures its work along the chord
  expect_rupture(trace, promised);
}

/// A leg that stops short of zero goes back the way it came.
TEST_P(UnloadedBar, TurnsAnywhere) {
  const Trace trace = follow_to(8000);
  expect_legs(trace, 8000);
  expect_rupture(trace);
}

INSTANTIATE_TEST_SUITE_P(Treatments, UnloadedBar, testing::ValuesIn(joints));
INSTANTIATE_TEST_SUITE_P(Treatments, ClosedBar, testing::Values(joints[0], joints[1], joints[2]));

/// Two blocks pressed by N and pushed until their joint is broken in shear, back and forth again. Broken, it
/// slides at F = N tan φ A; a change of direction costs the elastic slip 2e, e that of the force F:
///
///     spent = Gf A + F (distance − 5 e),    distance = 0.03 + 0.025 + 0.055
class PressedLoop : public testing::TestWithParam<Joint> {
 protected:
  static constexpr double joint = 40 * 2, energy = 0.02;
  const double friction_ = 3 * std::tan(std::numbers::pi / 6) * joint;

  static std::string deck() {
    return pressed_blocks(
        GetParam().treatment,
        "{type: linear_softening, tensile_strength: 1, fracture_energy: 0.02, cohesion: 1.5, friction_angle: "
        "30}",
        "  - {loads: [{type: prescribed_displacement, at: [20, 15], direction: [1, 0], displacement: 0.2}], "
        "until: {slip: 0.03}}\n"
        "  - {name: back, unload: true, until: {slip: 0.005}}\n"
        "  - {name: again, until: {slip: 0.06}}\n");
  }
};

TEST_P(PressedLoop, SpendsFrictionInBothDirections) {
  const Trace trace = follow(deck());
  const double unit = trace.last().work, exact = GetParam().exact;
  ASSERT_EQ(trace.ending.kind, Ending::Kind::goal_reached) << trace.ending.reason;
  EXPECT_NEAR(trace.last().gauges.at("slip"), 0.06, exact * 0.06);
  EXPECT_NEAR(trace.last().load, friction_, exact * friction_);
  const Traced& peak = trace.points[trace.peak()];
  EXPECT_NEAR(peak.load, 1.5 * joint + friction_, exact * peak.load);
  const double elastic = peak.gauges.at("slip") * friction_ / peak.load;
  // Where sticking turns to sliding within a step, friction is measured along the chord.
  EXPECT_NEAR(trace.last().dissipated, energy * joint + friction_ * (0.11 - 5 * elastic), 5e-3 * unit);
  double lowest = 0, spent = 0;
  for (const Traced& at : trace.points) {
    lowest = std::min(lowest, at.load);
    EXPECT_GE(at.dissipated, spent - 1e-12 * unit) << "friction never gives back";
    spent = at.dissipated;
    EXPECT_NEAR(at.work, at.stored + at.dissipated, 1e-3 * unit) << "kinks within steps are chords";
  }
  EXPECT_NEAR(lowest, -friction_, exact * friction_);
}

INSTANTIATE_TEST_SUITE_P(Treatments, PressedLoop, testing::Values(joints[0], joints[1]));

}  // namespace
}  // namespace dda::verification
