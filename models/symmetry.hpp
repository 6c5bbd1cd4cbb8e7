#pragma once

#include <vector>

#include "models/body/body.hpp"
#include "models/support.hpp"
#include "models/treatment/treatment.hpp"

namespace dda {

/// Planes of symmetry: sides between a block and its mirror image (Side::is_mirror), of which the structure is one half.
///
///     u' = M u,   ε' = M ε M,   M = 1 − 2 n nᵀ        of the image, at the plane
///     q  = (−2 n·u, 0)                                opens twice as far as the block goes away from the plane, never slides
///
/// Its points have half the weight, W/2: the other half of the joint belongs to the image.

/// How the image of a point on the plane moves and strains.
MotionRows mirrored(const MotionRows& rows, const Vec2& normal);

/// What the planes hold of the blocks on them, as springs on n · u at the ends of each side, of stiffness 1.
std::vector<Spring> springs_of_mirrors(const Body& body);

/// What is asked of a plane of symmetry and goes with none: a finding each.
void check_mirrors(const ModelParameters& model, Findings& findings);

}  // namespace dda
