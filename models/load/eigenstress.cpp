#include "models/load/eigenstress.hpp"

#include <algorithm>

#include "models/load/quadrature.hpp"

namespace dda {
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

void add_eigenstress(StageLoads& stage, const Body& body, BlockId block, const Eigenstress& eigenstress) {
  stage.initial_stress.resize(body.assembly.num_blocks(), Vec3::Zero());
  stage.initial_stress[block.value()] += eigenstress.stress;
  stage.out_of_plane.resize(body.assembly.num_blocks(), 0.0);
  stage.out_of_plane[block.value()] += eigenstress.out_of_plane;
  Eigen::Map<Vec6>(stage.force.data() + block_unknowns * block.value()).tail<3>() -=
      body.volume(block) * eigenstress.stress;
}

}  // namespace dda
