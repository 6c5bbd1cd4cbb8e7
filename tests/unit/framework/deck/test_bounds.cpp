#include <gtest/gtest.h>

#include "framework/deck/bounds.hpp"

namespace dda {
namespace {

TEST(Bounds, EndsAreOpenOrClosed) {
  EXPECT_FALSE(above(0).contains(0));
  EXPECT_TRUE(at_least(0).contains(0));
  EXPECT_FALSE(below(1).contains(1));
  EXPECT_TRUE(at_most(1).contains(1));
  EXPECT_TRUE(between(0, 0.5).contains(0.5));
  EXPECT_FALSE(strictly_between(0, 0.5).contains(0.5));
  EXPECT_TRUE(any().contains(-1e300));
}

TEST(Bounds, IntersectionTakesTheStricterEnd) {
  const Bounds both = (above(0) & at_most(1)) & between(0, 2);
  EXPECT_FALSE(both.contains(0));
  EXPECT_TRUE(both.contains(1));
  EXPECT_FALSE(both.contains(1.5));
}

TEST(Bounds, Words) {
  EXPECT_EQ(any().words(), "");
  EXPECT_EQ(above(0).words(), "above 0");
  EXPECT_EQ(between(0, 0.5).words(), "between 0 and 0.5");
  EXPECT_EQ((above(0) & at_most(1)).words(), "above 0 and at most 1");
  EXPECT_EQ(strictly_between(-1, 1).words(), "above -1 and below 1");
}

}  // namespace
}  // namespace dda
