#pragma once

#include <memory>
#include <vector>

#include "meshing/assembly.hpp"
#include "models/material/material.hpp"

namespace dda {

/// Blocks with thickness and material: what loads act on.
struct Body {
  const Assembly& assembly;
  double thickness;                                        ///< [L]
  std::vector<std::shared_ptr<const Material>> materials;  ///< by region

  const Block& block(BlockId id) const { return assembly.blocks[id.value()]; }
  const Material& material(BlockId id) const {
    return *materials[static_cast<std::size_t>(block(id).region)];
  }
  double volume(BlockId id) const { return block(id).moments.area * thickness; }
  /// Largest Young's modulus of the body [F/L²].
  double largest_modulus() const;
};

}  // namespace dda
