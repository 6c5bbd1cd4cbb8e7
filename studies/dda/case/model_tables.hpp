#pragma once

#include <vector>

#include "framework/files/results.hpp"
#include "models/body/body.hpp"
#include "models/equilibrium.hpp"
#include "models/parameters.hpp"

namespace dda {

/// What equilibrium, laws and reactions of a run can be checked from, beside its fields and deck: `/model` of
/// fields/mesh.h5. All of it is given; nothing of it is a result.
///
///     side/blocks [n,2], ends [n,4], stiffness k [n], interface [n]     sides between blocks; −1 a bond
///     nobody named load/block [m], dead [m,6], reference [m,6]      forces on d in the last stage: dead + λ
///     reference; without
///                                                      what initial stress and springs exert
///     spring/stiffness p̄ [s], dead, reference [s]      far ends δ(λ) of supports and driven points; names of
///     reactions spring_part/spring, block [r], row [r,6]         l · u of spring s = Σ row · d_block
///     interface_names, region_materials                               texts, by index
///     initial_stress/dead, reference [blocks,3]        where there is any
std::vector<ResultsTable> model_tables(const Body& body, const ModelParameters& model,
                                       const Equilibrium& equilibrium);

}  // namespace dda
