// However a path ends, what its reason says is true of the last row, and it does not go on from there.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "studies/dda/case/simulation.hpp"
#include "verification/chain.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

using testing::StartsWith;

/// A deck on its path, and the same after a restart.
class Followed {
 public:
  explicit Followed(const std::string& deck) : file_(deck_from_text(deck, "ends.yaml", {})) {
    simulation_.prepare();
    if (const std::string why = simulation_.apply_dead_loads(); !why.empty()) throw std::runtime_error(why);
    simulation_.walker().effort().count_steps_anew();
    simulation_.begin_path();
  }

  /// To the end; the accepted steps.
  int follow() {
    int steps = 0;
    for ([[maybe_unused]] const Point& point : simulation_.path()) ++steps;
    return steps;
  }
  /// Forgets that the path has ended.
  void restart() {
    const PathMemory memory = simulation_.path().memory();
    simulation_.begin_path();
    simulation_.path().restore(memory);
  }
  const Ending& ending() { return simulation_.path().ending(); }
  double gauge(const std::string& name) {
    for (const NamedGauge& gauge : simulation_.gauges().gauges)
      if (gauge.name == name) return simulation_.walker().value(gauge.functional);
    return std::nan("");
  }
  Simulation& simulation() { return simulation_; }

 private:
  DeckFile file_;
  Timings timings_;
  Simulation simulation_{file_.deck, timings_};
};

std::string softening(const std::string& path) {
  return Chain{.laws = {"{type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}"},
               .treatment = "consistent",
               .path = path}
      .deck();
}
std::string brittle(const std::string& path) {
  return Chain{.laws = {"{type: mohr_coulomb, tensile_strength: 3, cohesion: 100}"}, .path = path}.deck();
}

/// One way in which a path ends: what its reason begins with, and what is true of its last row.
struct Way {
  std::string name, deck, reason;
  std::function<bool(Followed&)> is_true;
};
void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

class PathEnds : public testing::TestWithParam<Way> {};

TEST_P(PathEnds, WhereTheReasonIsTrue) {
  Followed run(GetParam().deck);
  EXPECT_GT(run.follow(), 0);
  EXPECT_EQ(run.ending().kind, Ending::Kind::goal_reached) << run.ending().reason;
  EXPECT_THAT(run.ending().reason, StartsWith(GetParam().reason));
  EXPECT_TRUE(GetParam().is_true(run)) << run.ending().reason;
}

/// A kill between the last restart file and the summary: the goal must be seen before the first step.
TEST_P(PathEnds, ForGoodAlsoAfterARestart) {
  Followed run(GetParam().deck);
  run.follow();
  const std::string reason = run.ending().reason;
  const int accepted = run.simulation().walker().effort().accepted;
  run.restart();
  EXPECT_EQ(run.follow(), 0) << "walks on past its goal";
  EXPECT_EQ(run.ending().kind, Ending::Kind::goal_reached);
  EXPECT_EQ(run.ending().reason, reason);
  EXPECT_EQ(run.simulation().walker().effort().accepted, accepted);
}

std::vector<Way> ways() {
  const auto stands_at = [](const std::string& gauge, double value) {
    return [=](Followed& run) { return std::abs(run.gauge(gauge) / value - 1) <= 1.001e-7; };
  };
  const auto has_come_to = [](const std::string& gauge, double value) {
    return [=](Followed& run) { return run.gauge(gauge) >= value * (1 - 1.001e-7); };
  };
  const auto load_at_most = [](double value) {
    return [=](Followed& run) { return run.simulation().walker().here().state.load_factor <= value; };
  };
  return {
      {"landing", softening("{stop: {load_below: 0, gauges: {elongation: 0.04}}}"), "elongation reached 0.04",
       stands_at("elongation", 0.04)},
      {"elastic", softening("{stop: {load_below: 0, gauges: {elongation: 0.01}}}"), "elongation reached 0.01",
       stands_at("elongation", 0.01)},
      {"load_below", softening("{stop: {load_below: 0.4}}"), "load below 40 %",
       load_at_most(1.2 * (1 + 1e-6))},
      {"rupture", softening("{stop: {load_below: 0}}"), "complete rupture", load_at_most(3e-6)},
      {"release", brittle("{stop: {load_below: 0}}"), "complete rupture", load_at_most(3e-6)},
      {"release to a gauge", brittle("{stop: {load_below: 0, gauges: {x1: 0.0125}}}"), "x1 reached 0.0125",
       has_come_to("x1", 0.0125)},
      {"sequentially linear",
       softening("{control: event, stop: {load_below: 0, gauges: {elongation: 0.04}}}"),
       "elongation reached 0.04", has_come_to("elongation", 0.04)},
      {"sequentially linear to a load", softening("{control: event, stop: {load_below: 0.4}}"),
       "load below 40 %", load_at_most(1.2 * (1 + 1e-6))},
      {"load increments",
       brittle("{control: {type: load_increments, increment: 0.3}, stop: {gauges: {x1: "
               "0.004}}}"),
       "x1 reached 0.004", has_come_to("x1", 0.004)},
      {"displacement", softening("{control: {type: displacement, gauge: tip}, stop: {gauges: {tip: 0.03}}}"),
       "tip reached 0.03", stands_at("tip", 0.03)},
      {"steps", softening("{stop: {after_steps: 4}}"), "4 steps",
       [](Followed& run) { return run.simulation().walker().effort().accepted == 4; }},
  };
}

INSTANTIATE_TEST_SUITE_P(Ways, PathEnds, testing::ValuesIn(ways()));

/// Rounding may leave the last step a hair above its target.
TEST(PathEnd, AHairAboveTheTargetIsReached) {
  Followed run(softening("{stop: {load_below: 0.4}}"));
  run.follow();
  Followed other(softening("{stop: {load_below: 0.39999999999}}"));
  Candidate here = run.simulation().walker().here();
  here.history = run.simulation().system().history();
  other.simulation().walker().restore(std::move(here), run.simulation().walker().effort(),
                                      run.simulation().walker().leaving());
  other.simulation().path().restore(run.simulation().path().memory());
  EXPECT_EQ(other.follow(), 0);
  EXPECT_EQ(other.ending().kind, Ending::Kind::goal_reached);
}

/// A goal beyond which a path stands although it came from the other side is not reached.
TEST(PathEnd, GoalsHaveADirection) {
  Followed run(softening("{stop: {load_below: 0, gauges: {elongation: 0.04, tip: -1}}}"));
  run.follow();
  EXPECT_THAT(run.ending().reason, StartsWith("elongation reached"));
}

TEST(PathEnd, ALimitOfStepsIsNoGoal) {
  Followed run(softening("{stop: {steps: 4}}"));
  EXPECT_EQ(run.follow(), 4);
  EXPECT_EQ(run.ending().kind, Ending::Kind::stopped_early);
  EXPECT_THAT(run.ending().reason, testing::HasSubstr("path.stop.steps"));
}

/// Triangles joined at the middle of their sides alone are a mechanism: weak springs hold what moves.
TEST(PathEnd, WhatOnlyWeakSpringsHoldIsNoResult) {
  const Trace trace = dda::verification::follow(R"(
scene:
  regions: [{material: m, vertices: [[0, 0], [200, 0], [200, 100], [0, 100]]}]
  subdivision: {type: triangles, size: 30}
thickness: 100
materials: {m: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0.2}}
interfaces: {m: {between: [m, m], points: midpoint, treatment: penalty, law: {type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}}}
supports: {left: {at: [0, 0], fix: xy}, right: {at: [200, 0], fix: y}}
stages: [{loads: [{type: point_load, at: [100, 100], force: [0, -1]}]}]
gauges: {u: {type: displacement, at: [100, 100], direction: [0, -1]}}
)");
  EXPECT_EQ(trace.ending.kind, Ending::Kind::stopped_early);
  EXPECT_THAT(trace.ending.reason, testing::HasSubstr("only weak springs hold"));
  EXPECT_THAT(trace.ending.reason, testing::HasSubstr("block "));
  for (const Traced& at : trace.points) EXPECT_LT(std::abs(at.gauges.at("u")), 200);
}

}  // namespace
}  // namespace dda::verification
