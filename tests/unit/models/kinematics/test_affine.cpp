#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "models/kinematics/affine.hpp"

namespace dda {
namespace {

AffineBlock block() {
  AffineBlock out;
  out.mass = 3;
  out.inertia << 0.4, 0.1, 0.1, 0.3;
  out.volume = 2;
  out.stiffness << 10, 2, 0.5, 2, 8, 0.3, 0.5, 0.3, 4;
  return out;
}

Pose pose_near(double angle, double strain, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-strain, strain);
  Mat2 stretch = Mat2::Identity();
  for (double& value : stretch.reshaped()) value += part(random);
  return pose_of({0.3, -0.2}, rotation(angle) * stretch);
}

TEST(Affine, GivesSmallDisplacementsOfTheSameUnknowns) {
  const Vec2 centroid(3, 4), offset(0.7, -0.4);
  Vec6 d;
  d << 1, -2, 0.5, 0.3, -0.2, 0.4;
  for (const double size : {1e-3, 1e-4}) {
    const Pose y = finite_pose(centroid, size * d);
    const Vec2 moved = place_of(y, offset) - centroid - offset;
    EXPECT_LT((moved - size * (displacement_rows(offset) * d)).norm(), 2 * size * size);
  }
}

TEST(Affine, ForcesAtMaterialPointsAreTheSameRows) {
  const Vec2 offset(0.7, -0.4), force(2, 5);
  const Vec6 of_unknowns = displacement_rows(offset).transpose() * force;
  EXPECT_LT((finite_row(of_unknowns) - affine_rows(offset).transpose() * force).norm(), 1e-15);
}

TEST(Affine, TakesARotationApart) {
  for (const double angle : {-3.1, -1.0, 0.0, 0.4, 3.1}) {
    Mat2 stretch;
    stretch << 1.1, 0.05, 0.05, 0.93;
    const Polar polar = polar_of(rotation(angle) * stretch);
    EXPECT_NEAR(polar.angle, angle, 1e-14);
    EXPECT_LT((polar.stretch - stretch).norm(), 1e-14);
  }
}

/// Of a rigid motion itself; of a shear, which turns a body whose inertia is not round, what keeps its angular momentum.
TEST(Affine, ARigidMotionHasTheMomentaOfARate) {
  const AffineBlock of = block();
  const Pose y = pose_near(0.7, 0.05, 1);
  const RigidMotion motion{{2, -1}, 0.3};
  EXPECT_NEAR(rigid_motion_of(of, y, rate_of(y, motion)).spin, motion.spin, 1e-14);
  Mat2 rate;
  rate << 0.2, 0.5, -0.1, 0.4;
  const Pose moves = pose_of({1, 1}, rate), rigid = rate_of(y, rigid_motion_of(of, y, moves));
  const Mat2 f = gradient_of(y);
  const auto angular = [&](const Pose& v) {
    const Mat2 m = f * of.inertia * gradient_of(v).transpose();
    return m(0, 1) - m(1, 0);
  };
  EXPECT_NEAR(angular(rigid) / angular(moves), 1, 1e-12);
  EXPECT_EQ(centre_of(rigid), centre_of(moves));
}

TEST(Affine, StrainEnergyHasItsGradientAndCurvature) {
  const AffineBlock of = block();
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Pose y = pose_near(0.7 * seed, 0.05, seed);
    const StrainEnergy here = strain_energy(of, y);
    Mat6 by_difference;
    for (int i = 0; i < 6; ++i) {
      constexpr double h = 1e-6;
      const StrainEnergy more = strain_energy(of, y + h * Pose::Unit(i)),
                         less = strain_energy(of, y - h * Pose::Unit(i));
      EXPECT_NEAR((more.value - less.value) / (2 * h), here.gradient[i], 1e-7);
      by_difference.col(i) = (more.gradient - less.gradient) / (2 * h);
    }
    // What compression takes off is left out: never less than the exact one.
    Eigen::SelfAdjointEigenSolver<Mat6> more(here.curvature -
                                             (by_difference + by_difference.transpose()) / 2);
    EXPECT_GT(more.eigenvalues().minCoeff(), -1e-6);
    Eigen::SelfAdjointEigenSolver<Mat6> own(here.curvature);
    EXPECT_GT(own.eigenvalues().minCoeff(), -1e-9);
  }
}

TEST(Affine, StrainEnergyKnowsNoRotation) {
  const AffineBlock of = block();
  const Pose y = pose_near(0.2, 0.05, 7);
  const Pose turned = pose_of(centre_of(y), rotation(1.3) * gradient_of(y));
  EXPECT_NEAR(strain_energy(of, turned).value, strain_energy(of, y).value, 1e-14);
}

}  // namespace
}  // namespace dda
