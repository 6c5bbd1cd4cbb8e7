#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/dda/run/run.hpp"
#include "studies/dda/sweep/description/sweep.hpp"

namespace dda {

/// What `dda sweep` takes for a sweep that several processes share.
struct SharedSweep {
  bool status = false;             ///< tell how far it is
  std::string launcher;            ///< print what starts it by many processes; "": run it
  bool submit = false;             ///< hand that to the queue
  std::vector<std::string> hosts;  ///< of GNU parallel
  bool may_leave = false;          ///< --no-wait
  double lease = 60;               ///< [s]
  std::string attempt;
};

/// What the program's commands take from the command line.
struct CommandLine {
  std::filesystem::path deck;                  ///< run, sweep, check, compare
  std::vector<std::filesystem::path> runs;     ///< plot, verify, and the one of resume and report
  std::vector<std::string> overrides;          ///< --set
  std::vector<std::string> controls;           ///< compare
  std::vector<std::filesystem::path> plugins;  ///< libraries to be loaded before a deck is read
  std::string topic;                           ///< explain, new, completion, man
  std::string find;                            ///< explain
  std::vector<std::string> words;              ///< complete
  std::filesystem::path out = "curves.svg";    ///< plot
  std::string figure;                          ///< plot: of a run; the curves when empty
  std::string logarithmic;                     ///< plot: axes, "x", "y" or "xy"
  std::filesystem::path picture;               ///< check: of the model; none when empty
  int ranks = 1;                               ///< check: those whose memory is told
  int jobs = 0;                                ///< runs of a sweep at a time; 0: one per processor
  bool dry_run = false;                        ///< sweep
  int only_case = 0;                           ///< sweep; 0: all
  SharedSweep shared;
  bool with_cases = false;     ///< report: those of a sweep's cases, too
  std::filesystem::path page;  ///< report: report.html in the folder when empty; new: <kind>.yaml
  bool json = false;
  std::vector<std::string> animation;  ///< animate; options as Python takes them
  RunOptions run;
};

/// Each does one command and gives the program's exit code. They throw InputError and OutputError.
int command_run(const CommandLine& line);
int command_resume(const CommandLine& line);
int command_check(const CommandLine& line);
int command_explain(const CommandLine& line);
int command_plot(const CommandLine& line);
int command_compare(const CommandLine& line);
int command_sweep(const CommandLine& line);
/// Where the sweep of a command line goes.
std::filesystem::path sweep_folder_of(const CommandLine& line);
/// Prints how far a sweep is, and who runs what.
int sweep_status(const CommandLine& line);
/// Prints what starts a sweep by many processes, or hands it to the queue.
int launch_sweep(const Sweep& sweep, const std::filesystem::path& folder, const CommandLine& line);

/// Does again what `dda sweep` was told when it made the folder `line.runs.front()`, with the copy of its
/// file there where the file itself is gone.
int resume_sweep(const CommandLine& line);
int command_new(const CommandLine& line);
/// Kinds of decks that `dda new` writes.
std::vector<std::string> deck_template_names();
int command_report(const CommandLine& line);
/// Becomes Python's `ddapath.verify` on `line.runs`; 0 all checks hold, 3 some are refused, 2 no run.
int command_verify(const CommandLine& line);
/// Becomes Python's `ddapath.animation` on `line.runs.front()`; 0 written, 2 nothing to be drawn or wrong options.
int command_animate(const CommandLine& line);

}  // namespace dda
