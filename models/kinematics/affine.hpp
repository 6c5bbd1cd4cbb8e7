#pragma once

#include "models/kinematics/first_order.hpp"

namespace dda {

/// Where a block of constant strain is, whatever its rotation: x(X) = c + F X, X from the undeformed centroid.
///
///     y = (c_x, c_y, F11, F12, F21, F22)        [L, L, 1, 1, 1, 1]
///
/// The same six numbers as d = (u0, v0, r0, εx, εy, γxy), of which they are the finite form.
using Pose = Vec6;

inline Vec2 centre_of(const Pose& y) { return y.head<2>(); }
inline Mat2 gradient_of(const Pose& y) { return (Mat2() << y[2], y[3], y[4], y[5]).finished(); }
inline Pose pose_of(const Vec2& c, const Mat2& f) {
  return (Pose() << c, f(0, 0), f(0, 1), f(1, 0), f(1, 1)).finished();
}
/// x(X) = N y.
inline Mat26 affine_rows(const Vec2& offset) {
  Mat26 out = Mat26::Zero();
  out.leftCols<2>().setIdentity();
  out.block<1, 2>(0, 2) = offset.transpose();
  out.block<1, 2>(1, 4) = offset.transpose();
  return out;
}
inline Vec2 place_of(const Pose& y, const Vec2& offset) {
  return {y[0] + y[2] * offset.x() + y[3] * offset.y(), y[1] + y[4] * offset.x() + y[5] * offset.y()};
}

/// The pose of first-order unknowns: c = X0 + (u0, v0), F = R(r0) (I + ε).
Pose finite_pose(const Vec2& centroid, const Vec6& d);
/// What a row of forces or of a displacement in d (work-conjugate or dual to d) is in y: the same forces at the same
/// material points. Exact, since either is made of a force and its four moments about the centroid.
Vec6 finite_row(const Vec6& row);

/// A velocity of the centroid and a spin.
struct RigidMotion {
  Vec2 velocity = Vec2::Zero();  ///< [L/T]
  double spin = 0;               ///< [1/T]
};
/// The rate ẏ of a pose that moves so, and the rigid part of any rate: its centroid's, and the skew part of Ḟ F⁻¹.
Pose rate_of(const Pose& y, const RigidMotion& motion);
RigidMotion rigid_part(const Pose& y, const Pose& rate);

/// F = R(angle) stretch, stretch symmetric.
struct Polar {
  double angle = 0;  ///< in (−π, π]
  Mat2 stretch = Mat2::Identity();
};
Polar polar_of(const Mat2& f);
Mat2 rotation(double angle);

/// The inertia and the stiffness of a block.
struct AffineBlock {
  double mass = 0;                     ///< m [M]
  Mat2 inertia = Mat2::Zero();         ///< J = ∫ X Xᵀ dm [M L²]
  double volume = 0;                   ///< [L³]
  Mat3 stiffness = Mat3::Zero();       ///< C [F/L²]
  Vec3 initial_stress = Vec3::Zero();  ///< S₀, there without strain, turning with the block [F/L²]

  /// M y: m c, and J F by rows.
  Vec6 times_mass(const Vec6& y) const;
  /// M⁻¹ f.
  Vec6 over_mass(const Vec6& f) const;
  Mat6 mass_matrix() const;
};

/// The rigid motion with the momentum and the angular momentum of a rate: ω = ∫ (F X) × (Ḟ X) dm / (F J : F). A rate of
/// shear has some of the latter where J is not round.
RigidMotion rigid_motion_of(const AffineBlock& block, const Pose& y, const Pose& rate);

/// Strain (E11, E22, 2 E12) of E = ½ (FᵀF − I), and its derivative, 3 × 6.
Vec3 green_strain(const Pose& y);
Mat36 green_strain_rows(const Pose& y);

/// V = V_block (½ E:C:E + S₀:E): the energy of small strains, the same at any rotation.
struct StrainEnergy {
  double value = 0;               ///< [F L]
  Vec6 gradient = Vec6::Zero();   ///< ∂V/∂y
  Mat6 curvature = Mat6::Zero();  ///< ∂²V/∂y² with the semidefinite part of what compression takes off
};
StrainEnergy strain_energy(const AffineBlock& block, const Pose& y);
/// V (½ E·C E + S₀·E) of a Green strain E [F L].
double strain_energy_of(const AffineBlock& block, const Vec3& green_strain);
/// Its gradient alone.
Vec6 strain_forces(const AffineBlock& block, const Pose& y);

}  // namespace dda
