#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "continuation/linear/matrix_quality.hpp"
#include "support/cracked.hpp"
#include "support/dense.hpp"

namespace dda {
namespace {

/// Â, the matrix scaled to a diagonal of ones.
Eigen::MatrixXd dense_scaled(const BlockMatrix& a) {
  const Eigen::MatrixXd full = dense(a);
  const Eigen::VectorXd scale = full.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * full * scale.asDiagonal();
}

double norm(const Eigen::MatrixXd& a) { return a.cwiseAbs().colwise().sum().maxCoeff(); }

double dense_condition(const BlockMatrix& a) {
  const Eigen::MatrixXd scaled = dense_scaled(a);
  return norm(scaled) * norm(scaled.inverse());
}

/// Eigenvalues of A itself: scaling does not change their signs.
int dense_negatives(const BlockMatrix& a) {
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense(a)).eigenvalues();
  return static_cast<int>((values.array() < 0).count());
}

/// An estimate from below, and a good one.
void expect_condition(const BlockMatrix& a, const MatrixQuality& found) {
  const double exact = dense_condition(a);
  EXPECT_LE(found.condition, exact * (1 + 1e-6));
  EXPECT_GE(found.condition, exact / 3);
}

BlockMatrix shifted(BlockMatrix a, double shift) {
  for (std::size_t r = 0; r < a.num_rows(); ++r) a.add(BlockId{r}, BlockId{r}, shift * Mat6::Identity());
  return a;
}

TEST(MatrixQuality, IntactStructureIsDefinite) {
  const Structure structure(square_deck());
  const Equilibrium equilibrium = structure.equilibrium();
  const MatrixQuality found = assess(equilibrium.intact());
  expect_condition(equilibrium.intact(), found);
  EXPECT_EQ(found.negative_pivots, 0);
  EXPECT_EQ(found.null_pivots, 0);
  // The pivots of a definite matrix lie between its extreme eigenvalue and its largest diagonal entry.
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense_scaled(equilibrium.intact())).eigenvalues();
  EXPECT_GE(found.smallest_pivot, values.minCoeff() * (1 - 1e-6));
  EXPECT_LT(found.smallest_pivot, 1);
  EXPECT_NEAR(found.largest_pivot, 1, 1e-12);
}

/// [1 c; c 1] has the pivots 1 and 1 − c², whatever its rows are scaled with.
TEST(MatrixQuality, PivotsAreThoseOfTheScaledMatrix) {
  for (const double c : {0.1, 0.6, 0.99}) {
    BlockMatrix a(1, {});
    Mat6 m = Mat6::Identity();
    m(0, 0) = 1e8;
    m(1, 1) = 1e-4;
    m(0, 1) = m(1, 0) = c * 1e2;
    a.add(BlockId{0}, BlockId{0}, m);
    const MatrixQuality found = assess(a);
    EXPECT_NEAR(found.smallest_pivot, 1 - c * c, 1e-12);
    EXPECT_NEAR(found.largest_pivot, 1, 1e-12);
    EXPECT_NEAR(found.condition, (1 + c) / (1 - c), 1e-10 * found.condition);
  }
}

TEST(MatrixQuality, CountsNegativeEigenvalues) {
  int most = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CrackedSystem cracked(square_deck(), seed);
    const BlockMatrix tangent = cracked.system().stiffness(cracked.state());
    for (const double shift : {0.0, -0.1, -1.0}) {
      const BlockMatrix a = shifted(tangent, shift);
      const MatrixQuality found = assess(a);
      EXPECT_EQ(found.negative_pivots, dense_negatives(a)) << "seed " << seed << ", shift " << shift;
      EXPECT_EQ(found.null_pivots, 0);
      expect_condition(a, found);
      most = std::max(most, found.negative_pivots);
    }
  }
  EXPECT_GT(most, 3) << "matrices that are indefinite enough to tell";
}

/// Supports and springs far below round-off leave the rigid motions of the whole.
TEST(MatrixQuality, CountsRigidMotionsOfAFreeStructure) {
  for (const std::string treatment : {"consistent", "penalty"}) {
    const Structure structure(square_deck(
        "weak_springs: 0\nsupport_stiffness: 1e-20\n",
        "  joint: {between: [mortar, stone], treatment: " + treatment +
            ", law: {type: linear_softening, tensile_strength: 0.01, fracture_energy: 0.0002}}\n"));
    const Equilibrium equilibrium = structure.equilibrium();
    const MatrixQuality found = assess(equilibrium.intact());
    EXPECT_EQ(found.null_pivots, 3) << treatment;
    EXPECT_EQ(found.negative_pivots, 0) << treatment;
    EXPECT_GT(found.condition, 1e14) << treatment;
  }
}

TEST(MatrixQuality, ZeroRowsAreNullPivots) {
  BlockMatrix a(2, {{BlockId{0}, BlockId{1}}});
  Mat6 m = Mat6::Identity();
  m(2, 2) = 0;
  m(4, 4) = -3;
  a.add(BlockId{0}, BlockId{0}, m);
  a.add(BlockId{1}, BlockId{1}, 2 * Mat6::Identity());
  const MatrixQuality found = assess(a);
  EXPECT_EQ(found.null_pivots, 1);
  EXPECT_EQ(found.negative_pivots, 1);
  EXPECT_TRUE(std::isinf(found.condition));
  EXPECT_NEAR(found.smallest_pivot, 1, 1e-12) << "null pivots do not count";
}

TEST(MatrixQuality, DoesNotDependOnUnits) {
  const Structure small(square_deck());
  const UnitChange units{.force = 1e-2, .length = 1e3};
  const Structure large(square_deck(), units);
  const Equilibrium one = small.equilibrium(), other = large.equilibrium();
  ASSERT_GT(std::abs(dense(other.intact())(3, 3) / dense(one.intact())(3, 3) - 1), 0.5);
  const MatrixQuality a = assess(one.intact()), b = assess(other.intact());
  EXPECT_NEAR(a.condition, b.condition, 1e-6 * a.condition);
  EXPECT_NEAR(a.smallest_pivot, b.smallest_pivot, 1e-6 * a.smallest_pivot);
  EXPECT_NEAR(a.largest_pivot, b.largest_pivot, 1e-6 * a.largest_pivot);
}

/// The linear system may hold the tangent of another state, such as a rejected one.
TEST(SystemStiffness, IsThatOfTheStateAskedFor) {
  CrackedSystem cracked;
  System& system = cracked.system();
  const State& at = cracked.state();
  const std::vector<double> x = cracked.direction();
  std::vector<double> expected(x.size());
  ASSERT_TRUE(system.use_tangent(system.new_stamp(), system.laws(at).tangent));
  system.linear().multiply(x, expected);
  const std::vector<double> zero(x.size(), 0.0);
  ASSERT_TRUE(system.use_tangent(system.new_stamp(), system.laws(zero, 0).tangent));
  const Eigen::MatrixXd stiffness = dense(system.stiffness(at));
  EXPECT_LT((stiffness * vec(x) - vec(expected)).norm(), 1e-12 * vec(expected).norm());
  EXPECT_GT((stiffness - dense(cracked.equilibrium().intact())).norm(), 1e-6);
  EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-12 * stiffness.norm());
}

}  // namespace
}  // namespace dda
