#pragma once

#include <array>
#include <string>
#include <vector>

#include "framework/deck/formula.hpp"
#include "models/body/chosen.hpp"
#include "models/load/load.hpp"

namespace dda {

// What is there without a load: a stress σ0 without strain, or a strain ε0 without stress, which is σ0 = −C ε0.
//
//     σ = C ε + σ0,   f −= V Eᵀ σ0          σ0 by block [F/L²]

/// Three components that may depend on the place, of a stress (xx, yy, xy) or of a strain (xx, yy, γxy).
using Components = std::array<Formula, 3>;

/// Their mean over a block: at once where they are constant, else integrated to 1e-11.
Vec3 mean_over(const Block& block, const Components& components);

/// Adds the stress σ0 of a block to a stage.
void add_eigenstress(StageLoads& stage, const Body& body, BlockId block, const Vec3& stress);

}  // namespace dda
