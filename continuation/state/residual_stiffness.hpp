#pragma once

#include <span>

#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// ε, of the tangent of every joint.
inline constexpr double residual_share = 1e-7;

/// ε S, the diagonal of the stiffness that a joint keeps in the path's tangent where it slides or is open, so that what
/// moves freely has a tangent [F/L³]: S is the trial stiffness, but of stiffer joints no more than some times what the
/// blocks beside have, so that what slides does so as freely whatever the treatment.
Vec2 residual_stiffness(const InterfacePoint& point);

/// Σ W q̇ · ε S q̇ of these rates of opening, one per active point: what of λ̇ f · ḋ along a tangent that stiffness takes,
/// all of it where a mechanism moves [FL per square of the tangent's unit].
double residual_power(const Equilibrium& equilibrium, std::span<const Vec2> opening);

}  // namespace dda
