#include "studies/dda/figures/material_colours.hpp"

#include <algorithm>

namespace dda {

MaterialColours material_colours(const Assembly& assembly) {
  MaterialColours out;
  for (const Region& region : assembly.regions) {
    const auto found = std::ranges::find(out.names, region.material);
    out.of_region.push_back(static_cast<int>(found - out.names.begin()));
    if (found == out.names.end()) out.names.push_back(region.material);
  }
  return out;
}

}  // namespace dda
