#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meshing/assembly.hpp"
#include "meshing/cracks/crack_geometry.hpp"
#include "models/kinematics/kinematics.hpp"
#include "models/material/material.hpp"

namespace dda {

/// Which blocks are of second order; none where a scene has none.
struct SecondOrderBlocks {
  std::vector<BlockId> blocks;                      ///< in the order of their nodes
  std::vector<std::optional<std::size_t>> numbers;  ///< of every block: its place among them
};

/// Those that a deck's kinematics names. Throws InputError when it names a region that there is not.
SecondOrderBlocks second_order_blocks(const Assembly& assembly, const KinematicsChoice& kinematics);

/// Blocks with thickness and material, and the cracks through them: what loads act on.
///
/// Its nodes, six unknowns each, are the blocks, behind them the strain gradients of blocks of second order, and behind
/// these the jumps across the cuts, which use three.
struct Body {
  const Assembly& assembly;
  double thickness;                                        ///< [L]
  std::vector<std::shared_ptr<const Material>> materials;  ///< by region
  const CrackGeometry* cracks = nullptr;                   ///< none where blocks stay whole
  SecondOrderBlocks second_order = {};
  std::vector<std::string> unused_materials = {};  ///< described, but of no region

  std::size_t num_jumps() const { return cracks ? cracks->num_jumps() : 0; }
  std::size_t num_gradients() const { return second_order.blocks.size(); }
  std::size_t num_nodes() const { return assembly.num_blocks() + num_gradients() + num_jumps(); }
  BlockId node_of(JumpId jump) const {
    return BlockId{assembly.num_blocks() + num_gradients() + jump.value()};
  }
  /// The node of a block's strain gradient; none of a block of first order.
  std::optional<BlockId> gradient_of(BlockId id) const {
    if (second_order.numbers.empty() || !second_order.numbers[id.value()]) return {};
    return BlockId{assembly.num_blocks() + *second_order.numbers[id.value()]};
  }
  /// √area of a block [L].
  double size(BlockId id) const { return std::sqrt(block(id).moments.area); }

  const Block& block(BlockId id) const { return assembly.blocks[id.value()]; }
  const Material& material(BlockId id) const {
    return *materials[static_cast<std::size_t>(block(id).region)];
  }
  double volume(BlockId id) const { return block(id).moments.area * thickness; }
  /// Largest Young's modulus of the body [F/L²].
  double largest_modulus() const;
};

}  // namespace dda
