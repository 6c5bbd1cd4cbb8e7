#include "studies/dda/figures/material_colours.hpp"

#include <algorithm>

namespace dda {

MaterialColours material_colours(const std::vector<std::string>& of_regions) {
  MaterialColours out;
  for (const std::string& material : of_regions) {
    const auto found = std::ranges::find(out.names, material);
    out.of_region.push_back(static_cast<int>(found - out.names.begin()));
    if (found == out.names.end()) out.names.push_back(material);
  }
  return out;
}

MaterialColours material_colours(const Assembly& assembly) {
  std::vector<std::string> materials;
  for (const Region& region : assembly.regions) materials.push_back(region.material);
  return material_colours(materials);
}

void add_to_key(const MaterialColours& colours, svg::Drawing& drawing) {
  for (std::size_t i = 0; i < colours.names.size(); ++i)
    drawing.key.push_back({svg::KeyEntry::Kind::fill, static_cast<int>(i), colours.names[i]});
}

void explain(const MaterialColours& colours, svg::Drawing& drawing) {
  if (colours.names.size() > 1) add_to_key(colours, drawing);
}

}  // namespace dda
