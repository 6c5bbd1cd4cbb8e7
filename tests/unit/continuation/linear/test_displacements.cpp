#include <gmock/gmock.h>

#include "continuation/linear/displacements.hpp"

namespace dda {
namespace {

using testing::Each;

/// Two nodes, the first of which is known to be moved by 1; all are moved by 2 as the rest is computed.
class Twos final : public Displacements::Completion {
 public:
  explicit Twos(int& asked) : asked_(asked) {}
  std::vector<double> all() const override {
    ++asked_;
    return std::vector<double>(12, 2.0);
  }

 private:
  int& asked_;
};

class PartlyKnown : public testing::Test {
 protected:
  int asked_ = 0;
  Displacements d_{{1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0},
                   std::make_shared<const std::vector<bool>>(std::vector<bool>{true, false}),
                   std::make_unique<Twos>(asked_),
                   7.0};
};

TEST_F(PartlyKnown, TheRestIsComputedOnceWhenItIsAskedFor) {
  const Displacements copy = d_;
  EXPECT_FALSE(copy.are_all_known());
  EXPECT_EQ(asked_, 0);
  EXPECT_EQ(copy.all()[11], 2);
  EXPECT_EQ(d_.all()[11], 2);
  EXPECT_EQ(asked_, 1);
  EXPECT_TRUE(d_.are_all_known());
  EXPECT_EQ(*d_.dead_work(), 7);
}

TEST_F(PartlyKnown, WhatIsKnownStaysWhereAndAsItIs) {
  const std::vector<double>& watched = d_.watched();
  EXPECT_EQ(&d_.all(), &watched);
  EXPECT_EQ(watched[0], 1);
}

TEST_F(PartlyKnown, AGaugeAsksForTheRestOnlyWhereItLooks) {
  const Functional near{{{BlockId{0}, Vec6::Ones()}}}, far{{{BlockId{1}, Vec6::Ones()}}};
  EXPECT_EQ(near.value(d_.asked_by(near), 0), 6);
  EXPECT_EQ(asked_, 0);
  EXPECT_EQ(far.value(d_.asked_by(far), 0), 12);
  EXPECT_EQ(asked_, 1);
}

TEST_F(PartlyKnown, MovedTheyHaveTheSameRest) {
  std::vector<double> direction(12, 0.0);
  direction[0] = 3;
  const Displacements moved = d_.moved(2, direction);
  EXPECT_EQ(asked_, 0);
  EXPECT_EQ(moved[0], 7);
  EXPECT_EQ(moved[1], 1);
  EXPECT_EQ(moved[11], 2);
}

TEST_F(PartlyKnown, AreCompletedWhileTheyLive) {
  const Displacements::Pending pending(d_);
  pending.complete();
  EXPECT_TRUE(d_.are_all_known());
  d_ = {};
  EXPECT_TRUE(pending.is_over());
  pending.complete();
  EXPECT_EQ(asked_, 1);
}

TEST(Displacements, OfAllNodesAreKnown) {
  const Displacements all(std::vector<double>(6, 1.0));
  EXPECT_TRUE(all.are_all_known());
  EXPECT_FALSE(all.dead_work());
  EXPECT_THAT(all.moved(1, all).all(), Each(2));
}

}  // namespace
}  // namespace dda
