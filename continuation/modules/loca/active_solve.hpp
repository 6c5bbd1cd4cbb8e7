#pragma once

#include <memory>

#include "continuation/solve/loca.hpp"

namespace dda {

/// The solve in force, shared by all copies of the group and the constraint: what they evaluate.
struct ActiveSolve {
  Equations* equations = nullptr;
  double step = 0;          ///< s at its end
  bool is_start = true;     ///< the stepper only looks at its first point
  std::string reason = {};  ///< why NOX has failed
};

}  // namespace dda
