#pragma once

#include "continuation/motion/step/step_solver.hpp"

namespace dda {

/// Where a structure stands before it is let go.
struct FirstEquilibrium {
  Poses poses;
  SliderMemory contacts;  ///< what they bear
  double released =
      0;  ///< of what was stored, by work that went nowhere; what joints spend on the way is none of it [F L]
  double moved = 0;  ///< the farthest that a centre has come [L]
  int iterations = 0;
  std::string failure;  ///< "" when it was found; else nothing has moved
};

/// Finds equilibrium again where a path of small rotations ends in places of finite ones, which differ from it in second
/// order: joints that have slid open by slip times rotation, loads follow their material points. One step from rest to
/// rest, the minimum of ½ |y − y₀|²_M/dt² + Π(y), with all damage as it is. What it releases belongs to no motion. Bonds
/// that are ends of sides bear what these press on each other; bodies between them meet at nothing else.
FirstEquilibrium find_equilibrium(const MovingScene& scene, const std::vector<Bond>& bonds,
                                  const Poses& poses, double dt);

}  // namespace dda
