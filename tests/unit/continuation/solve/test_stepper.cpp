#include <gtest/gtest.h>

#include "unit/continuation/on_path.hpp"

namespace dda {
namespace {

/// Accepted steps are those that LOCA counts, whoever found them.
void expect_loca_took_all(OnPath& on_path) {
  int accepted = 0;
  while (on_path.path().next()) {
    ++accepted;
    const Stepper& stepper = on_path.stepper();
    ASSERT_EQ(stepper.num_steps(Unknowns::cracked) + stepper.num_steps(Unknowns::whole), accepted);
  }
  EXPECT_GT(accepted, 3);
  const Effort& effort = on_path.walker().effort();
  EXPECT_EQ(effort.accepted, accepted);
  EXPECT_EQ(effort.cracked_steps, on_path.stepper().num_steps(Unknowns::cracked));
  EXPECT_EQ(effort.whole_steps, on_path.stepper().num_steps(Unknowns::whole));
}

TEST(Stepper, LocaTakesEveryStepOnTheCrackedPoints) {
  OnPath on_path(bar_deck(100), "{control: staged}");
  expect_loca_took_all(on_path);
  EXPECT_EQ(on_path.stepper().num_steps(Unknowns::whole), 0);
}

TEST(Stepper, LocaTakesEveryStepOnAllUnknowns) {
  OnPath on_path(bar_deck(100), "{control: staged, update: refactorise}");
  expect_loca_took_all(on_path);
  EXPECT_EQ(on_path.stepper().num_steps(Unknowns::cracked), 0);
}

TEST(Stepper, LocaTakesWhatSequentiallyLinearStepsHaveFound) {
  OnPath on_path(bar_deck(100), "{control: event}");
  expect_loca_took_all(on_path);
}

}  // namespace
}  // namespace dda
