#pragma once

#include <string>
#include <vector>

#include "meshing/assembly.hpp"

namespace dda {

/// Which tint the blocks of each region get in figures: one for each material, in the order of regions.
struct MaterialColours {
  std::vector<std::string> names;  ///< of materials, by tint
  std::vector<int> of_region;

  int of(const Block& block) const { return of_region[static_cast<std::size_t>(block.region)]; }
};

MaterialColours material_colours(const Assembly& assembly);

}  // namespace dda
