#pragma once

#include "continuation/motion/moving_scene.hpp"

namespace dda {

/// Three instants of a body: a step dt behind the last one, dt₋.
struct Interval {
  double now = 0;       ///< dt [T]
  double before = 0;    ///< dt₋ [T]
  bool begins = false;  ///< the motion, with a velocity that is that of now and no mean over dt₋

  /// dt_m = ½ (dt + dt₋), over which accelerations act; ½ dt at the beginning.
  double mean() const { return begins ? now / 2 : (now + before) / 2; }
};

/// Where a body flies without forces: exact for any rotation and any step.
///
///     ĉ = c + dt w,      F̂ = R(φ + Δφ dt/dt₋) (U + ΔU dt/dt₋)      F = R U,  w and Δ from the last step
Pose free_flight(const Pose& before, const Pose& now, const Interval& dt);

}  // namespace dda
