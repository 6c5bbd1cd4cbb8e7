// The parts of following a path, each alone: on the bar of one interface, half way down its softening branch.
#include <gmock/gmock.h>

#include "continuation/follow/goals.hpp"
#include "continuation/follow/judge.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/turns.hpp"
#include "unit/continuation/on_path.hpp"

namespace dda {
namespace {

using testing::HasSubstr;

class OnTheWayDown : public testing::Test {
 protected:
  OnTheWayDown() : bar_(1000, "stop: {load_below: 0.5}") {
    for ([[maybe_unused]] const Point& point : bar_.path()) {
    }
  }

  /// A little farther along the tangent; exact, the branch being straight.
  Candidate ahead(double energy) {
    Candidate out = bar_.walker().here();
    out.state = bar_.walker().ahead(energy);
    out.dissipated += energy;
    const double stress = bar_.stress(), next = out.state.load_factor;
    out.stored *= next * next / (stress * stress);
    out.work += energy + out.stored - bar_.walker().here().stored;
    out.arriving = bar_.walker().leaving();
    return out;
  }

  Bar bar_;
};

TEST_F(OnTheWayDown, WhatBalancesIsTheNextPoint) {
  PathState path = bar_.state();
  const Candidate next = ahead(10);
  EXPECT_NEAR(missing_work(path, next), 0, 1e-9);
  EXPECT_EQ(objection_to(path, next).why, "");
  EXPECT_FALSE(is_coarse(path, next));
  EXPECT_FALSE(creates_energy(path, next, StepKind::jump));
}

TEST_F(OnTheWayDown, WhatLosesWorkHasJumped) {
  PathState path = bar_.state();
  Candidate next = ahead(10);
  next.work += 12;
  const Objection objection = objection_to(path, next);
  EXPECT_THAT(objection.why, HasSubstr("the step jumps"));
  EXPECT_FALSE(objection.unsound);
  EXPECT_TRUE(is_coarse(path, next));
}

TEST_F(OnTheWayDown, WhatUnloadsRetracesTheBranch) {
  PathState path = bar_.state();
  Candidate next = bar_.walker().here();
  next.state.load_factor *= 0.9;
  next.state.d = next.state.d.moved(-0.1, next.state.d);
  next.work += next.stored * (0.81 - 1);
  next.stored *= 0.81;
  EXPECT_THAT(objection_to(path, next).why, HasSubstr("retraces"));
}

TEST_F(OnTheWayDown, EnergyOutOfNothingIsCreated) {
  PathState path = bar_.state();
  Candidate next = ahead(10);
  next.stored += 20;
  EXPECT_TRUE(creates_energy(path, next, StepKind::event));
}

TEST_F(OnTheWayDown, AnEventSpendsAheadAndAJumpDoesNot) {
  PathState path = bar_.state();
  Candidate next = ahead(10);
  next.stored += 5;
  EXPECT_FALSE(creates_energy(path, next, StepKind::event));
  EXPECT_TRUE(creates_energy(path, next, StepKind::jump));
}

TEST_F(OnTheWayDown, TheFirstOfTheValuesPassedIsLandedOn) {
  const Candidate next = ahead(10);
  const double from = bar_.elongation(), to = bar_.gauge().value(next.state.d, next.state.load_factor);
  const auto wanted = [&](double share) { return Landing{"u", bar_.gauge(), from + share * (to - from)}; };
  PathState path = bar_.state({.landings = {wanted(0.75), wanted(0.25), wanted(1.5)}});
  const auto crossing = first_crossing(path, next);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->share, 0.25, 1e-12);
  PathState beyond = bar_.state({.landings = {wanted(1.5)}});
  EXPECT_FALSE(first_crossing(beyond, next));
}

TEST_F(OnTheWayDown, TheLimitPointIsSoughtWhereTheTangentsMeet) {
  PathState path = bar_.state();
  Candidate next = ahead(10);
  EXPECT_FALSE(before_peak(path, next)) << "the load falls all the way";
  path.memory.direction = -path.memory.direction;  // as if it were to grow the other way
  path.memory.peak_load = path.load_of(path.walker.state());
  next.arriving.load_factor *= -1;
  next.arriving.d = next.arriving.d.scaled(-1);
  next.state = path.walker.state();
  const auto share = before_peak(path, next);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, 0.5, 1e-9);
}

TEST_F(OnTheWayDown, AFallenLoadIsAGoalUnlessThePathHasTurnedRound) {
  PathState fallen = bar_.state();
  EXPECT_GT(fallen.memory.cracked_since_peak, 0.1 * fallen.memory.cracked_to_peak);
  settle(fallen);
  EXPECT_EQ(fallen.ending.kind, Ending::Kind::goal_reached);
  EXPECT_THAT(fallen.ending.reason, HasSubstr("load below 50 %"));
  PathState turned = bar_.state();
  turned.memory.cracked_to_peak = fallen.memory.cracked_since_peak;
  turned.memory.cracked_since_peak = 0.09 * turned.memory.cracked_to_peak;
  PathState let_go = bar_.state();
  let_go.memory = turned.memory;
  turned.memory.largest_displacement = 2 * bar_.elongation();
  let_go.memory.largest_displacement = bar_.elongation();
  settle(turned);
  EXPECT_EQ(turned.ending.kind, Ending::Kind::running) << "it may be loaded again";
  PathState softened = bar_.state();
  softened.memory = turned.memory;
  turned.memory.reloaded_way = softened.memory.reloaded_way = turned.memory.farthest_way;
  turned.memory.reloaded_share = -1;
  softened.memory.reloaded_share = 0.5;
  settle(softened);
  EXPECT_EQ(softened.ending.kind, Ending::Kind::goal_reached) << "it bears half of its peak";
  settle(turned);
  EXPECT_EQ(turned.ending.kind, Ending::Kind::stopped_early);
  EXPECT_THAT(turned.ending.reason, HasSubstr("turned round"));
  settle(let_go);
  EXPECT_EQ(let_go.ending.kind, Ending::Kind::goal_reached) << "it has moved on: friction has let go";
}

TEST_F(OnTheWayDown, NoStepMayChangeTheLoadByMoreThanItsPeak) {
  PathState path = bar_.state();
  const Move move{.kind = StepKind::dissipation, .equation = {}, .rate = 1};
  const double far = 1e9, amount = bounded(path, move, far);
  const double change = std::abs(path.walker.leaving().rate(path.load)) * amount;
  EXPECT_LT(amount, far);
  EXPECT_LE(change, path.memory.peak_load * (1 + 1e-12));
  EXPECT_EQ(bounded(path, move, 1e-9), 1e-9);
}

}  // namespace
}  // namespace dda
