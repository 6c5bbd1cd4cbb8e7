#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "continuation/linear/dense/dense_inertia.hpp"

namespace dda {
namespace {

TEST(DenseInertia, CountsAsTheEigenvaluesDo) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (const Eigen::Index n : {1, 2, 3, 10, 90}) {
    Eigen::MatrixXd a(n, n);
    for (double& value : a.reshaped()) value = normal(random);
    a = (a + a.transpose()).eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own(a, Eigen::EigenvaluesOnly);
    EXPECT_EQ(num_positive_eigenvalues(a), static_cast<int>((own.eigenvalues().array() > 0).count()));
  }
}

TEST(DenseInertia, ZeroDiagonalNeedsPairsOfPivots) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(4, 4);
  a(0, 1) = a(1, 0) = 2;
  a(2, 3) = a(3, 2) = -1;
  EXPECT_EQ(num_positive_eigenvalues(a), 2);
}

TEST(DenseInertia, NothingOfASingularMatrix) {
  EXPECT_EQ(num_positive_eigenvalues(Eigen::MatrixXd::Zero(2, 2)), std::nullopt);
  EXPECT_EQ(num_positive_eigenvalues(Eigen::MatrixXd(0, 0)), 0);
}

}  // namespace
}  // namespace dda
