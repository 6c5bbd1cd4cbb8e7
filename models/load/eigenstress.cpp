#include "models/load/eigenstress.hpp"

#include <algorithm>

#include "framework/base/suggestion.hpp"
#include "models/load/quadrature.hpp"

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

}  // namespace

Vec3 mean_over(const Block& block, const Components& components) {
  const auto value_at = [&](const Vec2& x) -> Vec3 {
    return {components[0](x), components[1](x), components[2](x)};
  };
  if (std::ranges::all_of(components, &Formula::is_constant)) return value_at(block.moments.centroid);
  const Integrals sum = integral(block.outline, [&](const Vec2& x) {
    Integrals out = Integrals::Zero();
    out.head<3>() = value_at(x);
    return out;
  });
  return sum.head<3>() / block.moments.area;
}

void Chosen::require_known(const Body& body, const Position& where) const {
  std::vector<std::string> known_regions, known_materials;
  for (const Region& region : body.assembly.regions) {
    known_regions.push_back(region.name);
    known_materials.push_back(region.material);
  }
  require(regions, known_regions, "region", where);
  require(materials, known_materials, "material", where);
}

bool Chosen::has(const Body& body, BlockId block) const {
  const Region& region = body.assembly.regions[static_cast<std::size_t>(body.block(block).region)];
  if (regions.empty() && materials.empty()) return true;
  return contains(regions, region.name) || contains(materials, region.material);
}

void add_eigenstress(StageLoads& stage, const Body& body, BlockId block, const Vec3& stress) {
  stage.initial_stress.resize(body.assembly.num_blocks(), Vec3::Zero());
  stage.initial_stress[block.value()] += stress;
  Eigen::Map<Vec6>(stage.force.data() + block_unknowns * block.value()).tail<3>() -=
      body.volume(block) * stress;
}

}  // namespace dda
