#pragma once

#include "continuation/handover/handover.hpp"
#include "continuation/motion/step/first_equilibrium.hpp"

namespace dda {

/// How what a path has left has become the beginning of a motion.
struct Beginning {
  Handover handover;
  FirstEquilibrium equilibrium;
  double time = 0;  ///< that the motion may take [T]
};

/// Finds equilibrium in finite rotations as the path has left things, and hands these over as the deck has them go on. Throws
/// InputError where nothing tells how long the motion may take.
Beginning begin_motion(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters);

}  // namespace dda
