#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "continuation/motion/energy/positive_factor.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

/// A band, positive definite since its diagonal outweighs it.
Eigen::MatrixXd band(int size, int width, Random& random) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = std::max(0, i - width); j < i; ++j) out(i, j) = out(j, i) = random.between(-1, 1);
  out.diagonal().setConstant(2.0 * width + 1);
  return out;
}

/// By single columns where the band is narrow, by supernodes where it is broad.
TEST(PositiveFactor, HalvesMakeSolutions) {
  for (const int width : {2, 120}) {
    Random random(1);
    const Eigen::MatrixXd matrix = band(300, width, random);
    const Eigen::MatrixXd lower = matrix.triangularView<Eigen::Lower>();
    PositiveFactor factor;
    factor.analyse(lower.sparseView());
    ASSERT_TRUE(factor.factorise(lower.sparseView()));
    Eigen::VectorXd one = Eigen::VectorXd::Zero(300), other = one;
    one.segment<6>(12).setConstant(1);
    other.segment<6>(200).setConstant(-2);
    const Eigen::VectorXd exact = matrix.llt().solve(one);
    const PositiveFactor::Half half = factor.half_of(one);
    EXPECT_LT((factor.other_half_of(half.values) - exact).norm(), 1e-12 * exact.norm());
    EXPECT_NEAR(half.dot(factor.half_of(other)), exact.dot(other), 1e-12 * exact.norm());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(300);
    half.add_to(sum, 3);
    EXPECT_LT((sum - 3 * half.values).norm(), 1e-12 * sum.norm());
  }
}

}  // namespace
}  // namespace dda
