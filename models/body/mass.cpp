#include "models/body/mass.hpp"

namespace dda {
namespace {

/// T is linear in the place, T = T0 + X T_x + Y T_y, so ∫ TᵀT dA = A T0ᵀT0 + Σ S_ij T_iᵀT_j with the second
/// moments S about the centroid.
Mat6 unit_mass(const Moments& moments) {
  const Mat26 at_centre = displacement_rows(Vec2::Zero());
  const Mat26 slopes[2] = {displacement_rows(Vec2::UnitX()) - at_centre,
                           displacement_rows(Vec2::UnitY()) - at_centre};
  Mat6 out = moments.area * at_centre.transpose() * at_centre;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) out += moments.second(i, j) * slopes[i].transpose() * slopes[j];
  return out;
}

}  // namespace

std::vector<Mat6> unit_mass(const Body& body) {
  std::vector<Mat6> out;
  for (const Block& block : body.assembly.blocks) out.push_back(body.thickness * unit_mass(block.moments));
  return out;
}

}  // namespace dda
