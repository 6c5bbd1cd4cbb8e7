#pragma once

#include "continuation/handover/handover.hpp"
#include "continuation/motion/first_equilibrium.hpp"

namespace dda {

/// How what a path has left has become the beginning of a motion.
struct Beginning {
  Handover handover;
  FirstEquilibrium equilibrium;
  double time = 0;  ///< that the motion may take [T]
};

/// Hands the end of a path over, finds equilibrium in finite rotations, and lets the load grow by its push. Throws
/// InputError where nothing tells how long the motion may take.
Beginning begin_motion(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters);

}  // namespace dda
