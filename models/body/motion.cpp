#include "models/body/motion.hpp"

#include "models/kinematics/second_order.hpp"

namespace dda {
namespace {

double length_of(const Body& body, JumpId jump) { return body.size(body.cracks->cut_of(jump).block); }

std::span<const JumpId> jumps_at(const Body& body, BlockId block, const Vec2& x) {
  return body.cracks ? body.cracks->jumps_at(block, x) : std::span<const JumpId>();
}

}  // namespace

NodeMotion motion_of(const Body& body, JumpId jump, const Vec2& x) {
  const Cut& cut = body.cracks->cut_of(jump);
  const Vec2 from_middle = (x - (cut.start + cut.end) / 2) / length_of(body, jump);
  Mat26 rows = Mat26::Zero();
  rows.leftCols<3>() << 1, 0, -from_middle.y(), 0, 1, from_middle.x();
  return {body.node_of(jump), rows};
}

Mat26 gradient_motion(const Body& body, BlockId block, const Vec2& x) {
  return gradient_displacement_rows(x - body.block(block).moments.centroid, body.size(block));
}
Mat36 gradient_strain(const Body& body, BlockId block, const Vec2& x) {
  return gradient_strain_rows(x - body.block(block).moments.centroid, body.size(block));
}

Vec3 stress_beside_mean(const Body& body, BlockId block, const Vec2& x, std::span<const double> d) {
  const auto node = body.gradient_of(block);
  if (!node) return Vec3::Zero();
  const Eigen::Map<const Vec6> gradient(d.data() + block_unknowns * node->value());
  return body.material(block).stiffness() * gradient_strain(body, block, x) * gradient;
}

std::vector<NodeMotion> motions_at(const Body& body, BlockId block, const Vec2& x) {
  std::vector<NodeMotion> out{{block, displacement_rows(x - body.block(block).moments.centroid)}};
  if (const auto node = body.gradient_of(block)) out.push_back({*node, gradient_motion(body, block, x)});
  for (const JumpId jump : jumps_at(body, block, x)) out.push_back(motion_of(body, jump, x));
  return out;
}

std::vector<std::pair<BlockId, Vec6>> rotations_at(const Body& body, BlockId block, const Vec2& x) {
  std::vector<std::pair<BlockId, Vec6>> out{{block, Vec6::Unit(2)}};
  if (const auto node = body.gradient_of(block))
    out.emplace_back(*node, gradient_rotation_row(x - body.block(block).moments.centroid, body.size(block)));
  for (const JumpId jump : jumps_at(body, block, x))
    out.emplace_back(body.node_of(jump), Vec6::Unit(2) / length_of(body, jump));
  return out;
}

}  // namespace dda
