#pragma once

#include "models/treatment/treatment.hpp"

namespace dda {

/// How the mirror image of a point on a plane of symmetry moves and strains: on such a side (Side::is_mirror) it is what a
/// block is joined to.
///
///     u' = M u,   ε' = M ε M,   M = 1 − 2 n nᵀ
///     q  = (−2 n·u, 0)          opens twice as far as the block goes away from the plane, never slides
///
/// The points of the side have half the weight, W/2: the other half of the joint belongs to the image.
MotionRows mirrored(const MotionRows& rows, const Vec2& normal);

}  // namespace dda
