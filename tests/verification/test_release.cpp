// Instantaneous release: an elastic-brittle assembly has a piecewise linear path, every vertex of it exact.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "verification/chain.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

constexpr double area = Chain::area, young = Chain::young, side = Chain::side;
/// Stiffness of the penalty joints [N/mm³].
constexpr double k = 1000;
const std::string springs = "{type: penalty, stiffness: 1000}";
constexpr double exact = 1e-9;
/// Of a load increment before it is given up, and the share of the load at which that is.
constexpr double halvings = 14, smallest_share = 1e-4;

std::string brittle(double strength) {
  return fmt::format("{{type: mohr_coulomb, tensile_strength: {}, cohesion: 100}}", strength);
}

/// What an accepted point must be: every number by hand.
struct Vertex {
  double load_factor, displacement, dissipated;
};

/// Compares a path point by point; `gauge` is the displacement of the vertices.
void expect_vertices(const Trace& trace, const std::string& gauge, const std::vector<Vertex>& expected,
                     double tolerance = exact) {
  ASSERT_EQ(trace.points.size(), expected.size()) << trace.ending.reason;
  double force = 0, moved = 0, work = 0;
  for (const Vertex& at : expected) {
    force = std::max(force, std::abs(at.load_factor));
    moved = std::max(moved, std::abs(at.displacement));
  }
  for (const Traced& at : trace.points) work = std::max(work, std::abs(at.work));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Traced& at = trace.points[i];
    EXPECT_NEAR(at.state.load_factor, expected[i].load_factor, tolerance * force) << "vertex " << i;
    EXPECT_NEAR(at.gauges.at(gauge), expected[i].displacement, tolerance * moved) << "vertex " << i;
    EXPECT_NEAR(at.dissipated, expected[i].dissipated, tolerance * work) << "vertex " << i;
    EXPECT_NEAR(at.work, at.stored + at.dissipated, tolerance * work) << "vertex " << i;
  }
}

/// The joint of one bar: compliance while intact, opening and energy per area left by the release.
struct Joint {
  std::string treatment;
  double compliance, opening, spent;
  double tolerance = exact;
};

void PrintTo(const Joint& joint, std::ostream* out) { *out << joint.treatment; }

class BrittleBar : public testing::TestWithParam<Joint> {
 protected:
  static constexpr double strength = 3;
  static Chain chain(const std::string& path = "{stop: {load_below: 0}}") {
    return {.laws = {brittle(strength)}, .treatment = GetParam().treatment, .path = path};
  }
  static std::vector<Vertex> vertices() {
    const double peak = strength * (2 * side / young + GetParam().compliance);
    return {{strength, peak, 0}, {0, GetParam().opening, GetParam().spent * area}};
  }
};

/// Up to the strength, then straight back to no load while the joint's trial opening q = ft/k is held.
TEST_P(BrittleBar, IsReleasedAtTheOpeningOfItsStrength) {
  expect_vertices(follow(chain().deck()), "elongation", vertices(), GetParam().tolerance);
}

TEST_P(BrittleBar, StepSizesDoNotMatter) {
  for (const std::string step : {"{accuracy: 0.5, largest: 1}", "{accuracy: 0.0001, largest: 0.001}"})
    expect_vertices(follow(chain("{step: " + step + ", stop: {load_below: 0}}").deck()), "elongation",
                    vertices(), GetParam().tolerance);
}

TEST_P(BrittleBar, LoadControlHoldsTheLoadAndFails) {
  const Trace trace = follow(chain("{control: load}").deck());
  ASSERT_EQ(trace.points.size(), 1u);
  EXPECT_NEAR(trace.last().state.load_factor, strength, exact * strength);
  EXPECT_EQ(trace.ending.kind, Ending::Kind::stopped_early);
  EXPECT_THAT(trace.ending.reason, testing::StartsWith("failure"));
}

/// Everything stored is lost at once.
TEST_P(BrittleBar, DisplacementControlHoldsTheDisplacement) {
  const Trace trace =
      follow(chain("{control: {type: displacement, gauge: tip}, stop: {load_below: 0}}").deck());
  ASSERT_EQ(trace.points.size(), 2u) << trace.ending.reason;
  const Traced &peak = trace.points[0], &last = trace.last();
  EXPECT_NEAR(last.gauges.at("tip") / peak.gauges.at("tip"), 1, exact);
  EXPECT_NEAR(last.state.load_factor, 0, exact * strength);
  EXPECT_NEAR(last.work / peak.work, 1, exact);
  EXPECT_NEAR(last.stored / peak.stored, 0, GetParam().tolerance);
  EXPECT_NEAR(last.dissipated / peak.work, 1, GetParam().tolerance);
}

TEST_P(BrittleBar, LoadIncrementsStopJustBelowTheStrength) {
  for (const double increment : {0.07, 0.3}) {
    const Trace trace =
        follow(chain(fmt::format("{{control: {{type: load_increments, increment: {}}}}}", increment)).deck());
    ASSERT_FALSE(trace.points.empty()) << trace.ending.reason;
    EXPECT_LE(static_cast<double>(trace.points.size()), 1 / increment + halvings) << "no halving without end";
    EXPECT_THAT(trace.ending.reason, testing::StartsWith("failure"));
    double before = 0;
    for (const Traced& at : trace.points) {
      EXPECT_GT(at.state.load_factor, before);
      before = at.state.load_factor;
    }
    EXPECT_LE(before, strength * (1 + exact));
    EXPECT_GE(before, strength * (1 - 2 * smallest_share));
  }
}

/// Trial stiffness of the consistent joint α 2E/a.
std::vector<Joint> joints() {
  constexpr double strength = 3, consistent = 0.6 * 2 * young / side;
  const auto spring = [](double stiffness) { return 0.5 * strength * strength / stiffness; };
  return {{springs, 1 / k, strength / k, spring(k)},
          {"consistent", 0, strength / consistent, spring(consistent)}};
}

INSTANTIATE_TEST_SUITE_P(Treatments, BrittleBar, testing::ValuesIn(joints()));

/// Three joints in a row: the weakest breaks, the others unload.
TEST(BrittleChain, InSeriesTheWeakestBreaksAndTheOthersUnload) {
  constexpr double weakest = 3;
  const Chain chain{.laws = {brittle(3.5), brittle(weakest), brittle(4)}, .treatment = springs};
  const Trace trace = follow(chain.deck());
  expect_vertices(trace, "elongation",
                  {{weakest, weakest * (4 * side / young + 3 / k), 0},
                   {0, weakest / k, 0.5 * weakest * weakest / k * area}});
  EXPECT_NEAR(trace.last().gauges.at("x1"), 0, exact) << "left of the crack";
  EXPECT_NEAR(trace.last().gauges.at("x2"), weakest / k, exact) << "right of it";
}

/// Block A is held by a spring at its centroid, and through joint 0 by block W on a spring of its own; the
/// load pulls at joint 1, beyond A. With σ0, σ1 in the joints, a the area, b = L/4E and s the springs:
///
///     q0 = (σ1 − σ0) a/s − (σ0 + σ1) b − σ0 a/s − σ0 b
class Redundant : public testing::Test {
 protected:
  static constexpr double weak = 1, strong = 3, per_spring = area / 1e6, b = side / (4 * young);
  static Chain chain(const std::string& path) {
    return {.laws = {brittle(weak), brittle(strong)},
            .treatment = springs,
            .held_left = false,
            .springs = {{0, 1e6}, {1, 1e6}},
            .path = path};
  }
  /// σ1 when joint 0 carries σ0 at the opening of its strength.
  static double load(double first) {
    return (weak / k + first * (2 * per_spring + 2 * b)) / (per_spring - b);
  }
  static double at_centroid(double first, double second) { return (second - first) * per_spring; }
  static constexpr double spring(double strength) { return 0.5 * strength * strength / k * area; }
};

TEST_F(Redundant, LoadFallsAndRisesAgain) {
  const double spent = spring(weak);
  const std::vector<Vertex> expected{{load(weak), at_centroid(weak, load(weak)), 0},
                                     {load(0), at_centroid(0, load(0)), spent},
                                     {strong, at_centroid(0, strong), spent},
                                     {0, 0, spent + spring(strong)}};
  expect_vertices(follow(chain("{stop: {load_below: 0}}").deck()), "x1", expected);
  expect_vertices(follow(chain("{step: {accuracy: 0.001, largest: 0.01}, stop: {load_below: 0}}").deck()),
                  "x1", expected);
}

/// The load stays while joint 0 opens from q to what A alone allows: ½ ft of it is lost, and the spring's.
TEST_F(Redundant, LoadControlGoesOnUntilTheLastJointFails) {
  const double held = load(weak), opened = held * (per_spring - b);
  const double spent = 0.5 * weak * opened * area;
  const Trace trace = follow(chain("{control: load}").deck());
  expect_vertices(trace, "x1",
                  {{held, at_centroid(weak, held), 0},
                   {held, at_centroid(0, held), spent},
                   {strong, at_centroid(0, strong), spent}});
  EXPECT_THAT(trace.ending.reason, testing::StartsWith("failure"));
}

TEST_F(Redundant, LoadIncrementsPassTheFirstReleaseAndStopBelowFailure) {
  const Trace trace = follow(chain("{control: {type: load_increments, increment: 0.07}}").deck());
  ASSERT_FALSE(trace.points.empty()) << trace.ending.reason;
  EXPECT_THAT(trace.ending.reason, testing::StartsWith("failure"));
  const double reached = trace.last().state.load_factor;
  EXPECT_LE(reached, strong * (1 + exact));
  EXPECT_GE(reached, strong * (1 - 2 * smallest_share));
  for (const Traced& at : trace.points) {
    const bool intact = at.state.load_factor < load(weak) * (1 - exact);
    const double first =
        intact ? at.state.load_factor * (per_spring - b) / (2 * per_spring + 2 * b + 1 / k) : 0;
    EXPECT_NEAR(at.gauges.at("x1"), at_centroid(first, at.state.load_factor), exact * strong * per_spring)
        << at.state.load_factor;
  }
}

/// Block B on a soft spring is pulled by a dead load D, away from A and W: both joints are in tension.
/// Pulling A towards B loads joint 0 and relieves joint 1, so the release of joint 0, which takes the load
/// back, brings joint 1 to its strength; from there both are lost together. With w, v = area/spring of W and
/// B, b = L/4E:
///
///     σ0 = σ1 + λ,   q1 = D/spring − σ1 (v + 3b) − q0 − σ0 (w + 3b)
class Nested : public testing::Test {
 protected:
  static constexpr double first = 3, second = 1.8, far = 20000 / 1e5;  // far: D over the spring of B
  static constexpr double w = area / 1e6, v = area / 1e5, b = side / (4 * young);
  static std::string deck(const std::string& step) {
    const Chain chain{.laws = {brittle(first), brittle(second)},
                      .treatment = springs,
                      .held_left = false,
                      .springs = {{0, 1e6}, {2, 1e5}},
                      .stages =
                          "  - {loads: [{type: point_load, at: [250, 50], force: [20000, 0]}]}\n"
                          "  - {loads: [{type: point_load, at: [150, 50], force: [10000, 0]}]}\n",
                      .path = "{step: " + step + ", stop: {load_below: 0}}"};
    return chain.deck();
  }
  /// Displacement of B's centroid under σ1 in its joint.
  static double end(double stress) { return far - stress * v; }
};

TEST_F(Nested, AnotherPointReachesItsStrengthDuringARelease) {
  const double relieved = (far - first * (1 / k + w + 3 * b)) / (1 / k + v + 3 * b);
  const double left = (far - first / k - second * (1 / k + v + 3 * b)) / (w + 3 * b);
  ASSERT_TRUE(left > 0 && left < first && relieved < second) << "or nothing would be nested";
  const double spent = 0.5 * (first * first - left * left) / k * area;
  const double opened = far - second / k;  // of joint 0 in the end: A hangs from B alone
  const double rest = 0.5 * (left * (opened - first / k + left / k) + second * second / k) * area;
  for (const std::string step : {"{}", "{accuracy: 0.001, largest: 0.01}"})
    expect_vertices(
        follow(deck(step)), "x2",
        {{first - relieved, end(relieved), 0}, {left - second, end(second), spent}, {0, far, spent + rest}});
  EXPECT_NEAR(follow(deck("{}")).last().gauges.at("x1"), opened, exact * opened);
}

}  // namespace
}  // namespace dda::verification
