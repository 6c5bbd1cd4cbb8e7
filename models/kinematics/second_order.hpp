#pragma once

#include "models/kinematics/first_order.hpp"

namespace dda {

/// What a block of second order has beside the six unknowns of first order: the gradient of its strain, in a node of
/// its own. With it the strain is the complete linear field about the centroid; the mean strain stays (εx, εy, γxy).
///
///     g = a (εx,x  εx,y  εy,x  εy,y  γ,x  γ,y)        [1], a² the area of the block
///     u = T d + (εx,x X²/2 + εx,y XY + (γ,y − εy,x) Y²/2)
///     v = T d + (εy,x XY + εy,y Y²/2 + (γ,x − εx,y) X²/2)
///
/// Any linear strain is compatible, so that these six are all. The factor a keeps the unknowns comparable with strains.
///
/// Displacement of a point by g, 2 × 6 [L]; offset = (X, Y).
Mat26 gradient_displacement_rows(const Vec2& offset, double size);
/// Strain at a point by g, 3 × 6.
Mat36 gradient_strain_rows(const Vec2& offset, double size);
/// Rotation ½ (v,x − u,y) of a point by g, 1 × 6.
Vec6 gradient_rotation_row(const Vec2& offset, double size);
/// K of g by the strain energy ½ g·K g of a unit of thickness: C ⊗ S/a², S the second moments of the block [F].
Mat6 gradient_stiffness(const Mat3& stiffness, const Mat2& second_moments, double area);

}  // namespace dda
