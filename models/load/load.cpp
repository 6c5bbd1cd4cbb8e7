#include "models/load/load.hpp"

#include <algorithm>

namespace dda {

double Body::largest_modulus() const {
  double largest = 0;
  for (const auto& material : materials) largest = std::max(largest, material->modulus());
  return largest;
}

void add_point_force(StageLoads& stage, const Body& body, BlockId id, const PointForce& at) {
  const Mat26 t = displacement_rows(at.x - body.block(id).moments.centroid);
  Eigen::Map<Vec6>(stage.force.data() + 6 * id.value()) += t.transpose() * at.force;
}

}  // namespace dda
