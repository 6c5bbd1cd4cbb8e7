#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "continuation/linear/linear_system.hpp"
#include "support/cracked.hpp"
#include "support/cut_structure.hpp"
#include "support/dense.hpp"
#include "support/ranks.hpp"

namespace dda {
namespace {

using Pairs = std::vector<std::pair<BlockId, BlockId>>;

/// A symmetric matrix of blocks; the diagonal is shifted by `shift`, so that 20 makes it definite.
BlockMatrix random_matrix(std::size_t blocks, const Pairs& pairs, double shift, Random& random) {
  BlockMatrix out(blocks, pairs);
  const auto block = [&] {
    Mat6 m;
    for (int i = 0; i < 36; ++i) m(i) = random.between(-1, 1);
    return m;
  };
  for (std::size_t i = 0; i < blocks; ++i) {
    const Mat6 m = block();
    out.add(BlockId{i}, BlockId{i}, m + m.transpose() + shift * Mat6::Identity());
  }
  for (const auto& [i, j] : pairs) {
    const Mat6 m = block();
    out.add(i, j, m);
    out.add(j, i, m.transpose());
  }
  return out;
}

const std::string shared = "shared";

std::vector<std::string> solvers() {
  std::vector<std::string> out = names_of(direct_solvers());
  out.push_back(shared);
  return out;
}

class SolverContract : public testing::TestWithParam<std::string> {
 protected:
  /// A solver by its name; `shared` is `cholmod` on three ranks.
  static DirectSolverChoice choice() {
    return direct_solvers().choose(GetParam() == shared ? "cholmod" : GetParam());
  }
  std::unique_ptr<DirectSolver> make() { return choice().make(); }
  void SetUp() override {
    if (GetParam() == shared) ranks_.emplace(3);
  }
  static Pairs chain(std::size_t blocks) {
    Pairs out;
    for (std::size_t i = 0; i + 1 < blocks; ++i) out.emplace_back(BlockId{i}, BlockId{i + 1});
    return out;
  }
  /// Factorises, solves for three columns, and looks at the residuals and at the inertia.
  void expect_solves(DirectSolver& solver, const BlockMatrix& a) {
    ASSERT_TRUE(solver.factor(a));
    const Eigen::MatrixXd full = dense(a);
    const auto n = full.rows();
    const std::vector<double> right = random_.vector(static_cast<std::size_t>(3 * n), 1);
    std::vector<double> x = right;
    solver.solve(x, 3);
    const Eigen::Map<const Eigen::MatrixXd> b(right.data(), n, 3), found(x.data(), n, 3);
    EXPECT_LT((full * found - b).norm(), 1e-12 * full.norm() * found.norm());
    EXPECT_GT(solver.factor_flops(), 0);
    if (solver.num_negative_pivots() >= 0) {
      const auto values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full).eigenvalues();
      EXPECT_EQ(solver.num_negative_pivots(), (values.array() < 0).count());
    }
  }
  /// Of whole blocks, and of blocks that are cut.
  static std::vector<Equilibrium> equilibria() {
    std::vector<Equilibrium> out;
    out.push_back(Structure(square_deck()).equilibrium());
    CutStructure cut({.subdivision = "{type: voronoi, blocks: 20, seed: 3}", .support_stiffness = 1e3});
    EXPECT_GE(cut.cut_straight({11.3, 0}, {0.07, 1}) + cut.cut_straight({12.1, 0}, {0.05, 1}, 1), 4);
    out.push_back(cut.equilibrium());
    return out;
  }
  Random random_{25};
  std::optional<WithRanks> ranks_;
};

TEST_P(SolverContract, SolvesDefiniteAndIndefiniteSystems) {
  const auto solver = make();
  expect_solves(*solver, random_matrix(9, chain(9), 20, random_));
  expect_solves(*solver, random_matrix(9, chain(9), 0, random_));
  expect_solves(*solver, random_matrix(9, chain(9), -20, random_));
}

TEST_P(SolverContract, TakesAnotherPattern) {
  const auto solver = make();
  expect_solves(*solver, random_matrix(4, chain(4), 20, random_));
  expect_solves(*solver, random_matrix(4, {{BlockId{0}, BlockId{3}}}, 20, random_));
  expect_solves(*solver, random_matrix(11, chain(11), 0, random_));
}

TEST_P(SolverContract, SaysThatAMatrixIsSingular) {
  const auto solver = make();
  BlockMatrix a(3, chain(3));
  for (const std::size_t i : {0, 2}) a.add(BlockId{i}, BlockId{i}, Mat6::Identity());
  EXPECT_FALSE(solver->factor(a));
  expect_solves(*solver, random_matrix(3, chain(3), 20, random_));
}

/// K0 + Bᵀ W (D − D0) B written out.
Eigen::MatrixXd dense_tangent(const Equilibrium& equilibrium, const std::vector<Mat2>& tangents) {
  Eigen::MatrixXd k = dense(equilibrium.intact());
  for (std::size_t p = 0; p < tangents.size(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, k.cols());
    point.for_each_part([&](BlockId part, const Mat26& of_part) {
      rows.middleCols<6>(static_cast<Eigen::Index>(6 * part.value())) += of_part;
    });
    const Mat2 change = tangents[p] - Mat2(point.intact_stiffness().asDiagonal());
    k += point.weight * rows.transpose() * change * rows;
  }
  return k;
}

/// The square under each treatment of its cracks.
std::string treated_square(const std::string& treatment) {
  return square_deck(
      "", "  joint: {between: [mortar, stone], treatment: " + treatment +
              ", law: {type: linear_softening, tensile_strength: 0.01, fracture_energy: 0.0002}}\n");
}

/// Tangents of sliding points: the shear follows the pressure, D is not symmetric.
TEST_P(SolverContract, UnsymmetricTangentsAreSolvedAsWrittenOut) {
  for (const std::string treatment : {"consistent", "penalty", "lagrange", "augmented_lagrangian"}) {
    const Structure structure(treated_square(treatment));
    const Equilibrium equilibrium = structure.equilibrium();
    const auto choice = SolverContract::choice();
    LinearSystem updated(equilibrium, choice, LinearSystem::Update::low_rank);
    LinearSystem factorised(equilibrium, choice, LinearSystem::Update::refactorise);
    for (int round = 1; round < 8; ++round) {
      std::vector<Mat2> tangents;
      for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
        Mat2 d = equilibrium.point(p).intact_stiffness().asDiagonal();
        if (random_.between(0, 6) < round) d.row(1) << random_.between(-0.6, 0.6) * d(0, 0), 0.1 * d(1, 1);
        tangents.push_back(d);
      }
      const std::vector<double> b = random_.vector(equilibrium.num_unknowns(), 1);
      const Eigen::MatrixXd k = dense_tangent(equilibrium, tangents);
      const Eigen::VectorXd expected = k.fullPivLu().solve(vec(b));
      std::vector<double> x(b.size());
      for (LinearSystem* system : {&updated, &factorised}) {
        ASSERT_TRUE(system->set_tangent(tangents));
        system->solve(b, x);
        EXPECT_LT((vec(x) - expected).norm(), 1e-8 * expected.norm()) << treatment << ", round " << round;
        std::vector<double> back(b.size());
        system->multiply(x, back);
        EXPECT_LT((vec(back) - k * vec(x)).norm(), 1e-12 * k.norm() * vec(x).norm()) << treatment;
      }
    }
  }
}

/// A square of 64 blocks, every joint of which can crack.
constexpr const char* many_joints = R"(
scene:
  regions: [{material: stone, vertices: [[0, 0], [1, 0], [1, 1], [0, 1]]}]
  boundaries: {left: [[0, 0], [0, 1]], right: [[1, 0], [1, 1]]}
  subdivision: {type: grid, columns: 8, rows: 8}
thickness: 1
materials: {stone: {type: linear_elastic, young_modulus: 3, poisson_ratio: 0.3}}
interfaces:
  any:
    between: [stone, stone]
    law: {type: mohr_coulomb, tensile_strength: 0.01, cohesion: 0.02, friction_angle: 30}
supports: {wall: {boundary: left, fix: xy}}
stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]
)";

TEST_P(SolverContract, ATangentThatMostlySlidesIsTheBase) {
  const Structure structure(many_joints);
  const Equilibrium equilibrium = structure.equilibrium();
  const auto choice = SolverContract::choice();
  LinearSystem system(equilibrium, choice, LinearSystem::Update::low_rank);
  const std::vector<double> b = random_.vector(equilibrium.num_unknowns(), 1);
  const auto tangents = [&](double sliding) {
    std::vector<Mat2> out;
    for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
      out.emplace_back(equilibrium.point(p).intact_stiffness().asDiagonal());
      if (random_.between(0, 1) < sliding)
        out.back().row(1) << -0.5 * out.back()(0, 0), 0.1 * out.back()(1, 1);
    }
    return out;
  };
  for (const auto& [sliding, updates] : {std::pair(0.02, true), {0.9, false}, {0.95, false}, {0.0, true}}) {
    const std::vector<Mat2> now = tangents(sliding);
    ASSERT_TRUE(system.set_tangent(now));
    EXPECT_EQ(system.updates(), updates) << sliding;
    std::vector<double> x(b.size()), y(b.size());
    system.solve(b, x);
    const Eigen::VectorXd expected = dense_tangent(equilibrium, now).fullPivLu().solve(vec(b));
    EXPECT_LT((vec(x) - expected).norm(), 1e-9 * expected.norm()) << sliding;
    LinearSystem restored(equilibrium, choice, LinearSystem::Update::low_rank);
    ASSERT_TRUE(restored.restore(system.base()));
    restored.restore_columns(system.updated_points());
    ASSERT_TRUE(restored.set_tangent(now));
    restored.solve(b, y);
    EXPECT_EQ(x, y) << "as after a restart, " << sliding;
  }
}

/// An iterate that leads nowhere, in which blocks have come off that the reference load does not move, may make a new base:
/// it costs the tangents that follow no digit.
TEST_P(SolverContract, WhatHasComeLooseInAnIterateIsHeldByTheBase) {
  const Structure structure(many_joints);
  const Equilibrium equilibrium = structure.equilibrium();
  LinearSystem system(equilibrium, choice(), LinearSystem::Update::low_rank);
  std::vector<Mat2> intact;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p)
    intact.emplace_back(equilibrium.point(p).intact_stiffness().asDiagonal());
  std::vector<Mat2> loose = intact, softens = intact;
  const BlockId free = structure.assembly().sides[equilibrium.point(0).side].first;
  for (std::size_t p = 0; p < intact.size(); ++p) {
    const Side& side = structure.assembly().sides[equilibrium.point(p).side];
    if (side.first == free || side.second == free || p % 2 == 0) loose[p].setZero();
  }
  softens[0] *= -1e-2;
  system.set_tangent(loose);
  EXPECT_GT(system.num_factorisations(), 1u);
  ASSERT_TRUE(system.set_tangent(softens));
  const std::vector<double> b = random_.vector(equilibrium.num_unknowns(), 1);
  std::vector<double> x(b.size());
  system.solve(b, x);
  const Eigen::VectorXd expected = dense_tangent(equilibrium, softens).fullPivLu().solve(vec(b));
  EXPECT_LT((vec(x) - expected).norm(), 1e-9 * expected.norm());
}

/// Random tangents: softening, released and intact points, then more and more of them.
TEST_P(SolverContract, LowRankUpdatesEqualNewFactorisations) {
  for (const Equilibrium& equilibrium : equilibria()) {
    const auto choice = SolverContract::choice();
    LinearSystem updated(equilibrium, choice, LinearSystem::Update::low_rank);
    LinearSystem factorised(equilibrium, choice, LinearSystem::Update::refactorise);
    for (int round = 0; round < 12; ++round) {
      std::vector<Mat2> tangents;
      for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
        const Vec2 stiffness = equilibrium.point(p).trial_stiffness();
        Mat2 d = stiffness.asDiagonal();
        if (random_.between(0, 12) < round) {
          const Vec2 e = random_.point(1);
          d = random_.between(0, 1) * d - random_.between(0, 0.3) * stiffness.x() * e * e.transpose();
        }
        tangents.push_back(d);
      }
      ASSERT_TRUE(updated.set_tangent(tangents));
      ASSERT_TRUE(factorised.set_tangent(tangents));
      const std::vector<double> b = random_.vector(equilibrium.num_unknowns(), 1);
      std::vector<double> x(b.size()), y(b.size()), back(b.size());
      updated.solve(b, x);
      factorised.solve(b, y);
      EXPECT_LT((vec(x) - vec(y)).norm(), 1e-10 * vec(y).norm()) << "round " << round;
      updated.multiply(x, back);
      EXPECT_LT((vec(back) - vec(b)).norm(), 1e-8 * vec(b).norm());
    }
    EXPECT_EQ(updated.num_factorisations(), 1u);
    EXPECT_GT(factorised.num_factorisations(), 5u);
  }
}

/// Negative eigenvalues of a tangent with more and more softening points, counted in the small matrix and in
/// all.
TEST_P(SolverContract, InertiaOfUpdatesEqualsThatOfTheWholeMatrix) {
  for (const Equilibrium& equilibrium : equilibria()) {
    LinearSystem updated(equilibrium, choice(), LinearSystem::Update::low_rank);
    int most = 0;
    for (int round = 0; round < 12; ++round) {
      std::vector<Mat2> tangents;
      for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
        Mat2 d = equilibrium.point(p).intact_stiffness().asDiagonal();
        const Vec2 e = random_.point(1);
        if (random_.between(0, 12) < round)
          d = random_.between(0, 1) < 0.2 ? Mat2(2 * d)
                                          : Mat2(-random_.between(0, 3) * d(0, 0) * e * e.transpose());
        tangents.push_back(d);
      }
      ASSERT_TRUE(updated.set_tangent(tangents));
      const Eigen::MatrixXd k = dense_tangent(equilibrium, tangents);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> whole(k, Eigen::EigenvaluesOnly);
      const auto expected = static_cast<int>((whole.eigenvalues().array() < 0).count());
      const auto found = updated.negative_eigenvalues().of_stiffness;
      if (!found) {
        EXPECT_EQ(GetParam(), "amesos2") << "the one solver that does not tell";
        return;
      }
      EXPECT_EQ(*found, expected) << "round " << round;
      most = std::max(most, expected);
    }
    EXPECT_GE(most, 2);
  }
}

/// The same where sliding points make the tangent unsymmetric, beside a symmetric base and as the base.
TEST_P(SolverContract, UnsymmetricTangentsAreCounted) {
  const Structure structure(square_deck());
  const Equilibrium equilibrium = structure.equilibrium();
  for (const auto update : {LinearSystem::Update::low_rank, LinearSystem::Update::refactorise}) {
    LinearSystem linear(equilibrium, choice(), update);
    int stable = 0, negative = 0;
    for (int round = 0; round < 24; ++round) {
      std::vector<Mat2> tangents;
      for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
        Mat2 d = equilibrium.point(p).intact_stiffness().asDiagonal();
        if (p % 3 == 0) d(1, 0) = random_.between(-0.3, 0.3) * d(0, 0);
        if (p % 7 == 0 && random_.between(0, 24) < round) d(0, 0) *= -random_.between(0, 1);
        tangents.push_back(d);
      }
      ASSERT_TRUE(linear.set_tangent(tangents));
      EXPECT_FALSE(linear.has_symmetric_tangent());
      const auto found = linear.negative_eigenvalues();
      if (!found.of_symmetric_part) {
        EXPECT_EQ(GetParam(), "amesos2") << "the one solver that does not tell";
        return;
      }
      const Eigen::MatrixXd k = dense_tangent(equilibrium, tangents);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> symmetric(k + k.transpose(),
                                                                     Eigen::EigenvaluesOnly);
      EXPECT_EQ(*found.of_symmetric_part, (symmetric.eigenvalues().array() < 0).count()) << "round " << round;
      if (*found.of_symmetric_part < 2) {
        EXPECT_TRUE(found.of_stiffness) << "round " << round;
      }
      if (!found.of_stiffness) continue;
      const auto lu = k.partialPivLu();
      const double sign = lu.matrixLU().diagonal().cwiseSign().prod();
      const bool is_odd = static_cast<double>(lu.permutationP().determinant()) * sign < 0;
      EXPECT_EQ(*found.of_stiffness % 2 == 1, is_odd) << "round " << round;
      stable += *found.of_stiffness == 0;
      negative += *found.of_stiffness > 0;
    }
    EXPECT_GT(stable, 2);
    EXPECT_GT(negative, 2);
  }
}

TEST_P(SolverContract, MemoryIsPredictedWithoutFactorising) {
  const Structure structure(square_deck());
  const Equilibrium equilibrium = structure.equilibrium();
  const std::unique_ptr<DirectSolver> solver = make();
  const double stored = 36.0 * sizeof(double) * static_cast<double>(equilibrium.intact().num_stored()) / 2;
  EXPECT_GT(solver->factor_bytes(equilibrium.intact()), stored);
  EXPECT_LT(solver->factor_bytes(equilibrium.intact()), 1e3 * stored);
  EXPECT_TRUE(solver->factor(equilibrium.intact()));
}

INSTANTIATE_TEST_SUITE_P(Registry, SolverContract, testing::ValuesIn(solvers()),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
