#pragma once

namespace dda {

/// What may happen at an accepted point, or between it and the one before.
enum class EventKind {
  first_crack,    ///< dissipation begins here
  limit_point,    ///< the load has a maximum or a minimum
  turning_point,  ///< a displacement gauge turns back or forward
  bifurcation,    ///< the number of negative eigenvalues changes, but not by a limit point
  landing,        ///< a wanted gauge value
  release,        ///< a vertex of an instantaneous release
  end
};

}  // namespace dda
