#pragma once

#include <string>
#include <vector>

#include "studies/dda/sweep/sweep_cases.hpp"

namespace dda {

/// What is known beforehand of the cases of a sweep that are not over.
struct Forecast {
  std::size_t num_cases = 0, num_open = 0;
  double least_memory = 0;  ///< that the largest case takes which was looked at [MiB]; 0: not known
  double peak_memory = 0;   ///< the most that a finished case took [MiB]; 0: none has finished
  double longest = 0;       ///< time that a finished case took [s]; 0: none has finished
  std::string memory_text = {}, time_text = {};  ///< where these come from, in words

  /// Memory to ask for [MiB]; 0: not known.
  double memory_to_ask() const;
  /// Time to ask for, of a task that runs so many cases one after another [s]; 0: not known.
  double time_to_ask(std::size_t cases_of_task) const;
};

/// Meshes some of the open cases as `dda check` does, first and last among them, and reads what those that are over
/// took. A case that cannot be meshed is told of on standard error.
Forecast forecast_of(const Sweep& sweep, const std::vector<CaseState>& states);

}  // namespace dda
