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
//
// What it brings out of the plane does no work.

/// Three components that may depend on the place, of a stress (xx, yy, xy) or of a strain (xx, yy, γxy).
using Components = std::array<Formula, 3>;

/// Their mean over a block: at once where they are constant, else integrated to 1e-11.
Vec3 mean_over(const Block& block, const Components& components);

/// σ0 of a block, and what comes with it out of the plane: a stress in plane strain [F/L²], a strain in plane stress.
struct Eigenstress {
  Vec3 stress;
  double out_of_plane = 0;
};

/// Adds it to a stage.
void add_eigenstress(StageLoads& stage, const Body& body, BlockId block, const Eigenstress& eigenstress);

}  // namespace dda
