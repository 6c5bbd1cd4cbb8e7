#pragma once

#include "studies/dda/run/run.hpp"

namespace dda {

/// What a run without a path came to.
struct MotionResult {
  std::filesystem::path folder;
  Ending ending;
  nlohmann::ordered_json summary;
};

/// Lets the undeformed structure of a deck without stages go, in a new run folder. Throws InputError (nothing written) and
/// OutputError.
MotionResult run_motion_alone(const DeckFile& deck, const RunOptions& options);

/// Whether a run in a folder is one without a path.
bool is_motion_alone(const std::filesystem::path& folder);

/// Goes on with such a run from its last restart, there or in another folder; from its beginning where there is none.
MotionResult resume_motion_alone(const std::filesystem::path& folder,
                                 const std::vector<std::string>& overrides, const RunOptions& options);

/// One line: folder, status, reason, steps, time.
std::string last_line(const MotionResult& result);

}  // namespace dda
