#include "models/load/load.hpp"

#include <algorithm>

#include "models/body/motion.hpp"

namespace dda {

double Body::largest_modulus() const {
  double largest = 0;
  for (const auto& material : materials) largest = std::max(largest, material->modulus());
  return largest;
}

void add_point_force(StageLoads& stage, const Body& body, BlockId id, const PointForce& at) {
  for (const auto& [node, rows] : motions_at(body, id, at.x))
    Eigen::Map<Vec6>(stage.force.data() + 6 * node.value()) += rows.transpose() * at.force;
}

}  // namespace dda
