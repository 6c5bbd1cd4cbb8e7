#include <gmock/gmock.h>

#include "continuation/linear/displacements.hpp"

namespace dda {
namespace {

using testing::Each;

/// One node with every displacement a number, which opens the only point by as much and says that its gauges are a
/// hundred times as large, so that it shows who has been asked.
class Uniform final : public Displacements::Sum {
 public:
  struct Log {
    int asked = 0;
    std::vector<Displacements::Pending> pending = {};
  };

  Uniform(Log& log, double value) : log_(log), value_(value), openings_{Vec2(value, 0)} {}
  std::size_t size() const override { return block_unknowns; }
  std::vector<double> all() const override {
    ++log_.asked;
    return std::vector<double>(block_unknowns, value_);
  }
  const std::vector<Vec2>& openings() const override { return openings_; }
  double product(const Functional&) const override { return 100 * value_; }
  double dead_work() const override { return 0; }
  std::shared_ptr<const Sum> combined(double a, double b, const Sum& other) const override {
    const auto* with = dynamic_cast<const Uniform*>(&other);
    return with ? std::make_shared<Uniform>(log_, a * value_ + b * with->value_) : nullptr;
  }
  void note(const Displacements::Pending& displacements) const override {
    log_.pending.push_back(displacements);
  }

 private:
  Log& log_;
  double value_;
  std::vector<Vec2> openings_;
};

class SumOfSolutions : public testing::Test {
 protected:
  Uniform::Log log_;
  Displacements d_{std::make_shared<const Uniform>(log_, 2)};
  Functional gauge_{{{BlockId{0}, Vec6::Ones()}}, 3, 1};
};

TEST_F(SumOfSolutions, ComputesAllOnceWhenTheyAreAskedFor) {
  const Displacements copy = d_;
  EXPECT_FALSE(copy.are_all_known());
  EXPECT_EQ(copy.size(), 6);
  EXPECT_EQ(copy.all()[5], 2);
  EXPECT_EQ(d_.all()[5], 2);
  EXPECT_EQ(log_.asked, 1);
  EXPECT_TRUE(d_.are_all_known());
}

TEST_F(SumOfSolutions, TellsGaugesTheSameWhetherAllWereAskedForOrNot) {
  const double before = d_.value(gauge_, 10);
  EXPECT_EQ(before, 3 * 10 + 1 + 200);
  EXPECT_EQ(log_.asked, 0);
  d_.all();
  EXPECT_EQ(d_.value(gauge_, 10), before);
}

TEST_F(SumOfSolutions, AskedForAGaugeWithoutRowsSaysItsConstants) {
  EXPECT_EQ(d_.value(Functional{.rows = {}, .per_load_factor = 2}, 10), 20);
}

TEST_F(SumOfSolutions, StaysASumWhenItMoves) {
  const Displacements moved = d_.moved(2, Displacements(std::make_shared<const Uniform>(log_, 5)));
  EXPECT_EQ(log_.asked, 0);
  EXPECT_EQ(moved.sum()->openings().front().x(), 12);
  EXPECT_EQ(moved.scaled(-1).sum()->openings().front().x(), -12);
  EXPECT_EQ(moved[3], 12);
}

TEST_F(SumOfSolutions, MovedByWhatIsNoneIsNoneEither) {
  const Displacements moved = d_.moved(2, std::vector<double>(6, 1.0));
  EXPECT_EQ(moved.sum(), nullptr);
  EXPECT_THAT(moved.all(), Each(4));
}

TEST_F(SumOfSolutions, IsSettledWhileItLives) {
  ASSERT_EQ(log_.pending.size(), 1);
  const Displacements::Pending pending = log_.pending.front();
  pending.settle();
  EXPECT_EQ(d_.sum(), nullptr);
  EXPECT_TRUE(d_.are_all_known());
  EXPECT_EQ(d_.value(gauge_, 10), 3 * 10 + 1 + 12);
  d_ = {};
  EXPECT_TRUE(pending.is_over());
  pending.settle();
  EXPECT_EQ(log_.asked, 1);
}

TEST(Displacements, OfAllNodesAreKnown) {
  const Displacements all(std::vector<double>(6, 1.0));
  EXPECT_TRUE(all.are_all_known());
  EXPECT_EQ(all.sum(), nullptr);
  EXPECT_THAT(all.moved(1, all).all(), Each(2));
  EXPECT_THAT(all.combined(0.25, 0.5, all).all(), Each(0.75));
}

}  // namespace
}  // namespace dda
