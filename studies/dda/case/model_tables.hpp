#pragma once

#include <vector>

#include "framework/files/run/results.hpp"
#include "models/body/body.hpp"
#include "models/equilibrium/equilibrium.hpp"
#include "models/parameters.hpp"

namespace dda {

/// What equilibrium, laws and reactions of a run can be checked from, beside its fields and deck: `/model` of
/// fields/mesh.h5. All of it is given; nothing of it is a result.
///
///     side/blocks [n,2], ends [n,4], stiffness k [n]   sides between blocks, as they are without cuts
///          interface [n]                               −1 a bond that nobody named
///     load/block [m], dead [m,6], reference [m,6]      forces on d in the followed stage: dead + λ reference;
///                                                      without what initial stress and springs exert
///     followed_stages [f]                              numbers in the deck, from 1, of those that are followed, where these
///                                                      are several; of all but the first, N, there is `reference_N`
///                                                      wherever there is `reference`: dead + Σ λ_N reference_N
///     spring/stiffness p̄ [s], dead, reference [s]      far ends δ(λ) of supports and driven points;
///            names [s]                                 of reactions
///     spring_part/spring, block [r], row [r,6]         l · u of spring s = Σ row · d_block
///     interface_names, region_materials                               texts, by index
///     initial_stress/dead, reference [blocks,3]        where there is any
///     initial_stress_slopes/dead, reference [gradients,6]   along x and along y, times the square root of the area
std::vector<ResultsTable> model_tables(const Body& body, const ModelParameters& model,
                                       const Equilibrium& equilibrium);

/// The material of each region, which a motion has as well.
ResultsTable region_materials(const Assembly& assembly);

/// The same of the cuts that there are at a step, in the order in which they came: tables in the step's own file.
///
///     cuts/ends [c,4], block, crack, is_provisional [c]
///          side [c]                                    along which it runs; −1 through its block
///          stiffness k, interface [c]
///          dead, reference [c,3]                       forces on the jump e of a cut through a block
///          spring_part/spring, cut [r], row [r,3]      adds Σ row · e to l · u of spring s
///     parts/moves [k,2]                                (part, cut): the part moves by the jump of the cut,
///                                                      J(x) e of models/body/motion.hpp, beside its block
///     cracks/cut, crack, is_provisional [pieces]
std::vector<ResultsTable> cut_tables(const Body& body, const ModelParameters& model,
                                     const Equilibrium& equilibrium);

}  // namespace dda
