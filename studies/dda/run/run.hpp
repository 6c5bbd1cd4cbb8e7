#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/dda/case/deck/deck.hpp"
#include "studies/dda/run/recording/run_recorder.hpp"

namespace dda {

/// Where a run writes and what it shows.
struct RunOptions {
  std::filesystem::path
      folder;  ///< empty: the deck's own, or runs/<name of the deck> with the next free number
  bool overwrite = false;
  bool quiet = false;
  bool profile = false;  ///< print where the time went
};

/// What a run came to.
struct RunResult {
  std::filesystem::path folder;
  Ending ending;
  nlohmann::ordered_json summary;
  Measures measures;
  std::vector<TracePoint> trace;
};

/// Follows the path of a deck into a new run folder. Throws InputError (nothing written) and OutputError.
RunResult run_deck(const DeckFile& deck, const RunOptions& options);

/// Continues the run in `folder`, in place or, when the options name another folder, in a copy.
RunResult resume_run(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                     const RunOptions& options);

/// One line: folder, status, reason, peak, steps, time.
std::string last_line(const RunResult& result);

}  // namespace dda
