#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "studies/dda/sweep/processes/processes.hpp"
#include "studies/dda/sweep/sweep_cases.hpp"
#include "studies/dda/sweep/sweep_progress.hpp"

namespace dda {

struct SweepOptions {
  int jobs = 1;  ///< processes at a time
  bool quiet = false;
  bool may_leave = false;    ///< when other processes run what is left, and one of them waits for all
  bool writes_files = true;  ///< sweep.csv and the others
};

/// Runs the cases that nobody has run, so many at a time, and keeps the sweep's files up to date, until no case is left
/// that this process or another one runs.
///
/// A case that fails stays what it is, and the others go on. What other processes die of is taken over. Ctrl-C and
/// SIGTERM stop the runs, which write their restart files. Throws OutputError when the sweep's own files cannot be
/// written; the runs are stopped then.
class SweepRunner {
 public:
  SweepRunner(const Sweep& sweep, std::filesystem::path folder, SweepCases& cases,
              const SweepOptions& options);

  void run();
  const std::vector<CaseState>& states() const { return cases_.states(); }
  /// Whether it was stopped before all was done.
  bool was_interrupted() const { return was_interrupted_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool is_over();
  void look();
  void write();
  void finish();
  void stop();
  bool start_next();
  bool take_ended();
  CaseState outcome(const EndedProcess& ended) const;

  const Sweep& sweep_;
  const std::filesystem::path folder_;
  SweepCases& cases_;
  const SweepOptions options_;
  SweepProgress progress_;
  Processes processes_;
  Clock::time_point looked_at_, may_write_at_;
  bool has_news_ = false, is_stopping_ = false, was_interrupted_ = false;
};

}  // namespace dda
