#pragma once

#include "meshing/assembly.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// Trace constant of a block with constant stress, exact for any polygon and any elasticity [F/L³].
///
///     c = max over σ of  ∮ |σ n|² ds / (A σ : C⁻¹ : σ)
///
/// the largest eigenvalue of a 3 × 3 symmetric pencil. The consistent interface is stable for k > ½ c.
double trace_constant(const Block& block, const Mat3& stiffness);

/// The same of a straight line of this normal through the block [F/L³].
///
///     c_Γ = max over σ of  |Γ| |σ n|² / (A σ : C⁻¹ : σ) = |Γ|/A · largest eigenvalue of N C Nᵀ,   N σ = σ n
double line_trace_constant(double length, const Vec2& normal, double area, const Mat3& stiffness);

}  // namespace dda
