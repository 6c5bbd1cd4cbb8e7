#pragma once

#include <vector>

#include "continuation/motion/energy/potential.hpp"

namespace dda {

/// Where the energy of a motion has gone [F L].
///
///     external = Δkinetic + Δstored + friction + fracture + damping + impact + numerical + error
///
/// What impacts take, and vibrations that a step damps, is measured: a step is a minimum, so that it satisfies
/// K₁ − K̂ = −∇Π · way + of_start (BodyWork), or a linear system that says so. What that is missed by is the error. Of that
/// work the part that contacts do, less what they store and rub, is the impacts'; the rest of what is lost is numerical. What
/// impacts under way have taken is stored, so that they can give of it; it is spent when they are over. Where
/// velocities are means over a step, kinetic energy is that of its middle, half a step behind what is stored and spent by
/// then, but for the strain of bodies that nothing holds. Impacts never give in a step: what they seem to is numerical.
struct MotionLedger {
  double external = 0, kinetic = 0, friction = 0, fracture = 0, damping = 0, impact = 0, numerical = 0,
         error = 0;
  StoredEnergies stored;
  std::vector<double>
      fracture_of;  ///< the part of `fracture` of each interface, by number; none where none can tear

  /// What no law has spent.
  double lost() const { return impact + numerical; }
};

}  // namespace dda
