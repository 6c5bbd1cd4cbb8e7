#include "models/body/chosen.hpp"

#include <algorithm>

#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

void require(const std::vector<std::string>& wanted, const std::vector<std::string>& known,
             const std::string& kind, const Position& where) {
  for (const std::string& name : wanted)
    if (!contains(known, name))
      throw InputError(where, "unknown " + kind + " '" + name + "'" + suggest(name, known));
}

/// Of what there is, a material that no region is of says nothing.
void refuse_unused(const std::vector<std::string>& wanted, const std::vector<std::string>& unused,
                   const Position& where) {
  for (const std::string& name : wanted)
    if (contains(unused, name))
      throw InputError(where, "no region is of material '" + name +
                                  "', which `materials` describes: leave it out, or give it a region");
}

}  // namespace

void Chosen::require_known(const Body& body, const Position& where) const {
  std::vector<std::string> known_regions, known_materials;
  for (const Region& region : body.assembly.regions) {
    known_regions.push_back(region.name);
    if (!contains(known_materials, region.material)) known_materials.push_back(region.material);
  }
  require(regions, known_regions, "region", where);
  refuse_unused(materials, body.unused_materials, where);
  require(materials, known_materials, "material", where);
}

bool Chosen::has(const Body& body, BlockId block) const {
  const Region& region = body.assembly.regions[static_cast<std::size_t>(body.block(block).region)];
  if (regions.empty() && materials.empty()) return true;
  return contains(regions, region.name) || contains(materials, region.material);
}

}  // namespace dda
