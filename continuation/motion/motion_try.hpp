#pragma once

#include <vector>

#include "continuation/motion/motion.hpp"

namespace dda {

/// A step that was tried: how it was found, what it has come to, and where its energy has gone.
struct Motion::Try {
  Inertia inertia;
  MotionStep found;
  std::vector<BodyCourse> courses = {};
  MotionLedger entry = {};
  double flown = 0;  ///< K̂ of all [F L]
};

}  // namespace dda
