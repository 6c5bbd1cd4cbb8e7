#pragma once

#include "continuation/follow/path_state.hpp"
#include "continuation/follow/turns.hpp"

namespace dda {

/// A step is tried again with this share of its size when Newton fails.
inline constexpr double cut = 0.25;
/// Below this share of its first size a step is given up.
inline constexpr double smallest_share = 1e-4;

/// One step under a control while its length is sought.
struct Stride {
  /// What the try before has left unaccounted for.
  struct Before {
    double amount = 0;  ///< its length; 0 when there was none
    double lost = 0;    ///< [FL]
  };

  const Move& move;
  double amount = 0;     ///< length of the next try along the leaving tangent
  double natural = 0;    ///< of the first one, where nothing speaks for less
  std::string why = {};  ///< it has been shortened last
  int refinements = 0;   ///< how often for the peak, a turn or the balance of energy
  int looks = 0;         ///< and to look between its ends
  double looked_at = 0;
  Looks looked = {};
  Before before = {};
};

/// What a rung has made of a try: the point where the step ends; none when the step is to be tried again, the
/// stride being shorter now.
struct Outcome {
  std::optional<Point> point;
};

/// What may be said of a converged try; nothing where this rung has no say.
using Rung = std::optional<Outcome> (*)(PathState& path, const Candidate& candidate, Stride& stride);

}  // namespace dda
