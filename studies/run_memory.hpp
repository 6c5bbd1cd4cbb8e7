#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/fields.hpp"
#include "studies/measures.hpp"

namespace dda {

/// What a run remembers beside its walker and path; a restart brings it back.
struct RunMemory {
  int last_step = 0;  ///< rows of the curve are those of steps 0 … last_step
  Measurement start;  ///< where the path of the last stage begins
  Measurement peak;   ///< at the largest load so far
  std::optional<StoredState>
      peak_state;  ///< fields of the peak; `is_peak_stored` says whether run.h5 has them
  bool is_peak_stored = true;
  double first_stiffness = 0;        ///< of the load against its displacement, at the start
  double largest_gap = 0;            ///< that iterated multipliers left in a step
  long long num_factorisations = 0;  ///< of the processes before this one
};

}  // namespace dda
