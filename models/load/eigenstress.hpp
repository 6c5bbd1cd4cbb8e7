#pragma once

#include <array>
#include <span>
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
// In a block of second order σ0 is linear as its strain is, and does work on the strain's gradient too:
//
//     σ0(x) = σ̄0 + (X σ0x + Y σ0y)/a,   f_g −= ∫ Fᵀ σ0 dV          ε = E d + F g, a² the area
//
// What it brings out of the plane does no work.

/// Three components that may depend on the place, of a stress (xx, yy, xy) or of a strain (xx, yy, γxy).
using Components = std::array<Formula, 3>;

/// A linear field about the centroid of a block: its mean, and its slopes along x and y times a.
template <class T>
struct LinearField {
  T mean;
  std::array<T, 2> slopes;
};

/// Of the linear field that is closest to them over a block, ∫ (X, Y) of both the same; without slopes in a block of first
/// order. At once where they are constant, else integrated to 1e-11.
LinearField<Vec3> linear_over(const Body& body, BlockId block, const Components& components);

/// σ0 of a block, and what comes with it out of the plane: a stress in plane strain [F/L²], a strain in plane stress.
struct Eigenstress {
  Vec3 stress;
  double out_of_plane = 0;
};

/// Adds it to a stage.
void add_eigenstress(StageLoads& stage, const Body& body, BlockId block,
                     const LinearField<Eigenstress>& eigenstress);

/// The forces of a σ0 that is kept as StageLoads keeps it: on the blocks and on the gradients of their strains.
std::vector<std::pair<BlockId, Vec6>> forces_of_stress(const Body& body, BlockId block,
                                                       std::span<const Vec3> stress);

/// A place among what StageLoads keeps of σ0, and its share in a sum.
struct StressShare {
  std::size_t place;
  double share;
};
/// What σ0 is at a point of a block: its mean, and behind it in a block of second order what its slopes add.
std::vector<StressShare> eigenstress_at(const Body& body, BlockId block, const Vec2& x);
/// The slopes' alone.
std::vector<StressShare> eigenstress_beside_mean(const Body& body, BlockId block, const Vec2& x);

}  // namespace dda
