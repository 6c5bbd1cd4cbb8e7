#pragma once

#include <optional>
#include <utility>

#include "framework/files/run/results_writer.hpp"
#include "framework/files/run/run_folder.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/log.hpp"
#include "framework/messages/progress.hpp"
#include "studies/dda/case/simulation.hpp"
#include "studies/dda/record/failure_indicator.hpp"
#include "studies/dda/record/interface_record.hpp"
#include "studies/dda/record/path/events.hpp"
#include "studies/dda/record/path/trace.hpp"
#include "studies/dda/record/run_memory.hpp"
#include "studies/dda/record/warnings/torn_pieces.hpp"

namespace dda {

/// Writes everything that a run folder holds while a path is followed.
///
/// Every accepted step is a row of curve.csv and a line of log.jsonl; fields and the restart file follow at
/// landings, at the peak, every record.fields_every steps and at the end; fields at the start as well. summary.json comes last: a folder
/// without it does not hold a whole result. Throws OutputError.
class RunRecorder {
 public:
  /// `effective` is effective_deck(deck); `memory` is that of the run to be continued, or nothing for a new
  /// one.
  RunRecorder(const RunFolder& folder, Simulation& simulation, const DeckFile& deck, std::string effective,
              Timings& timings, std::optional<RunMemory> memory = {});

  void record(const Point& point);
  /// The deck is another one from the next restart on, by a control that Python has switched to.
  void go_on_with(std::string effective) { effective_ = std::move(effective); }
  /// The deck has another stage, which has begun: every table that tells stages apart, and the restart file, know it from here.
  void go_on_with_stage(std::string effective);
  /// Whether the run had stages fewer when its folder was made.
  bool has_new_stages() const { return has_new_stages_; }
  /// What else is to stand among the notices.
  void add_notice(std::string text) { offered_.push_back(std::move(text)); }
  /// No step of the path comes any more, whatever follows it.
  void end_path(const Ending& ending) { memory_.ended = ending; }
  /// The restart file of the last step, before something begins that may take long.
  void keep() { write_restart_file(); }
  /// What is to stand under "motion" in the summary.
  void add_motion(nlohmann::ordered_json summary) { motion_ = std::move(summary); }
  /// Fields of the end, restart file, figures, summary; gives the summary.
  nlohmann::ordered_json finish(const Ending& ending);

  Log& log() { return log_; }
  const Measures& measures() const { return measures_; }
  const RunMemory& memory() const { return memory_; }
  const std::vector<TracePoint>& trace() const { return trace_; }
  /// What the progress line shows of the last step.
  ProgressPoint progress() const;
  /// What the user is to be told besides, once; "" if nothing.
  std::string take_warning() { return std::exchange(warning_, {}); }

 private:
  void start();
  void keep_peak(const Point& point, const Measurement& now);
  void store_peak();
  void follow(const Growth& growth);
  void end_stage(const StageEnd& end);
  void begin_stage();
  /// Which stage a row belongs to, in decks that follow several.
  RecordedColumns columns_of_stages() const;
  /// Of the present one in the deck's `stages`, from 1; 0 where but one is followed.
  int stage_number() const;
  /// Its fields and, beside them, its numbers.
  void store(const StoredState& at, const Measurement& measured);
  void store_here();
  void write_restart_file();
  void write_stiffness() const;
  /// What the end shows of results that are none: pieces torn out, cohesive zones that the sides are too long
  /// for.
  void look_back();
  Flush durability() const;
  void log_step(const Point& point, const Measurement& now);
  void look_for_crawling();
  /// Makes the model's tables those of the stages that there are now.
  void renew_stages();
  /// By what the loads of the present stage are measured.
  Measures measures_here() const;
  /// Those of the parts that look at each step, and all of them that are written.
  RecordedColumns columns_of_parts() const;
  RecordedColumns columns_of_rows() const;
  /// New, or behind the last row of a run that goes on.
  CurveTable open_curve(bool is_new) const;
  ResultsMesh mesh() const;
  /// Where the run comes from.
  ResultsTexts texts() const;
  void append_row(const Measurement& now, const Point& point);
  bool is_due(const Point& point) const;
  StoredState here() const;

  const RunFolder& folder_;
  Simulation& simulation_;
  const DeckFile& deck_;
  std::string effective_;
  Timings& timings_;
  RunMemory memory_;
  InterfaceRecord interfaces_;
  FailureIndicator indicator_;
  Measures measures_;
  RecordedColumns columns_;
  Fields fields_;
  PathEvents events_;
  std::set<EventKind> events_here_;
  Log log_;
  CurveTable curve_;
  ResultsWriter results_;
  int last_stored_ = -1;
  bool has_new_stages_ = false;
  double restart_written_ = -1e9;  ///< when [s]
  Measurement last_;
  std::vector<TornPiece> torn_;
  std::vector<std::string> notices_;  ///< of the simulation, and of the end
  std::vector<TracePoint> trace_;
  double goal_before_ = 0;  ///< share of the way when it was last looked at
  std::string warning_;
  std::vector<std::string> offered_;  ///< notices of who runs it
  nlohmann::ordered_json motion_;     ///< null without
};

}  // namespace dda
