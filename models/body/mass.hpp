#pragma once

#include <vector>

#include "models/body/body.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// M = ∫ TᵀT dV of each block, 6 × 6, for a density of one: what makes eigenvalues independent of the unit of
/// length, K φ = μ M φ with μ in [F/L⁴]·[1/density].
std::vector<Mat6> unit_mass(const Body& body);

}  // namespace dda
