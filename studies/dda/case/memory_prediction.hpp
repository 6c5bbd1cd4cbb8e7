#pragma once

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// Most memory that a run will have taken at one time [bytes].
///
/// Two courses are told apart. Cracks stay updates of the first factorisation; or more points crack than are
/// worth updating (most_columns_beside), and the tangent is factorised anew, by MUMPS where it is indefinite,
/// between steps of LOCA. Which it will be depends on the path where everything may crack: then the number of
/// points that crack is estimated (likely_cracks).
struct MemoryPrediction {
  double until_here = 0;           ///< taken by this process so far, at most
  double libraries = 0;            ///< that a run loads
  double factor = 0;               ///< what solvers keep, counted by their symbolic factorisations
  double vectors = 0;              ///< of all unknowns and points, and copies of the matrix
  double columns = 0;              ///< of the points that crack
  std::size_t cracked_points = 0;  ///< how many are taken to crack beside one factorisation
  bool factorises_anew = false;    ///< the second course is expected
  double least = 0, most = 0;  ///< of both courses where both are possible, most at its worst; else the total

  double total() const { return until_here + libraries + factor + vectors + columns; }
};

/// Counts; nothing is factorised. Throws std::runtime_error where the solver cannot analyse the matrix.
MemoryPrediction predict_memory(const Simulation& simulation);

}  // namespace dda
