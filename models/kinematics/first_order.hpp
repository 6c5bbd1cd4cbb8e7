#pragma once

#include <Eigen/Core>

#include "framework/base/vec2.hpp"

namespace dda {

using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat26 = Eigen::Matrix<double, 2, 6>;
using Mat62 = Eigen::Matrix<double, 6, 2>;
using Mat36 = Eigen::Matrix<double, 3, 6>;

/// Number of unknowns of a first-order block.
inline constexpr int block_unknowns = 6;

/// Displacement of a point of a first-order block, u(x) = T(x) d.
///
///     d = (u0, v0, r0, εx, εy, γxy)          [L, L, 1, 1, 1, 1], γxy the engineering shear strain
///     T = [ 1  0  −Y   X   0   Y/2 ]         X = x − x0, Y = y − y0, (x0, y0) the centroid
///         [ 0  1   X   0   Y   X/2 ]
///
/// Source: Pearce et al. (2000), eqs 1-3.
Mat26 displacement_rows(const Vec2& offset_from_centroid);

/// Strain of a first-order block, (εx, εy, γxy) = E d: the same everywhere in the block.
Mat36 strain_rows();

/// Traction on a plane in local components: (n·σ·n, s·σ·n) for σ = (σx, σy, τxy), s = n turned by +90°.
Eigen::Matrix<double, 2, 3> traction_rows(const Vec2& normal);

}  // namespace dda
