#pragma once

#include "studies/dda/case/simulation.hpp"

namespace dda {

/// What a run takes at least [bytes]; cracks take more.
struct PredictedMemory {
  double held = 0;     ///< by this process, the model included
  double factor = 0;   ///< of the intact stiffness; 0 without a path
  double vectors = 0;  ///< of all unknowns and points; 0 without a path

  double total() const { return held + factor + vectors; }
};

/// Of the run of a simulation that is made and not prepared. Nothing is factorised.
PredictedMemory predicted_memory(const Simulation& simulation);

/// Of the same run on several ranks: factor of each. Rank 0 has the rest of `predicted_memory` beside it. A structure
/// whose stiffness is indefinite from the beginning is rank 0's.
std::vector<double> factors_by_rank(const Simulation& simulation, int ranks);

}  // namespace dda
