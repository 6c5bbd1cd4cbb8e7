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
/// The same of a block of second order: over all σ that are linear in the place, by a 9 × 9 pencil,
///
///     c = max over σ of  ∮ |σ n|² ds / ∫ σ : C⁻¹ : σ dA
///
/// two to three times that of constant stress.
double second_order_trace_constant(const Block& block, const Mat3& stiffness);

/// The same of a straight line of this normal through the block [F/L³].
///
///     c_Γ = max over σ of  |Γ| |σ n|² / (A σ : C⁻¹ : σ) = |Γ|/A · largest eigenvalue of N C Nᵀ,   N σ = σ n
double line_trace_constant(double length, const Vec2& normal, double area, const Mat3& stiffness);
/// The same over all linear σ, of the line between two points.
double second_order_line_trace_constant(const Vec2& start, const Vec2& end, const Block& block,
                                        const Mat3& stiffness);

}  // namespace dda
