#pragma once

#include <string>
#include <vector>

#include "continuation/state/system.hpp"

namespace dda {

/// How far the points that lose their strength at once stand beyond it.
struct Excess {
  double value = 0;  ///< largest q_eq/κ − 1; 0 within
  std::size_t point = 0;
};

/// Of a state with the history that belongs to it. Other laws follow their envelope by construction.
Excess strength_excess(const System& system, const std::vector<History>& history, const LawValues& laws);

/// What holds the blocks of a state, and how far they have moved.
struct Holding {
  double load = 0;                  ///< Σ |force| of loads and driven springs [F]
  double weak = 0;                  ///< Σ |force| of the weak springs [F]
  double movement = 0;              ///< largest displacement of a block [L]
  std::vector<std::size_t> blocks;  ///< that move most: at least half as far as the farthest
};

Holding holding_of(const System& system, const State& at);
/// No less than that, without blocks: none is taken to move more than ten times as far as the loads do, or as
/// points open.
Holding bound_of_holding(const System& system, const State& at);
/// Σ |force| of loads and driven springs; the force level where there is none [F].
double load_on(const System& system, const State& at);

/// What is asked of an equilibrium beside being one.
struct SoundnessLimits {
  double size = 0;          ///< of the structure [L]
  double largest_load = 0;  ///< Σ |force| so far [F]
};

/// Why a state is no result: a block moves farther than the structure is large, or weak springs, which are
/// there against singular matrices, bear more than 1e-3 of the load (of at least 1e-3 of the largest); "" for
/// a sound one.
std::string objection_to(const Holding& holding, const SoundnessLimits& limits,
                         const Equilibrium& equilibrium);

/// Why a state beyond its strength is no result: by more than 1e-4; "" within.
std::string objection_to(const Excess& excess, const System& system);

}  // namespace dda
