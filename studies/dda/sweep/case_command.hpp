#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/dda/sweep/description/sweep.hpp"

namespace dda {

/// What stands behind the program's name to do one case of a sweep in its folder: a run anew, or the rest of
/// one that was interrupted.
std::vector<std::string> case_command(const Sweep& sweep, const std::filesystem::path& folder,
                                      std::size_t index, bool resumes);

/// A line for a shell in the current folder that does a sweep case by case, each by `dda sweep --case`:
///
///     seq 4 | OMP_NUM_THREADS=1 xargs -P 2 -n 1 dda sweep s.yaml --quiet --folder runs/s --case
std::string line_of_cases(const Sweep& sweep, const std::filesystem::path& folder, int jobs);

/// What one of many processes of a sweep is started by, one case at a time: dda sweep s.yaml ... --jobs 1
std::string line_of_process(const Sweep& sweep, const std::filesystem::path& folder);

/// As a shell wants a word that it must not change.
std::string quoted(const std::string& word);

}  // namespace dda
