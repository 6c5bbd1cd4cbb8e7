#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "studies/dda/sweep/processes.hpp"
#include "studies/dda/sweep/sweep_progress.hpp"

namespace dda {

struct SweepOptions {
  int jobs = 1;  ///< processes at a time
  bool quiet = false;
};

/// Runs the cases that have no result, so many at a time, and keeps the sweep's files up to date.
///
/// A case that fails stays what it is, and the others go on. Ctrl-C and SIGTERM stop the runs, which write
/// their restart files. Throws OutputError when the sweep's own files cannot be written; the runs are stopped
/// then.
class SweepRunner {
 public:
  SweepRunner(const Sweep& sweep, std::filesystem::path folder, std::vector<CaseState> states,
              const SweepOptions& options);

  void run();
  const std::vector<CaseState>& states() const { return states_; }
  /// Whether it was stopped before all was done.
  bool was_interrupted() const { return was_interrupted_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool is_over() const;
  bool is_due() const;
  void write();
  std::size_t next() const;
  void stop();
  bool start_next();
  bool take_ended();
  CaseState outcome(const EndedProcess& ended) const;

  const Sweep& sweep_;
  const std::filesystem::path folder_;
  std::vector<CaseState> states_;
  const std::size_t jobs_;
  SweepProgress progress_;
  Processes processes_;
  std::size_t next_ = 0;
  Clock::time_point written_at_;
  bool has_news_ = false, is_stopping_ = false, was_interrupted_ = false;
};

}  // namespace dda
