#pragma once

#include <vector>

#include "continuation/handover/motion_parameters.hpp"
#include "models/body/body.hpp"

namespace dda {

/// Two blocks whose outlines overlap as they are drawn.
struct DrawnOverlap {
  std::size_t first = 0, second = 0;
  double depth = 0;        ///< of the corner of one that is deepest inside the other [L]
  Vec2 at = Vec2::Zero();  ///< that corner
  double touching = 0;     ///< the depth up to which they but touch: what drawings round [L]
};

/// All pairs of blocks that overlap by more than rounding, of which one moves; in order.
std::vector<DrawnOverlap> drawn_overlaps(const Body& body, const MotionParameters& parameters);

/// By how much the core of each block stands back further than by the offset, so that none of them are pressed together where
/// they but touch: what moves does, of two blocks that move the smaller one [L].
std::vector<double> set_back(const Body& body, const MotionParameters& parameters);

}  // namespace dda
