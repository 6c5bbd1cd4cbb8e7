#include <gtest/gtest.h>

#include <thread>

#include "framework/messages/timings.hpp"

namespace dda {
namespace {

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

TEST(Timings, InnerPhasesAreTakenOutOfOuterOnes) {
  Timings timings;
  const double before = seconds_since_process_start();
  {
    const auto step = timings.measure("step");
    wait(10);
    for (int i = 0; i < 2; ++i) {
      const auto solve = timings.measure("solve");
      wait(20);
    }
    wait(10);
  }
  const double elapsed = seconds_since_process_start() - before;
  ASSERT_EQ(timings.phases().size(), 2u);
  const auto& [step, solve] = std::tie(timings.phases()[0], timings.phases()[1]);
  EXPECT_EQ(step.name, "step");
  EXPECT_EQ(step.calls, 1);
  EXPECT_EQ(solve.calls, 2);
  EXPECT_GE(step.seconds, 0.019);
  EXPECT_GE(solve.seconds, 0.039);
  EXPECT_LE(step.seconds + solve.seconds, elapsed + 1e-4);
}

TEST(Timings, TotalCountsFromTheStartOfTheProcess) {
  Timings timings;
  timings.end_start_up();
  const double first = timings.total();
  wait(5);
  EXPECT_GT(timings.start_up(), 0);
  EXPECT_LE(timings.start_up(), first);
  EXPECT_GE(timings.total() - first, 0.0049);
  EXPECT_LT(first, 3600);
}

TEST(Timings, AnEndedPhaseStopsCounting) {
  Timings timings;
  { const auto scope = timings.measure("a"); }
  const double once = timings.phases().at(0).seconds;
  wait(5);
  { const auto scope = timings.measure("b"); }
  EXPECT_EQ(timings.phases().at(0).seconds, once);
}

}  // namespace
}  // namespace dda
