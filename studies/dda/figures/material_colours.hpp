#pragma once

#include <string>
#include <vector>

#include "framework/figure/drawing.hpp"
#include "meshing/assembly.hpp"

namespace dda {

/// Which tint the blocks of each region get in figures and in the report's page: one for each material, in the order of
/// regions.
struct MaterialColours {
  std::vector<std::string> names;  ///< of materials, by tint
  std::vector<int> of_region;

  int of(const Block& block) const { return of_region[static_cast<std::size_t>(block.region)]; }
};

/// From the material of each region.
MaterialColours material_colours(const std::vector<std::string>& of_regions);
MaterialColours material_colours(const Assembly& assembly);

/// Tells in a drawing's legend which material is which.
void add_to_key(const MaterialColours& colours, svg::Drawing& drawing);
/// The same where there are several, beside what a drawing is about.
void explain(const MaterialColours& colours, svg::Drawing& drawing);

}  // namespace dda
