// Every early stop of a path and every attempt that it does not take has its reason.
#include <gmock/gmock.h>

#include "unit/continuation/on_path.hpp"

namespace dda {
namespace {

/// A step that converges and is refused for what it leads past must leave a reason.
TEST(Path, RefusedStepsHaveTheirReason) {
  OnPath coarse(endless_bar_deck(),
                "{step: {accuracy: 1.0e-30}, control: dissipation, stop: {load_below: 0}}");
  for ([[maybe_unused]] const Point& point : coarse.path()) {
  }
  EXPECT_EQ(coarse.path().ending().kind, Ending::Kind::stopped_early);
  EXPECT_EQ(coarse.path().ending().stop, Stop::no_next_equilibrium);
  EXPECT_THAT(coarse.path().ending().reason,
              testing::StartsWith("dissipation control found no next equilibrium: the step leaves too much "
                                  "energy unaccounted for; "));
}

/// Where neither the load nor what it moves nor the law of the crack tells how far to go, no step is tried.
TEST(Path, FirstStepWithoutALengthHasItsReason) {
  std::string deck = endless_bar_deck();
  deck.insert(deck.rfind('}'),
              ", still: {type: relative_displacement, from: [0, 50], to: [0, 50], direction: [1, 0]}");
  OnPath bar(deck, "{control: dissipation, load_gauge: still}");
  ASSERT_TRUE(bar.path().next());
  PathMemory memory = bar.path().memory();
  memory.largest_displacement = 0;
  bar.path().restore(memory);
  EXPECT_FALSE(bar.path().next());
  EXPECT_EQ(bar.path().ending().kind, Ending::Kind::stopped_early);
  EXPECT_THAT(
      bar.path().ending().reason,
      testing::StartsWith("dissipation control found no next equilibrium: the tangent does not tell how "
                          "far a step may go; "));
}

/// Increments of which none is tried any more must leave a reason.
TEST(Path, EveryEarlyStopHasItsReason) {
  Bar increments(100, "control: load_increments");
  ASSERT_TRUE(increments.path().next());
  PathMemory memory = increments.path().memory();
  memory.step = 1e-5 * increments.stress();
  increments.path().restore(memory);
  EXPECT_FALSE(increments.path().next());
  EXPECT_EQ(increments.path().ending().kind, Ending::Kind::stopped_early);
  EXPECT_EQ(increments.path().ending().stop, Stop::increments_failed);
  EXPECT_THAT(increments.path().ending().reason,
              testing::EndsWith("the increments have fallen below 0.0001 of it"));
}

/// What the log has of the attempts that were not taken, to the end of a path.
std::vector<std::string> refusals(OnPath& structure) {
  std::vector<std::string> out;
  structure.path().report_to([&](const std::string& event, const std::string& text) {
    if (event == "rejected" || event == "refined") out.push_back(text);
  });
  while (structure.path().next()) {
  }
  return out;
}

/// Also those that no step of the control led to, but the landing on rupture.
TEST(Path, EveryCountedRejectionIsInTheLogWithItsReason) {
  OnPath bar(endless_bar_deck(), "stop: {load_below: 0.001}");
  const std::vector<std::string> lines = refusals(bar);
  EXPECT_EQ(static_cast<int>(lines.size()), bar.walker().effort().rejected);
  EXPECT_THAT(lines, testing::Each(testing::Not(testing::EndsWith(": "))));
  EXPECT_THAT(lines, testing::Contains(testing::StartsWith("load, landing on rupture: ")));
}

}  // namespace
}  // namespace dda
