#include <gtest/gtest.h>

#include <cmath>

#include "continuation/stability/mode_tracker.hpp"

namespace dda {
namespace {

/// Unit shapes of one block in the plane of its first two unknowns.
std::vector<double> shape(double angle) { return {std::cos(angle), std::sin(angle), 0, 0, 0, 0}; }

const Mass mass = Mass::identity(1);

TEST(ModeTracker, FollowsShapesThroughACrossing) {
  ModeTracker tracker;
  tracker.start({.values = {1, 2}, .shapes = {shape(0), shape(M_PI_2)}});
  EXPECT_EQ(tracker.follow({.values = {1, 2}, .shapes = {shape(0.3), shape(M_PI_2 + 0.3)}}, mass),
            (std::vector<int>{0, 1}));
  // The second has become the lower one; signs do not matter.
  EXPECT_EQ(tracker.follow({.values = {0.5, 0.9}, .shapes = {shape(M_PI_2 + 0.6 + M_PI), shape(0.6)}}, mass),
            (std::vector<int>{1, 0}));
}

TEST(ModeTracker, LosesAndFindsAgain) {
  ModeTracker tracker;
  tracker.start({.values = {1, 2}, .shapes = {shape(0), shape(M_PI_2)}});
  const std::vector<double> other{0, 0, 1, 0, 0, 0};
  EXPECT_EQ(tracker.follow({.values = {0.1, 1}, .shapes = {other, shape(0)}}, mass),
            (std::vector<int>{1, -1}));
  EXPECT_EQ(tracker.follow({.values = {1, 2}, .shapes = {shape(0), shape(M_PI_2)}}, mass),
            (std::vector<int>{0, 1}));
}

TEST(ModeTracker, GivesEachModeToOneAlone) {
  ModeTracker tracker;
  tracker.start({.values = {1, 2}, .shapes = {shape(0), shape(0.2)}});
  EXPECT_EQ(tracker.follow({.values = {1}, .shapes = {shape(0.15)}}, mass), (std::vector<int>{-1, 0}));
}

}  // namespace
}  // namespace dda
