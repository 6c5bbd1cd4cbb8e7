// Instantaneous release of parallel bars, and of a joint under pressure that keeps its friction.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/chain.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

constexpr double young = Chain::young;
/// Stiffness of the penalty joints [N/mm³].
constexpr double k = 1000;
const std::string springs = "{type: penalty, stiffness: 1000}";
constexpr double exact = 1e-9;

/// Three bars side by side whose ends are driven together: each lets go at its own displacement, to which the
/// drive comes back down to the opening ft/k at which the bar is released.
class SideBySide : public testing::Test {
 protected:
  struct Bar {
    double strength, length, height, foot;
  };
  static constexpr double thickness = 100, spring = 1e6, drive = 1e5 * young * thickness;
  static constexpr double unit = 0.01;  ///< displacement at load factor 1
  const std::vector<Bar> bars_{{3, 200, 100, 0}, {2, 200, 50, 200}, {2.5, 400, 80, 400}};

  static double section(const Bar& bar) { return bar.height * thickness; }
  /// Displacement of the drive per force: ground spring at the left half's centroid, a quarter of that half's
  /// strain, joint, right half, drive.
  static double compliance(const Bar& bar) {
    return 1 / spring + 1 / drive +
           (bar.length / (8 * young) + bar.length / (2 * young) + 1 / k) / section(bar);
  }
  static double limit(const Bar& bar) { return bar.strength * section(bar) * compliance(bar); }

  static std::string half(const std::string& name, double from, double to, const Bar& bar) {
    return fmt::format(
        "    - {{name: {0}, material: concrete, vertices: [[{1}, {3}], [{2}, {3}], [{2}, {4}], [{1}, "
        "{4}]]}}\n",
        name, from, to, bar.foot, bar.foot + bar.height);
  }
  std::string deck(const std::string& path) const {
    std::string regions, curves, interfaces, supports, loads;
    for (std::size_t i = 0; i < bars_.size(); ++i) {
      const Bar& bar = bars_[i];
      const double middle = bar.foot + bar.height / 2;
      regions += half(fmt::format("left{}", i), 0, bar.length / 2, bar) +
                 half(fmt::format("right{}", i), bar.length / 2, bar.length, bar);
      curves += fmt::format("    joint{0}: [[{1}, {2}], [{1}, {3}]]\n", i, bar.length / 2, bar.foot,
                            bar.foot + bar.height);
      interfaces += fmt::format(
          "  joint{}: {{points: midpoint, treatment: {}, law: {{type: mohr_coulomb, tensile_strength: {}, "
          "cohesion: 100}}}}\n",
          i, springs, bar.strength);
      supports += fmt::format("  ground{}: {{at: [{}, {}], fix: x, stiffness: {}}}\n", i, bar.length / 4,
                              middle, spring);
      for (const double share : {0.25, 0.75})
        for (const std::string fix : {"y", "rotation"})
          supports += fmt::format("  {0}{1}at{2}: {{at: [{3}, {4}], fix: {0}}}\n", fix, i, 100 * share,
                                  share * bar.length, middle);
      loads += fmt::format(
          "      - {{type: prescribed_displacement, name: end{}, at: [{}, {}], direction: [1, 0], "
          "displacement: "
          "{}}}\n",
          i, bar.length, middle, unit);
    }
    return "scene:\n  regions:\n" + regions + "  curves:\n" + curves +
           fmt::format(
               "thickness: {}\nmaterials: {{concrete: {{type: linear_elastic, young_modulus: {}, "
               "poisson_ratio: 0}}}}\ninterfaces:\n",
               thickness, young) +
           interfaces + "supports:\n" + supports + "stages:\n  - loads:\n" + loads + "path: " + path + "\n";
  }
  /// Force of all bars from the `broken`-th weakest on, the drive at `moved`.
  double force(double moved, std::size_t broken) const {
    double sum = 0;
    for (std::size_t i = broken; i < bars_.size(); ++i) sum += moved / compliance(in_order()[i]);
    return sum;
  }
  std::vector<Bar> in_order() const {
    std::vector<Bar> out = bars_;
    std::ranges::sort(out, {}, limit);
    return out;
  }
  static void expect_point(const Traced& at, double moved, double force) {
    EXPECT_NEAR(at.state.load_factor * unit, moved, exact * 0.1);
    EXPECT_NEAR(at.load, force, exact * 1e5);
    EXPECT_NEAR(at.work, at.stored + at.dissipated, exact * 1e4);
  }
};

TEST_F(SideBySide, EachBarIsReleasedAtTheOpeningOfItsStrength) {
  const Trace trace = follow(deck("{stop: {load_below: 0}}"));
  ASSERT_EQ(trace.points.size(), 6u) << trace.ending.reason;
  for (std::size_t i = 0; i < 3; ++i) {
    const Bar bar = in_order()[i];
    expect_point(trace.points[2 * i], limit(bar), force(limit(bar), i));
    expect_point(trace.points[2 * i + 1], bar.strength / k, force(bar.strength / k, i + 1));
  }
  double spent = 0;
  for (const Bar& bar : bars_) spent += 0.5 * bar.strength * bar.strength / k * section(bar);
  EXPECT_NEAR(trace.last().dissipated, spent, exact * spent);
}

/// The load factor is that of the displacement: held, the force drops, and a bar loses all that it stored.
TEST_F(SideBySide, HeldDisplacementLosesWhatTheBarStored) {
  const Trace trace = follow(deck("{control: load, stop: {load_below: 0}}"));
  ASSERT_EQ(trace.points.size(), 6u) << trace.ending.reason;
  double spent = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Bar bar = in_order()[i];
    expect_point(trace.points[2 * i], limit(bar), force(limit(bar), i));
    expect_point(trace.points[2 * i + 1], limit(bar), force(limit(bar), i + 1));
    spent += 0.5 * limit(bar) * limit(bar) / compliance(bar);
    EXPECT_NEAR(trace.points[2 * i + 1].dissipated, spent, exact * spent);
  }
}

/// Two blocks pressed together by N and pushed at the upper one's centroid: the cohesion is lost, residual
/// friction stays.
class PressedJoint : public testing::TestWithParam<std::string> {
 protected:
  static constexpr double pressure = 3, cohesion = 2, width = 40, depth = 2, push = 80;
  static double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }
  static std::string deck(const std::string& path) {
    return pressed_blocks(GetParam(),
                          "{type: mohr_coulomb, tensile_strength: 1, cohesion: 2, friction_angle: 35, "
                          "residual_friction_angle: 25}",
                          "  - {loads: [{type: point_load, at: [20, 15], force: [80, 0]}]}\n", path);
  }
  static constexpr double joint = width * depth;
  const double strength_ = (cohesion + pressure * tangent(35)) * joint / push;
  const double friction_ = pressure * tangent(25) * joint / push;
  const std::string driven_ =
      "{control: {type: displacement, gauge: pushed}, stop: {load_below: 0, gauges: {pushed: 0.2}}}";

  void expect_both_states(const Trace& trace) const {
    ASSERT_GE(trace.points.size(), 2u) << trace.ending.reason;
    EXPECT_NEAR(trace.points[0].state.load_factor, strength_, exact * strength_);
    EXPECT_NEAR(trace.points[1].state.load_factor, friction_, exact * strength_);
    for (const Traced& at : trace.points)
      EXPECT_NEAR(at.work, at.stored + at.dissipated, exact * trace.points[0].work);
  }
};

TEST_P(PressedJoint, LosesItsCohesionAndKeepsFriction) {
  const Trace trace = follow(deck("{stop: {load_below: 0}}"));
  expect_both_states(trace);
  if (GetParam() == springs) {
    const double held = strength_ * push / joint / k;
    EXPECT_NEAR(trace.points[0].gauges.at("slip"), held, exact * held);
    EXPECT_NEAR(trace.points[1].gauges.at("slip"), held, exact * held);
  }
}

TEST_P(PressedJoint, DisplacementControlHoldsThePush) {
  const Trace trace = follow(deck(driven_));
  expect_both_states(trace);
  EXPECT_NEAR(trace.points[1].gauges.at("pushed") / trace.points[0].gauges.at("pushed"), 1, exact);
}

/// Residual friction holds the load while the push goes on.
TEST_P(PressedJoint, DisplacementControlSlidesOn) {
  const Trace trace = follow(deck(driven_));
  EXPECT_EQ(trace.ending.kind, Ending::Kind::goal_reached) << trace.ending.reason;
  ASSERT_GE(trace.points.size(), 3u);
  EXPECT_NEAR(trace.last().gauges.at("pushed"), 0.2, exact);
  EXPECT_NEAR(trace.last().state.load_factor, friction_, exact * strength_);
  const double slid = trace.last().gauges.at("pushed") - trace.points[1].gauges.at("pushed");
  EXPECT_NEAR(trace.last().dissipated - trace.points[1].dissipated, friction_ * push * slid,
              exact * trace.last().work);
}

INSTANTIATE_TEST_SUITE_P(Treatments, PressedJoint, testing::Values(springs, "consistent"));

}  // namespace
}  // namespace dda::verification
