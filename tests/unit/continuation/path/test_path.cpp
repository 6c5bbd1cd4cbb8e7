#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "continuation/detour/sequentially_linear.hpp"
#include "support/law_case.hpp"
#include "unit/continuation/on_path.hpp"

namespace dda {
namespace {

class PathOfTheBar : public testing::TestWithParam<double> {};

TEST_P(PathOfTheBar, IsTheClosedForm) {
  const double length = GetParam(), wc = 0.2 / 3;
  Bar bar(length, "stop: {load_below: 0}");
  double peak = 0;
  for ([[maybe_unused]] const Point& point : bar.path()) {
    peak = std::max(peak, bar.stress());
    const double w = bar.walker().here().dissipated > 0 ? wc * (1 - bar.stress() / 3) : 0;
    EXPECT_NEAR(bar.elongation(), bar.stress() * length / 30000 + w, 1e-8 * wc);
  }
  EXPECT_EQ(bar.path().ending().kind, Ending::Kind::goal_reached);
  EXPECT_EQ(bar.path().ending().reason, "complete rupture");
  EXPECT_NEAR(peak, 3, 3e-8);
  EXPECT_NEAR(bar.walker().here().dissipated, 1000, 1e-5) << "Gf A";
  EXPECT_NEAR(bar.walker().here().work, 1000, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Lengths, PathOfTheBar, testing::Values(100.0, 1000.0 / 3, 1000.0, 2000.0));

TEST(Path, LandsOnWantedGaugeValues) {
  const std::vector<double> values{0.005, 0.02, 0.05};
  Bar bar(100, "stop: {load_below: 0.02}", values);
  std::size_t landed = 0;
  for (const Point& point : bar.path()) {
    if (point.landed.empty() || landed >= values.size()) continue;
    EXPECT_NEAR(bar.elongation(), values[landed], 1e-7 * values[landed]);
    ++landed;
  }
  EXPECT_EQ(landed, values.size());
}

TEST(Path, EndsOnItsRules) {
  Bar below(100, "stop: {load_below: 0.4}");
  for ([[maybe_unused]] const Point& point : below.path()) {
  }
  EXPECT_EQ(below.path().ending().kind, Ending::Kind::goal_reached);
  EXPECT_NEAR(below.stress(), 1.2, 1e-6);
  Bar counted(100, "stop: {steps: 3}");
  int steps = 0;
  for (const Point& point : counted.path()) EXPECT_EQ(point.step, ++steps);
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(counted.path().ending().kind, Ending::Kind::stopped_early) << "a limit is no goal";
  EXPECT_THAT(counted.path().ending().reason, testing::HasSubstr("limit of 3 steps"));
  Bar wanted(100, "stop: {after_steps: 3}");
  for (const Point& point : wanted.path()) EXPECT_LE(point.step, 3);
  EXPECT_EQ(wanted.path().ending().kind, Ending::Kind::goal_reached);
  EXPECT_EQ(wanted.path().ending().reason, "3 steps");
}

TEST(Path, ControlsThatCannotFollowSaySo) {
  Bar load(1000, "control: load");
  for ([[maybe_unused]] const Point& point : load.path()) {
  }
  EXPECT_EQ(load.path().ending().kind, Ending::Kind::stopped_early);
  EXPECT_THAT(load.path().ending().reason, testing::HasSubstr("limit point"));
  EXPECT_NEAR(load.stress(), 3, 1e-6);
  Bar opening(1000, "control: {type: opening, gauge: u}");
  for ([[maybe_unused]] const Point& point : opening.path()) {
  }
  EXPECT_EQ(opening.path().ending().kind, Ending::Kind::stopped_early);
  EXPECT_THAT(opening.path().ending().reason, testing::HasSubstr("snaps back"));
}

/// Of a crack that is rigid until it begins rounding is all there is, whose sign, other at each length, says nothing of the
/// way on.
TEST(Path, OpeningOfARigidJointIsFollowed) {
  for (const int length : {60, 80, 90, 100, 110, 120, 130}) {
    const auto at = [&](double share, int y) { return fmt::format("[{}, {}]", share * length, y); };
    std::string deck = bar_deck(length);
    deck.erase(deck.find("gauges:"));
    deck += fmt::format(
        "gauges: {{u: {{type: relative_displacement, from: {0}, from_inside: {1}, to: {0}, to_inside: {2}, "
        "direction: [1, 0]}}}}\n",
        at(0.5, 30), at(0.25, 50), at(0.75, 50));
    OnPath bar(deck, "{control: {type: opening, gauge: u}, stop: {load_below: 0.1}}");
    while (bar.path().next()) {
    }
    EXPECT_EQ(bar.path().ending().kind, Ending::Kind::goal_reached) << length << bar.path().ending().reason;
    EXPECT_NEAR(bar.value(), 0.9 * 0.2 / 3, 1e-6) << "w of 0.3 MPa";
  }
}

/// As if a jump had led here from the peak of a load that acts the other way and is twice as large.
void turn_load_round(Path& path) {
  PathMemory memory = path.memory();
  memory.direction *= -1;
  memory.peak_load *= 2;
  memory.leg_peak = memory.peak_load;
  path.restore(memory);
}

/// A jump may lead past the share of the peak at which the path ends, to a load that acts the other way.
TEST(Path, SaysWhereTheLoadHasTurnedRound) {
  Bar bar(100, "stop: {load_below: 0.3}");
  ASSERT_TRUE(bar.path().next());
  ASSERT_NEAR(bar.stress(), 3, 1e-6);
  turn_load_round(bar.path());
  EXPECT_FALSE(bar.path().next());
  EXPECT_EQ(bar.path().ending().reason, "load below 30 % of its peak, turned round to -50 %");
}

TEST(Path, LoadThatHasTurnedRoundIsNoRupture) {
  OnPath bar(endless_bar_deck(),
             "{step: {accuracy: 1.0e-30}, control: dissipation, stop: "
             "{load_below: 0}}");  // steps shrink to nothing
  ASSERT_TRUE(bar.path().next());
  turn_load_round(bar.path());
  while (bar.path().next()) {
  }
  EXPECT_EQ(bar.path().ending().kind, Ending::Kind::stopped_early) << bar.path().ending().reason;
}

TEST(Path, CanBeInterrupted) {
  Bar bar(100, "stop: {load_below: 0.02}");
  int steps = 0;
  bar.path().interrupt_when([&] { return steps == 3; });
  for ([[maybe_unused]] const Point& point : bar.path()) ++steps;
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(bar.path().ending().kind, Ending::Kind::interrupted);
}

/// Load factor, dissipated energy, and every number that the path remembers.
std::vector<double> numbers_of(const Bar& bar, const PathMemory& memory) {
  std::vector<double> out{bar.walker().state().load_factor, bar.walker().here().dissipated,
                          static_cast<double>(bar.walker().effort().rejected)};
  const auto note = [&](const char*, const auto& value) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>)
      out.push_back(static_cast<double>(value));
    else
      out.insert(out.end(), value.begin(), value.end());
  };
  PathMemory::visit(memory, note);
  return out;
}

/// Whatever solve of a step it is at which somebody loses patience.
TEST(Path, LeavesNoTraceOfAStepThatIsBrokenOff) {
  const std::string rules = "step: {largest: 0.5}\nstop: {load_below: 0.02}";
  Bar whole(2000, rules);
  std::vector<std::vector<double>> expected{numbers_of(whole, whole.path().memory())};
  for ([[maybe_unused]] const Point& point : whole.path())
    expected.push_back(numbers_of(whole, whole.path().memory()));
  std::size_t within = 0;
  for (int patience = 1;; ++patience) {
    Bar bar(2000, rules);
    int asked = 0, asked_between = 0;
    std::size_t steps = 0;
    bar.path().interrupt_when([&] { return ++asked > patience; });
    while (bar.path().next()) {
      ++steps;
      asked_between = asked;
    }
    if (bar.path().ending().kind != Ending::Kind::interrupted) break;
    within += asked > asked_between + 1;
    EXPECT_EQ(numbers_of(bar, bar.path().memory()), expected[steps]) << "asked " << patience << " times";
  }
  EXPECT_GT(within, 4u) << "within a step";
}

/// From the first crack of the bar and of the square: the result is an equilibrium on the damage surface.
TEST(SequentiallyLinear, EndsInAnEquilibriumThatHasDissipatedTheQuantum) {
  Bar bar(1000, "stop: {steps: 2}");
  for ([[maybe_unused]] const Point& point : bar.path()) {
  }
  System& system = bar.system();
  const std::vector<History> before = system.history();
  const double start = system.dissipated(before), quantum = 30;
  const auto found = sequentially_linear(system, bar.walker().state(), quantum);
  ASSERT_TRUE(found);
  EXPECT_GE(system.dissipated(found->history), start + quantum);
  EXPECT_EQ(system.dissipated(system.history()), start) << "the system itself has not moved";
  system.set_history(found->history);
  const LawValues laws = system.laws(found->state);
  std::vector<double> residual(found->state.d.size());
  system.residual(found->state.d, found->state.load_factor, laws, residual);
  EXPECT_LT(system.residual_norm(residual), 1e-8 * system.force_level(found->state.d));
  // On the envelope: w = κ − σ/k and σ = ft (1 − w/w_c).
  const double k = system.equilibrium().point(0).stiffness, wc = 0.2 / 3;
  const double w = system.kappa(0) - found->state.load_factor / k;
  EXPECT_NEAR(found->state.load_factor, 3 * (1 - w / wc), 1e-8);
}

/// A beam in four-point bending with friction, all of whose joints can crack.
constexpr auto rough_beam = R"(
scene:
  regions: [{material: concrete, vertices: [[0, 0], [1600, 0], [1600, 400], [0, 400]]}]
  subdivision: {type: triangles, size: 103.28}
  slits: {notch: [[800, 0], [800, 66.67]]}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 40000, poisson_ratio: 0.2}}
interfaces:
  any:
    between: [concrete, concrete]
    law: {type: linear_softening, tensile_strength: 3, fracture_energy: 0.18, cohesion: 9, friction_angle: 37}
supports: {left: {at: [0, 0], fix: xy}, right: {at: [1600, 0], fix: y}}
stages:
  - loads: [{type: point_load, at: [533, 400], force: [0, -1]}, {type: point_load, at: [1067, 400], force: [0, -1]}]
gauges: {deflection: {type: displacement, at: [800, 400], inside: [799, 399], direction: [0, -1]}}
)";

/// Where Newton's method begins changes how many iterations it takes, not where it ends.
TEST(Predictor, EachLeadsToTheSamePointsInItsOwnNumberOfIterations) {
  std::map<std::string, std::vector<int>> iterations;  // until each point
  std::vector<double> known;
  for (const std::string predictor : {"tangent", "secant", "constant"}) {
    OnPath beam(rough_beam,
                "{step: {sizing: constant, predictor: " + predictor + "}, stop: {after_steps: 60}}");
    std::vector<double> loads;
    for ([[maybe_unused]] const Point& point : beam.path()) {
      loads.push_back(beam.walker().here().load);
      const Effort& effort = beam.walker().effort();
      iterations[predictor].push_back(effort.newton_iterations + effort.reduced_iterations);
    }
    ASSERT_EQ(loads.size(), 60u) << predictor;
    if (known.empty()) known = loads;
    for (std::size_t i = 0; i < loads.size(); ++i)
      EXPECT_NEAR(loads[i], known[i], 1e-6 * known[i]) << predictor;
  }
  EXPECT_NE(iterations["secant"], iterations["tangent"]);
  EXPECT_LT(iterations["secant"].back(), iterations["constant"].back());
}

/// Points that have slid and stick again bear more than their stiffness times q.
TEST(SequentiallyLinear, KeepsWhatHasSlid) {
  OnPath beam(rough_beam, "stop: {load_below: 0.2}");
  for ([[maybe_unused]] const Point& point : beam.path()) {
  }
  System& system = beam.system();
  const State start = beam.walker().state();
  const auto slid = [&] {
    return std::ranges::count_if(system.history(), [&](const History& h) {
      return remembered_number(*system.equilibrium().point(0).law, h, "slip") != 0;
    });
  };
  ASSERT_GT(slid(), 0);
  const double dissipated = system.dissipated(system.history());
  const auto found = sequentially_linear(system, start, 1e-3 * dissipated);
  ASSERT_TRUE(found);
  EXPECT_GE(system.dissipated(found->history), 1.001 * dissipated);
  system.set_history(found->history);
  const LawValues laws = system.laws(found->state);
  std::vector<double> residual(found->state.d.size());
  system.residual(found->state.d, found->state.load_factor, laws, residual);
  EXPECT_LT(system.residual_norm(residual), 1e-9 * system.force_level(found->state.d));
  const auto again = system.next_history(found->state);
  EXPECT_NEAR(system.dissipated(again), system.dissipated(found->history), 1e-9 * dissipated)
      << "nothing is left to be spent";
}

/// A brittle notched beam of stiff joints, all of which can crack: blocks between open joints hang loosely.
constexpr auto brittle_beam = R"(
scene:
  regions: [{material: concrete, vertices: [[-170, 0], [170, 0], [170, 100], [-170, 100]]}]
  subdivision: {type: quads, size: 15}
  slits: {notch: [[0, 0], [0, 16.67]]}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0.2}}
interfaces:
  any:
    between: [concrete, concrete]
    law: {type: exponential_softening, tensile_strength: 3, fracture_energy: 0.002}
    treatment: {type: penalty, factor: 100}
supports: {left: {at: [-150, 0], fix: xy}, right: {at: [150, 0], fix: y}}
stages: [{loads: [{type: point_load, at: [0, 100], force: [0, -1]}]}]
gauges: {deflection: {type: displacement, at: [0, 100], direction: [0, -1]}}
)";

TEST(Path, DoesNotLandWhereItIs) {
  OnPath beam(brittle_beam, "stop: {load_below: 0.1}");
  double quantum = 0, dissipated = 0;
  int landings = 0;
  for (const Point& point : beam.path()) {
    const double gain = beam.walker().here().dissipated - dissipated;
    if (point.kind == StepKind::initiation || point.kind == StepKind::corner) {
      ++landings;
      EXPECT_GT(gain, 1e-6 * quantum) << "step " << point.step;
    }
    quantum = gain;
    dissipated += gain;
  }
  EXPECT_EQ(beam.path().ending().kind, Ending::Kind::goal_reached) << beam.path().ending().reason;
  EXPECT_GT(landings, 0);
}

TEST(SequentiallyLinear, EndsOnTheSurfaceWhereBlocksHangLoosely) {
  OnPath beam(brittle_beam, "stop: {load_below: 0.2}");
  for ([[maybe_unused]] const Point& point : beam.path()) {
  }
  System& system = beam.system();
  const double dissipated = system.dissipated(system.history());
  const auto found = sequentially_linear(system, beam.walker().state(), 1e-3 * dissipated);
  ASSERT_TRUE(found);
  system.set_history(found->history);
  EXPECT_LT(system.excess_residual(found->state), 1e-9);
  const LawValues laws = system.laws(found->state);
  double nearest = 0;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (system.is_broken(p)) continue;
    const History& h = system.history()[p];
    const double opening = point.law->equivalent_opening(laws.opening[p], h, point.stiffness);
    nearest = std::max(nearest, opening / system.kappa(p));
  }
  EXPECT_NEAR(nearest, 1, 1e-12) << "the law tells loading from unloading by 1e-11";
}

/// A cantilever of squares all of whose joints can crack, driven at its tip.
std::string cantilever(const std::string& joint) {
  return R"(
scene:
  regions: [{material: concrete, vertices: [[0, 0], [200, 0], [200, 50], [0, 50]]}]
  boundaries: {wall: [[0, 50], [0, 0]]}
  subdivision: {type: quads, size: 12.90995}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 40000, poisson_ratio: 0.35}}
interfaces:
  any:
    between: [concrete, concrete]
    law: {type: linear_softening, tensile_strength: 1.5, fracture_energy: 0.028}
)" + joint +
         R"(
supports: {clamp: {boundary: wall, fix: xy}}
stages: [{loads: [{type: prescribed_displacement, at: [200, 50], direction: [0, -1], displacement: 1}]}]
gauges: {tip: {type: displacement, at: [200, 50], direction: [0, -1]}}
)";
}

/// The secant walk uses the joints' own high stiffness; what it finds must hold with their multipliers.
TEST(SequentiallyLinear, ClosesTheGapsOfIteratedMultipliers) {
  OnPath beam(cantilever("    treatment: augmented_lagrangian\n    points: midpoint"),
              "stop: {load_below: 0.5}");
  for ([[maybe_unused]] const Point& point : beam.path()) {
  }
  System& system = beam.system();
  const State start = beam.walker().state();
  const double dissipated = system.dissipated(system.history());
  const auto found = sequentially_linear(system, start, 1e-3 * dissipated);
  ASSERT_TRUE(found);
  EXPECT_GE(system.dissipated(found->history), 1.001 * dissipated);
  EXPECT_EQ(system.multipliers(), start.multipliers) << "the system itself has not moved";
  system.set_history(found->history);
  system.set_multipliers(found->state.multipliers);
  EXPECT_LT(system.excess_residual(found->state), 1e-9);
  const LawValues laws = system.laws(found->state);
  EXPECT_LT(system.relative_gap(laws), 1e-8);
}

/// Squares that may not open anywhere lock: what a first crack spends is so little that the rounding of its
/// opening is 1e-7 of it.
TEST(Path, DoesNotStopWhereRoundingHidesTheEnergySpent) {
  OnPath beam(cantilever("    treatment: lagrange"), "stop: {after_steps: 20}");
  for ([[maybe_unused]] const Point& point : beam.path()) {
  }
  EXPECT_EQ(beam.path().ending().kind, Ending::Kind::goal_reached) << beam.path().ending().reason;
}

}  // namespace
}  // namespace dda
