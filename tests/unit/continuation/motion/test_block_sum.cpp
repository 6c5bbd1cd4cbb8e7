// Summing up by blocks, and the factor of what comes out.
#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "continuation/motion/energy/block_sum.hpp"
#include "continuation/motion/energy/positive_factor.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

Mat6 any_block(Random& random) {
  Mat6 out;
  for (double& entry : out.reshaped()) entry = random.between(-1, 1);
  return out;
}

Eigen::MatrixXd whole(const BlockSum::Matrix& lower) {
  const Eigen::MatrixXd below(lower);
  return below.selfadjointView<Eigen::Lower>();
}

TEST(BlockSum, IsTheSumOfItsBlocks) {
  Random random(1);
  BlockSum sum;
  EXPECT_TRUE(sum.set_pattern(4, {{2, 0}, {3, 1}, {2, 0}}));
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(24, 24);
  for (int round = 0; round < 2; ++round) {
    sum.set_zero();
    expected.setZero();
    for (const auto& [i, j] : {std::pair(0, 0), {1, 1}, {2, 0}, {2, 2}, {3, 1}, {2, 0}}) {
      Mat6 m = any_block(random);
      if (i == j) m = (m + m.transpose()).eval();
      sum.add(static_cast<std::size_t>(i), static_cast<std::size_t>(j), m);
      expected.block<6, 6>(6 * i, 6 * j) += m;
      if (i != j) expected.block<6, 6>(6 * j, 6 * i) += m.transpose();
    }
    EXPECT_LT((whole(sum.matrix()) - expected).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(BlockSum, KnowsWhetherItsPatternIsNew) {
  BlockSum sum;
  EXPECT_TRUE(sum.set_pattern(3, {{1, 0}}));
  EXPECT_FALSE(sum.set_pattern(3, {{1, 0}, {1, 0}}));
  EXPECT_TRUE(sum.covers({{1, 0}}));
  EXPECT_FALSE(sum.covers({{1, 0}, {2, 1}}));
  std::vector<BlockSum::Pair> pairs{{2, 1}};
  sum.append_pairs(pairs);
  EXPECT_TRUE(sum.set_pattern(3, pairs));
  EXPECT_TRUE(sum.covers({{1, 0}, {2, 1}}));
}

TEST(PositiveFactor, SolvesOrSaysThatItCannot) {
  Random random(2);
  for (const std::size_t n : {1u, 40u}) {
    BlockSum sum;
    std::vector<BlockSum::Pair> pairs;
    for (std::uint32_t i = 1; i < n; ++i) pairs.emplace_back(i, i / 2);
    sum.set_pattern(n, pairs);
    sum.set_zero();
    for (std::size_t i = 0; i < n; ++i) sum.add(i, i, 20 * Mat6::Identity());
    for (const auto& [i, j] : pairs) sum.add(i, j, any_block(random));
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(6 * n), -1, 2);
    PositiveFactor factor;
    factor.analyse(sum.matrix());
    ASSERT_TRUE(factor.factorise(sum.matrix()));
    EXPECT_LT((whole(sum.matrix()) * factor.solve(right) - right).norm(), 1e-12 * right.norm());
    sum.add(n - 1, n - 1, -40 * Mat6::Identity());
    EXPECT_FALSE(factor.factorise(sum.matrix()));
  }
}

}  // namespace
}  // namespace dda
