#pragma once

#include <filesystem>
#include <string>

#include "studies/dda/sweep/sweep.hpp"

namespace dda {

/// A line for a shell in the current folder that does a sweep with GNU parallel, into the same case folders.
///
/// One word per axis value (`::: 50 100 ::: 1 2 3`, zipped keys by `:::+`) where every case is the same
/// command with other values; the commands one by one where not, as with seeds at different places, or where
/// parallel would take a part of the command for a place of its own.
std::string parallel_line(const Sweep& sweep, const std::filesystem::path& folder, int jobs);

}  // namespace dda
