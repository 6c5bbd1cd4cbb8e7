#pragma once

#include <span>
#include <vector>

#include "models/body/body.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// One of the motions that displace a point: u(x) = Σ rows · d_node.
struct NodeMotion {
  BlockId node;
  Mat26 rows;
};

/// The motion of what lies right of a cut relative to what lies left of it, in the first three unknowns of the
/// jump's node, all of them lengths:
///
///     J(x) = [ 1  0  −Y/ℓ ]       (X, Y) from the middle of the cut,  ℓ² the area of the block
///            [ 0  1   X/ℓ ]
NodeMotion motion_of(const Body& body, JumpId jump, const Vec2& x);

/// Displacement and strain of a point of a block of second order by the unknowns of its strain gradient
/// (second_order.hpp), 2 × 6 and 3 × 6.
Mat26 gradient_motion(const Body& body, BlockId block, const Vec2& x);
Mat36 gradient_strain(const Body& body, BlockId block, const Vec2& x);

/// What the gradient of its strain adds at a point of a block to its mean stress, C F(x) g [F/L²], by the unknowns of
/// all nodes; zero in one of first order.
Vec3 stress_beside_mean(const Body& body, BlockId block, const Vec2& x, std::span<const double> d);

/// Of a point of a block: the block's own, T, that of its strain gradient if it is of second order, and those of the jumps
/// by which its part there moves beside it.
std::vector<NodeMotion> motions_at(const Body& body, BlockId block, const Vec2& x);

/// Rates of rotation of a point of a block in the same nodes, 1 × 6 each.
std::vector<std::pair<BlockId, Vec6>> rotations_at(const Body& body, BlockId block, const Vec2& x);

}  // namespace dda
