#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <set>

#include "support/structure.hpp"

namespace dda {
namespace {

/// The square with one joint of Lagrange multipliers that may crack and two that are bonds.
Structure square(const std::string& points = "gauss") {
  const std::string treatment =
      ", points: " + points + ", treatment: {type: lagrange, perturbation: 1e-6}}\n";
  return Structure(
      square_deck("",
                  "  joint: {between: [mortar, stone], law: {type: linear_softening, tensile_strength: 0.01, "
                  "fracture_energy: 0.0002, shear_weight: 0.8}" +
                      treatment + "  inner: {between: [mortar, mortar]" + treatment));
}

Eigen::Map<const Eigen::VectorXd> vec(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

Eigen::MatrixXd intact_stiffness(const Equilibrium& equilibrium) {
  const auto n = static_cast<Eigen::Index>(equilibrium.num_unknowns());
  Eigen::MatrixXd k(n, n);
  for (Eigen::Index c = 0; c < n; ++c) {
    std::vector<double> unit(static_cast<std::size_t>(n), 0.0), product(unit);
    unit[static_cast<std::size_t>(c)] = 1;
    equilibrium.intact().multiply_add(unit, product);
    k.col(c) = vec(product);
  }
  return k;
}

TEST(Multipliers, AreTwoUnknownsOfEachPointBehindTheBlocks) {
  for (const auto& [points, per_side] : {std::pair("gauss", 2), std::pair("midpoint", 1)}) {
    const Structure structure = square(points);
    const Equilibrium equilibrium = structure.equilibrium();
    EXPECT_EQ(equilibrium.num_blocks(), 4u);
    EXPECT_EQ(equilibrium.num_nodes(), 4u + 3u) << "one node per side";
    EXPECT_EQ(equilibrium.num_unknowns(), 6u * 7u);
    EXPECT_EQ(equilibrium.num_active(), 2u * static_cast<std::size_t>(per_side)) << "only what may crack";
    std::set<std::pair<std::size_t, int>> places;
    for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
      const InterfacePoint& point = equilibrium.point(p);
      if (point.multiplier != Multiplier::unknown) continue;
      EXPECT_GE(point.node.value(), 4u);
      EXPECT_TRUE(places.emplace(point.node.value(), point.column).second) << "a place of its own";
    }
    EXPECT_EQ(places.size(), 3u * static_cast<std::size_t>(per_side));
  }
}

TEST(Multipliers, StiffnessIsSymmetricWithANegativeEigenvaluePerMultiplier) {
  for (const auto& [points, multipliers] : {std::pair("gauss", 12), std::pair("midpoint", 6)}) {
    const Eigen::MatrixXd k = intact_stiffness(square(points).equilibrium());
    EXPECT_LT((k - k.transpose()).norm(), 1e-13 * k.norm());
    const auto values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_EQ((values.array() < 0).count(), multipliers) << points;
    EXPECT_GT(values.cwiseAbs().minCoeff(), 0);
  }
}

/// Room that no multiplier uses has a diagonal of its own and nothing else.
TEST(Multipliers, UnusedUnknownsAreDecoupled) {
  for (const auto& [points, used] : {std::pair("gauss", 4), std::pair("midpoint", 2)}) {
    const Structure structure = square(points);
    const Equilibrium equilibrium = structure.equilibrium();
    const Eigen::MatrixXd k = intact_stiffness(equilibrium);
    for (std::size_t node = 4; node < 7; ++node)
      for (int j = 0; j < 6; ++j) {
        const auto i = static_cast<Eigen::Index>(6 * node) + j;
        const double others = k.row(i).cwiseAbs().sum() - std::abs(k(i, i));
        if (j < used) {
          EXPECT_GT(others, 0.01) << points;
        } else {
          EXPECT_EQ(others, 0) << points;
          EXPECT_GT(k(i, i), 0);
        }
      }
  }
}

/// ∂Π/∂m = W (t(g + m) − (1 + δ) P m), Π the energy of blocks and joints; here of an intact structure.
TEST(Multipliers, ResidualIsGradientOfTheEnergy) {
  const Structure structure = square();
  const Equilibrium equilibrium = structure.equilibrium();
  Random random(9);
  const std::vector<double> d = random.vector(equilibrium.num_unknowns(), 1);
  const Eigen::VectorXd force = intact_stiffness(equilibrium) * vec(d);
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    if (point.multiplier != Multiplier::unknown) continue;
    const auto start = static_cast<Eigen::Index>(6 * point.node.value()) + point.column;
    const Vec2 m = vec(d).segment<2>(start), q = equilibrium.opening(p, d);
    const Vec2 jump =
        point.rows.first * vec(d).segment<6>(static_cast<Eigen::Index>(6 * point.first.value())) +
        point.rows.second * vec(d).segment<6>(static_cast<Eigen::Index>(6 * point.second.value()));
    EXPECT_LT((q - jump - m).norm(), 1e-14);
    const Vec2 expected = point.weight * point.trial_stiffness().cwiseProduct(jump - 1e-6 * m);
    EXPECT_LT((force.segment<2>(start) - expected).norm(), 1e-12 * point.stiffness);
  }
}

TEST(Multipliers, ScatteringIsTheTransposeOfGathering) {
  const Structure structure = square();
  const Equilibrium equilibrium = structure.equilibrium();
  Random random(6);
  const std::size_t n = equilibrium.num_unknowns(), points = 2 * equilibrium.num_active();
  const std::vector<double> d = random.vector(n, 1), t = random.vector(points, 1);
  std::vector<double> q(points), f(n, 0.0);
  equilibrium.gather(d, q);
  equilibrium.scatter_add(t, f);
  double right = 0;
  for (std::size_t i = 0; i < points; ++i) right += equilibrium.point(i / 2).weight * t[i] * q[i];
  EXPECT_NEAR(vec(f).dot(vec(d)), right, 1e-13 * std::abs(right));
}

}  // namespace
}  // namespace dda
