#pragma once

#include "studies/simulation.hpp"

namespace dda {

/// Most memory that a run will have taken at one time, within about a fifth [bytes].
struct MemoryPrediction {
  double until_here = 0;  ///< taken by this process so far, at most, and by libraries that come later
  double factor = 0;      ///< L and what the solver needs beside it; counted by its symbolic factorisation
  double vectors = 0;     ///< a second copy of the matrix, or the vectors of a LOCA step if they are more
  double columns = 0;     ///< of the points that crack
  std::size_t cracked_points = 0;  ///< how many are taken to crack

  double total() const { return until_here + factor + vectors + columns; }
};

/// Counts; nothing is factorised. Throws std::runtime_error where the solver cannot analyse the matrix.
MemoryPrediction predict_memory(const Simulation& simulation);

}  // namespace dda
