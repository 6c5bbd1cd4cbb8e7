#pragma once

#include "continuation/detour/increment/load_solver.hpp"

namespace dda {

/// How far the load is to be raised, and by what.
struct LoadStep {
  double increment;  ///< of the load factor
  LoadSolver& solver;
};

/// What a load increment came to.
struct Increment {
  std::optional<Settled> settled;  ///< nothing when no equilibrium is left at that load
  int relaxation_iterations = 0;
  std::string why;  ///< the last search failed
};

/// The load factor raised by an increment; every point beyond its strength is released in full, all at once,
/// until none is beyond. What the increment jumps over is lost: Pearce et al. (2000) shortened it near
/// failure. Points are judged in equilibrium alone, never on the way to it, so that a solver which overshoots
/// releases no more than one that does not. History and multipliers of the system are left as they were.
Increment load_increment(Stepper& stepper, const State& start, const LoadStep& step);

}  // namespace dda
