#pragma once

#include "continuation/motion/bonds.hpp"
#include "continuation/motion/motion_parameters.hpp"
#include "continuation/state/system.hpp"

namespace dda {

/// What a motion begins with: the last state of a path, in finite rotations.
///
///     c = X0 + (u0, v0),   F = R(r0) (I + ε)
///
/// Joints that still hold stay, with their histories; where nothing is left of one, bodies meet. Loads stay as dead
/// forces on material points, supports as springs. What finite rotations unbalance, of second order in them, moves
/// the structure in its first step.
struct Handover {
  MovingScene scene;
  std::vector<Bond> bonds;
  Poses poses;
  bool is_pushed = false;
};

/// Throws InputError for what could not be handed over: materials without density, blocks narrower than their offset,
/// cracks through blocks, initial stress.
void require_handover(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters);

/// Where a path has ended.
struct PathEnd {
  const System& system;
  const State& state;
  bool has_fallen = false;  ///< the load was falling
};

Handover hand_over(const Body& body, const PathEnd& end, const MotionParameters& parameters);

}  // namespace dda
