#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "continuation/motion/energy/clamped_springs.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr int num_bodies = 12, size = 6 * num_bodies;

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

Vec6 any_direction(Random& random) {
  Vec6 out;
  for (double& entry : out) entry = random.between(-1, 1);
  return out;
}

/// A contact, open or closed, or a slider, between two bodies or of one with what is held.
ClampedSpring any_spring(Random& random) {
  ClampedSpring out;
  out.rows = {static_cast<int>(random.between(0, num_bodies)),
              static_cast<int>(random.between(-1, num_bodies))};
  out.along = {any_direction(random), any_direction(random)};
  out.stiffness = random.between(1, 100);
  out.at = random.between(-0.5, 0.5);
  const bool is_contact = random.coin();
  out.low = is_contact ? 0 : -random.between(0, 5);
  out.high = is_contact ? inf : -out.low;
  return out;
}

struct Problem {
  std::vector<ClampedSpring> springs;
  Matrix smooth;  ///< curvature without springs
  Vector load;

  Vector row_of(const ClampedSpring& spring) const {
    Vector out = Vector::Zero(size);
    for (std::size_t side = 0; side < 2; ++side)
      if (spring.rows[side] >= 0) out.segment<6>(6 * spring.rows[side]) += spring.along[side];
    return out;
  }
  Vector gradient(const Vector& z) const {
    Vector out = smooth * z - load;
    for (const ClampedSpring& spring : springs) {
      const Vector row = row_of(spring);
      out += spring.force(row.dot(z)) * row;
    }
    return out;
  }
  Matrix curvature() const {
    Matrix out = smooth;
    for (const ClampedSpring& spring : springs)
      if (spring.state(0) == ClampedSpring::State::within)
        out += spring.stiffness * row_of(spring) * row_of(spring).transpose();
    return out;
  }
};

Problem problem_of(int num_springs) {
  Random random(7);
  Problem out;
  for (int i = 0; i < num_springs; ++i) out.springs.push_back(any_spring(random));
  out.smooth = Matrix::Identity(size, size);
  out.load = Vector::Zero(size);
  for (double& entry : out.load) entry = random.between(-20, 20);
  return out;
}

Vector found(const Problem& problem) {
  const Matrix below = problem.curvature().triangularView<Eigen::Lower>();
  const PositiveFactor::Matrix lower = below.sparseView();
  PositiveFactor factor;
  factor.analyse(lower);
  EXPECT_TRUE(factor.factorise(lower));
  return ClampedMinimum(factor, problem.springs, 48).solve(-problem.gradient(Vector::Zero(size)));
}

TEST(ClampedMinimum, NothingIsLeftOfTheForcesThere) {
  const Problem problem = problem_of(20);
  const Vector b = -problem.gradient(Vector::Zero(size));
  const Vector z = found(problem);
  EXPECT_LT(problem.gradient(z).norm(), 1e-9 * b.norm());
  int changed = 0;
  for (const ClampedSpring& spring : problem.springs)
    changed += spring.state(0) != spring.state(problem.row_of(spring).dot(z));
  EXPECT_GT(changed, 5);
}

TEST(ClampedMinimum, LeadsDownWhereSpringsAreTooMany) {
  const Problem problem = problem_of(400);
  const Vector b = -problem.gradient(Vector::Zero(size));
  const Vector z = found(problem);
  EXPECT_GT(z.dot(b), 0);
  EXPECT_LT(problem.gradient(0.01 * z).dot(z), 0);
}

TEST(ClampedMinimum, IsNewtonsStepWhereNoSpringLeavesItsState) {
  Problem problem = problem_of(20);
  problem.load *= 0;
  for (ClampedSpring& spring : problem.springs) spring.at = 0, spring.low = -1, spring.high = 1;
  problem.load[0] = 1e-3;
  const Vector z = found(problem);
  EXPECT_LT((z - problem.curvature().ldlt().solve(problem.load)).norm(), 1e-12 * z.norm());
}

}  // namespace
}  // namespace dda
