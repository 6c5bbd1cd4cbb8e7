#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "framework/messages/progress.hpp"
#include "studies/dda/sweep/sweep_cases.hpp"

namespace dda {

/// What the user sees of a sweep: a line for every case that ends and, on a terminal, below them a table of
/// those that run, which renews itself.
class SweepProgress {
 public:
  SweepProgress(const Sweep& sweep, std::filesystem::path folder, bool quiet);
  ~SweepProgress();
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;

  /// A line that stays.
  void note(const std::string& text);
  void ended(std::size_t index, const CaseState& state);
  /// The table anew, at most a few times a second.
  void show(const SweepCases& cases);

 private:
  void clear();
  std::string running_line(const SweepCases& cases, std::size_t index) const;

  const Sweep& sweep_;
  const std::filesystem::path folder_;
  const Progress::Style style_;
  std::chrono::steady_clock::time_point start_, shown_at_{};
  std::size_t lines_ = 0;  ///< of the table now on the terminal
};

/// "36 cases: 34 goal_reached, 1 stopped_early, 1 failed".
std::string count_text(const std::vector<CaseState>& states);

/// Number of the last step that a run has written, "" when there is none.
std::string last_step(const std::filesystem::path& run_folder);

}  // namespace dda
