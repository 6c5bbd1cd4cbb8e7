#pragma once

#include <memory>
#include <vector>

#include "meshing/assembly.hpp"
#include "meshing/cracks/crack_geometry.hpp"
#include "models/material/material.hpp"

namespace dda {

/// Blocks with thickness and material, and the cracks through them: what loads act on.
///
/// Its nodes, six unknowns each, are the blocks and behind them the jumps across the cuts, which use three.
struct Body {
  const Assembly& assembly;
  double thickness;                                        ///< [L]
  std::vector<std::shared_ptr<const Material>> materials;  ///< by region
  const CrackGeometry* cracks = nullptr;                   ///< none where blocks stay whole

  std::size_t num_jumps() const { return cracks ? cracks->num_jumps() : 0; }
  std::size_t num_nodes() const { return assembly.num_blocks() + num_jumps(); }
  BlockId node_of(JumpId jump) const { return BlockId{assembly.num_blocks() + jump.value()}; }

  const Block& block(BlockId id) const { return assembly.blocks[id.value()]; }
  const Material& material(BlockId id) const {
    return *materials[static_cast<std::size_t>(block(id).region)];
  }
  double volume(BlockId id) const { return block(id).moments.area * thickness; }
  /// Largest Young's modulus of the body [F/L²].
  double largest_modulus() const;
};

}  // namespace dda
