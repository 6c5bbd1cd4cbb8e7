#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "continuation/detour/increment/damped_motion.hpp"
#include "support/cracked.hpp"
#include "support/dense.hpp"

namespace dda {
namespace {

/// Largest eigenvalue of M⁻¹ K; M⁻¹ is symmetric and positive definite.
double highest(const FictitiousMass& mass, const BlockMatrix& stiffness) {
  const Eigen::MatrixXd k = dense(stiffness);
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(k.rows(), k.cols());
  for (std::size_t i = 0; i < stiffness.num_rows(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    inverse.block<6, 6>(at, at) = mass.inverse(i);
  }
  const Eigen::MatrixXd root = inverse.llt().matrixL();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(root.transpose() * k * root).eigenvalues().maxCoeff();
}

class MassOfTheSquare : public testing::TestWithParam<std::string> {};

TEST_P(MassOfTheSquare, MakesATimeStepOfOneStable) {
  const Structure structure(cracked_square(GetParam()));
  const Equilibrium equilibrium = structure.equilibrium();
  const FictitiousMass mass(equilibrium.intact());
  const double limit = 4 / 1.2;
  EXPECT_LE(highest(mass, equilibrium.intact()), limit * (1 + 1e-12));
  EXPECT_GE(highest(mass, equilibrium.intact()), 0.3 * limit) << "or it would be slower than it need be";
}

INSTANTIATE_TEST_SUITE_P(Treatments, MassOfTheSquare,
                         testing::Values("consistent", "penalty", "augmented_lagrangian"));

TEST(FictitiousMass, RefusesAnIndefiniteBlock) {
  BlockMatrix k(1, {});
  k.add(BlockId{0}, BlockId{0}, -Mat6::Identity());
  EXPECT_THROW(FictitiousMass{k}, std::invalid_argument);
}

/// One block on springs softer than its mass was made for: ω² = soft · 4/1.2.
class Oscillator : public testing::TestWithParam<double> {
 protected:
  static FictitiousMass mass() {
    BlockMatrix k(1, {});
    k.add(BlockId{0}, BlockId{0}, Mat6::Identity());
    return FictitiousMass(k);
  }
  static std::vector<double> residual(const std::vector<double>& d) {
    std::vector<double> out(6);
    for (std::size_t i = 0; i < 6; ++i) out[i] = GetParam() * (d[i] - home);
    return out;
  }
  static constexpr double home = 2;
};

/// Of a single frequency the first stop is the equilibrium.
TEST_P(Oscillator, IsStoppedWhereItsPotentialIsLowest) {
  const FictitiousMass made = mass();
  DampedMotion motion(made, std::vector<double>(6, 0.0));
  int steps = 0;
  while (!motion.move(residual(motion.d()))) ASSERT_LT(++steps, 1000);
  EXPECT_EQ(motion.kinetic_energy(), 0);
  for (const double d : motion.d()) EXPECT_NEAR(d, home, 1e-10 * home);
  const double quarter = 0.5 * std::numbers::pi / std::sqrt(GetParam() * 4 / 1.2);
  EXPECT_NEAR(steps, quarter, 2);
}

/// Central differences keep ½ v·M v + ½ k x_before x_after of a linear spring, x from home.
TEST_P(Oscillator, LosesNoEnergyOnTheWay) {
  const FictitiousMass made = mass();
  DampedMotion motion(made, std::vector<double>(6, 0.0));
  const double omega_squared = GetParam() * 4 / 1.2, start = 0.5 * GetParam() * 6 * home * home;
  for (double before = -home; !motion.move(residual(motion.d()));) {
    const double after = motion.d()[0] - home;
    const double potential = 0.5 * GetParam() * 6 * before * after;
    EXPECT_NEAR(potential + motion.kinetic_energy(), start * (1 - omega_squared / 4), 1e-11 * start);
    before = after;
  }
}

INSTANTIATE_TEST_SUITE_P(Softness, Oscillator, testing::Values(1.0, 0.3, 0.01, 0.0001));

}  // namespace
}  // namespace dda
