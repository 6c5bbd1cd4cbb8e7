#pragma once

#include <filesystem>
#include <vector>

#include "studies/dda/sweep/sweep_folder.hpp"

namespace dda {

/// curves.svg: load against the first displacement gauge that all cases with a result have. A legend as far
/// as it can be read: of the cases, or of the first axis. Nothing is written where units or gauges differ.
void write_sweep_figure(const Sweep& sweep, const std::filesystem::path& folder,
                        const std::vector<CaseState>& states);

}  // namespace dda
