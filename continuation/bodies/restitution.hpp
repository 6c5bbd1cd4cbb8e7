#pragma once

#include <vector>

#include "continuation/bodies/meetings.hpp"
#include "continuation/integrator/integrator.hpp"

namespace dda {

/// Bodies that have met in a step.
struct Impact {
  const std::vector<Meeting>& meetings;  ///< at its end
  const Poses& at;                       ///< where all are then
  const Poses& approach;                 ///< ẏ with which they have flown towards each other
  const Poses& velocity;                 ///< ẏ that the step has left
  double slow = 0;                       ///< approaches up to this are none [L/T]
};

/// What bodies get back: impulses λ ≥ 0 along the normals after which they part with e times the speed at which they have
/// met, none being pushed into another. The least change of kinetic energy, by projected Gauss-Seidel on rigid motions.
/// Empty where nothing is given back.
std::vector<RigidMotion> rebound(const MovingScene& scene, const Impact& impact);

}  // namespace dda
