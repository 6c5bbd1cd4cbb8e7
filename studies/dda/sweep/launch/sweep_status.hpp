#pragma once

#include <filesystem>
#include <string>

namespace dda {

/// How far a sweep is, from its folder alone: counts, who runs what since when, what failed and what was left by
/// processes that died. Nothing is written, so it may be asked from any machine, at any time.
///
///     runs/bars: 40 cases: 31 done, 4 running, 3 waiting, 2 failed
///
/// Throws InputError for a folder that holds no sweep.
std::string sweep_status_text(const std::filesystem::path& folder);

}  // namespace dda
