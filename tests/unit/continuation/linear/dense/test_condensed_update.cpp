#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "continuation/linear/dense/condensed_update.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;

class CondensedUpdateTest : public ::testing::Test {
 protected:
  CondensedUpdateTest() {
    const Matrix root = Matrix::NullaryExpr(size(), size(), [&] { return uniform_(random_); });
    g_ = root * root.transpose() / static_cast<double>(num_points);
    right_ = Matrix::NullaryExpr(size(), 2, [&] { return uniform_(random_); });
    for (std::size_t p = 0; p < num_points; ++p)
      e_.push_back(p % 5 == 4 ? Mat2(Mat2::Zero()) : Mat2(0.4 * Mat2::Identity() + some()));
  }

  static Eigen::Index size() { return 2 * static_cast<Eigen::Index>(num_points); }
  Mat2 some() {
    return Mat2::NullaryExpr([&] { return 0.1 * uniform_(random_); });
  }
  Matrix whole() const {
    Matrix out = g_;
    for (std::size_t p = 0; p < num_points; ++p) {
      const auto at = 2 * static_cast<Eigen::Index>(p);
      out.middleCols<2>(at) = (g_.middleCols<2>(at) * e_[p]).eval();
    }
    return out + Matrix::Identity(size(), size());
  }
  /// Largest difference from what the whole matrix gives.
  double miss(CondensedUpdate& update) const {
    Matrix x = right_;
    update.solve(x);
    return (x - whole().partialPivLu().solve(right_)).cwiseAbs().maxCoeff() / x.cwiseAbs().maxCoeff();
  }
  std::vector<bool> steady(std::size_t every) const {
    std::vector<bool> out(num_points);
    for (std::size_t p = 0; p < num_points; ++p) out[p] = p % every != 0;
    return out;
  }

  static constexpr std::size_t num_points = 80;
  static constexpr double good = 1e-10;
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{-1, 1};
  Matrix g_, right_;
  std::vector<Mat2> e_;
};

TEST_F(CondensedUpdateTest, SolvesForTheFirstUpdate) {
  CondensedUpdate update(g_);
  update.begin(e_, steady(3));
  EXPECT_LT(miss(update), good);
}

TEST_F(CondensedUpdateTest, FollowsWhatChangesAndWhatWasThoughtSteady) {
  CondensedUpdate update(g_);
  update.begin(e_, steady(3));
  for (std::size_t round = 0; round < 4; ++round) {
    for (std::size_t p = 0; p < num_points; p += 3) e_[p] += some();
    e_[1 + 9 * round].setZero();  // steady ones become as in the base
    e_[4 + 10 * round] = some();  // and one that was
    update.set(e_);
    EXPECT_LT(miss(update), good) << round;
  }
}

TEST_F(CondensedUpdateTest, FewSteadyPointsAreNotEliminated) {
  CondensedUpdate update(g_);
  update.begin(e_, std::vector<bool>(num_points, false));
  for (Mat2& e : e_) e *= 1.5;
  update.set(e_);
  EXPECT_LT(miss(update), good);
}

TEST_F(CondensedUpdateTest, SingularWithoutTheOthersIsSolvedByAll) {
  for (std::size_t p = 1; p < num_points; ++p) g_.block(0, 2 * static_cast<Eigen::Index>(p), 2, 2).setZero();
  for (std::size_t p = 1; p < num_points; ++p) g_.block(2 * static_cast<Eigen::Index>(p), 0, 2, 2).setZero();
  e_[0] = -g_.topLeftCorner<2, 2>().inverse();  // 1 + G E of this point alone is zero
  std::vector<bool> is_steady(num_points, true);
  CondensedUpdate update(g_);
  update.begin(e_, is_steady);
  e_[0] *= 0.5;
  update.set(e_);
  EXPECT_LT(miss(update), good);
}

TEST_F(CondensedUpdateTest, ProductIsThatOfTheWholeMatrix) {
  CondensedUpdate update(g_);
  update.begin(e_, steady(3));
  Matrix x = -right_;
  update.subtract_product(right_, x);
  EXPECT_LT((x + whole() * right_).cwiseAbs().maxCoeff(), 1e-13 * x.cwiseAbs().maxCoeff() * num_points);
}

}  // namespace
}  // namespace dda
