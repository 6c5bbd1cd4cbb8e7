#include "models/kinematics/affine.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace dda {

Pose finite_pose(const Vec2& centroid, const Vec6& d) {
  Mat2 stretch;
  stretch << 1 + d[3], d[5] / 2, d[5] / 2, 1 + d[4];
  return pose_of(centroid + d.head<2>(), rotation(d[2]) * stretch);
}

Vec6 finite_row(const Vec6& row) {
  return (Vec6() << row[0], row[1], row[3], row[5] - row[2] / 2, row[5] + row[2] / 2, row[4]).finished();
}

Pose rate_of(const Pose& y, const RigidMotion& motion) {
  Mat2 turn;
  turn << 0, -motion.spin, motion.spin, 0;
  return pose_of(motion.velocity, turn * gradient_of(y));
}

RigidMotion rigid_part(const Pose& y, const Pose& rate) {
  const Mat2 turning = gradient_of(rate) * gradient_of(y).inverse();
  return {centre_of(rate), (turning(1, 0) - turning(0, 1)) / 2};
}

Mat2 rotation(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Mat2() << c, -s, s, c).finished();
}

Polar polar_of(const Mat2& f) {
  Polar out;
  out.angle = std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));
  const Mat2 stretch = rotation(out.angle).transpose() * f;
  out.stretch = (stretch + stretch.transpose()) / 2;
  return out;
}

Vec6 AffineBlock::times_mass(const Vec6& y) const {
  Vec6 out;
  out << mass * y.head<2>(), inertia * y.segment<2>(2), inertia * y.segment<2>(4);
  return out;
}

Vec6 AffineBlock::over_mass(const Vec6& f) const {
  const Mat2 inverse = inertia.inverse();
  Vec6 out;
  out << f.head<2>() / mass, inverse * f.segment<2>(2), inverse * f.segment<2>(4);
  return out;
}

RigidMotion rigid_motion_of(const AffineBlock& block, const Pose& y, const Pose& rate) {
  const Mat2 f = gradient_of(y), moved = f * block.inertia * gradient_of(rate).transpose();
  return {centre_of(rate), (moved(0, 1) - moved(1, 0)) / (f * block.inertia).cwiseProduct(f).sum()};
}

Mat6 AffineBlock::mass_matrix() const {
  Mat6 out = Mat6::Zero();
  out.block<2, 2>(0, 0).diagonal().setConstant(mass);
  out.block<2, 2>(2, 2) = out.block<2, 2>(4, 4) = inertia;
  return out;
}

Vec3 green_strain(const Pose& y) {
  const Mat2 f = gradient_of(y);
  return {(f.col(0).squaredNorm() - 1) / 2, (f.col(1).squaredNorm() - 1) / 2, f.col(0).dot(f.col(1))};
}

Mat36 green_strain_rows(const Pose& y) {
  Mat36 out = Mat36::Zero();
  out.row(0) << 0, 0, y[2], 0, y[4], 0;
  out.row(1) << 0, 0, 0, y[3], 0, y[5];
  out.row(2) << 0, 0, y[3], y[2], y[5], y[4];
  return out;
}

Vec6 strain_forces(const AffineBlock& block, const Pose& y) {
  return block.volume * green_strain_rows(y).transpose() *
         (block.stiffness * green_strain(y) + block.initial_stress);
}

double strain_energy_of(const AffineBlock& block, const Vec3& green_strain) {
  const Vec3 stress = block.stiffness * green_strain + block.initial_stress;
  return block.volume / 2 * green_strain.dot(stress + block.initial_stress);
}

StrainEnergy strain_energy(const AffineBlock& block, const Pose& y) {
  const Vec3 strain = green_strain(y), stress = block.stiffness * strain + block.initial_stress;
  const Mat36 rows = green_strain_rows(y);
  StrainEnergy out;
  out.value = strain_energy_of(block, strain);
  out.gradient = block.volume * rows.transpose() * stress;
  out.curvature = block.volume * rows.transpose() * block.stiffness * rows;
  Mat2 tensor;
  tensor << stress[0], stress[2], stress[2], stress[1];
  Eigen::SelfAdjointEigenSolver<Mat2> principal;
  principal.computeDirect(tensor);
  const Mat2 tension = principal.eigenvectors() * principal.eigenvalues().cwiseMax(0).asDiagonal() *
                       principal.eigenvectors().transpose();
  out.curvature.block<2, 2>(2, 2) += block.volume * tension;
  out.curvature.block<2, 2>(4, 4) += block.volume * tension;
  return out;
}

}  // namespace dda
