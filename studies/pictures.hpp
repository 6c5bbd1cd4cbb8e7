#pragma once

#include "framework/output/run_folder.hpp"
#include "framework/output/svg/plot.hpp"
#include "studies/run_memory.hpp"

namespace dda {

/// curve.svg and, up to 20 000 blocks, deformed.svg of a run; the curve is read back from curve.csv.
void write_pictures(const RunFolder& folder, const Fields& fields, const Measures& measures,
                    const RunMemory& memory, const StoredState& end);

}  // namespace dda
