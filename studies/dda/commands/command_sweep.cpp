#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "framework/files/whole_file.hpp"
#include "framework/messages/tell.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/sweep/case_command.hpp"
#include "studies/dda/sweep/sweep_cases.hpp"
#include "studies/dda/sweep/sweep_entrance.hpp"
#include "studies/dda/sweep/sweep_progress.hpp"
#include "studies/dda/sweep/sweep_runner.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

int num_jobs(const CommandLine& line) {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  return line.jobs > 0 ? line.jobs : std::max(1, processors / ranks_of_processes());
}

/// 130 interrupted, 4 a run broke, 2 a run refused its deck, 3 a run stopped early, 0 all reached their goals; those
/// that other processes still run do not count.
int exit_code_of(const std::vector<CaseState>& states, bool was_interrupted) {
  if (was_interrupted) return 130;
  const auto failed_with = [&](auto is) {
    return std::ranges::any_of(states, [&](const CaseState& state) {
      return state.status == CaseStatus::failed && is(state.exit_code.value_or(4));
    });
  };
  if (failed_with([](int code) { return code != 2; })) return 4;
  if (failed_with([](int code) { return code == 2; })) return 2;
  const auto is_good = [](const CaseState& state) {
    return state.status == CaseStatus::goal_reached || state.status == CaseStatus::running;
  };
  return std::ranges::all_of(states, is_good) ? 0 : 3;
}

/// What each case will be: its earlier result, the rest of an interrupted run, or a run.
std::vector<CaseState> states_of(const Earlier& earlier, bool overwrite) {
  std::vector<CaseState> out;
  for (const fs::path& folder : earlier.kept)
    out.push_back(folder.empty() || overwrite ? CaseState{} : state_of(folder));
  return out;
}

void announce_change(const Sweep& sweep, const Earlier& earlier) {
  if (earlier.has_changed)
    tell(stderr, "{} has changed since: {} of its {} cases were there before\n", sweep.file.string(),
         earlier.num_kept(), sweep.cases.size());
}

void announce(const std::vector<CaseState>& states, const std::string& by_cases) {
  const auto done = std::ranges::count_if(states, &CaseState::has_result);
  tell(stderr, "{}{}\n{}\n", count_text(states), done > 0 ? "; those with a result stay" : "", by_cases);
}

int dry_run(const Sweep& sweep, const std::string& by_cases, const std::vector<CaseState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i)
    fmt::print("{}  {}{}\n", case_folder(sweep, i).filename().string(), settings_text(sweep, sweep.cases[i]),
               states[i].has_result() ? "  (" + name_of(states[i].status) + " before)"
               : states[i].can_resume ? "  (to be resumed)"
                                      : "");
  fmt::print("{}\n", by_cases);
  return 0;
}

void refuse_wrong_case(const Sweep& sweep, const Earlier& earlier, int number) {
  if (static_cast<std::size_t>(number) > sweep.cases.size())
    throw InputError(Position{"--case"},
                     fmt::format("the sweep has {} cases, there is no case {}", sweep.cases.size(), number));
  if (earlier.has_changed)
    throw InputError(
        Position{sweep.file.string()},
        "has changed since the sweep began; `dda sweep` without --case first gives the cases their folders");
}

/// Runs one case, 1 the first; many at a time do no harm, each having its claim.
int run_case(const Sweep& sweep, const fs::path& folder, const CommandLine& line) {
  const std::size_t index = static_cast<std::size_t>(line.only_case) - 1;
  const SharedSweep& shared = line.shared;
  SweepCases cases(sweep, folder, enter_sweep(folder, sweep, {.lease = shared.lease}),
                   {shared.attempt, index});
  if (const std::string holder = cases.holder_of(index); !holder.empty())
    throw InputError(Position{(folder / case_folder(sweep, index)).string()},
                     fmt::format("{} is running this case", holder));
  SweepRunner runner(sweep, folder, cases, {.quiet = line.run.quiet, .writes_files = false});
  runner.run();
  const CaseState& state = cases.states()[index];
  tell(state.status == CaseStatus::failed ? stderr : stdout, "{}: {}{}\n",
       (folder / case_folder(sweep, index)).string(), name_of(state.status),
       state.reason.empty() ? "" : ", " + state.reason);
  return runner.was_interrupted() ? 130 : state.exit_code.value_or(4);
}

int run_all(const Sweep& sweep, const fs::path& folder, const CommandLine& line) {
  const auto start = Clock::now();
  const SharedSweep& shared = line.shared;
  SweepCases cases(sweep, folder, enter_sweep(folder, sweep, {line.run.overwrite, shared.lease}),
                   {.attempt = shared.attempt});
  if (!line.run.quiet) announce(cases.states(), line_of_cases(sweep, folder, num_jobs(line)));
  SweepRunner runner(sweep, folder, cases,
                     {.jobs = num_jobs(line), .quiet = line.run.quiet, .may_leave = shared.may_leave});
  runner.run();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  fmt::print("{}: {}, {}\n", folder.string(), count_text(cases.states()), duration_text(seconds));
  return exit_code_of(cases.states(), runner.was_interrupted());
}

}  // namespace

fs::path sweep_folder_of(const CommandLine& line) {
  const fs::path& named = line.run.folder;
  if (named.empty()) return default_sweep_folder(line.deck);
  return named.has_filename() ? named : named.parent_path();
}

int command_sweep(const CommandLine& line) {
  if (line.run.profile) throw InputError(Position{"--profile"}, "is for one run, not for a sweep");
  if (line.shared.status) return sweep_status(line);
  const Sweep sweep = read_sweep(line.deck, line.overrides);
  const fs::path folder = sweep_folder_of(line);
  const Earlier earlier = examine(folder, sweep);
  if (line.only_case > 0) {
    refuse_wrong_case(sweep, earlier, line.only_case);
    return run_case(sweep, folder, line);
  }
  if (!line.run.overwrite) refuse_loss(folder, sweep, earlier);
  if (line.dry_run)
    return dry_run(sweep, line_of_cases(sweep, folder, num_jobs(line)),
                   states_of(earlier, line.run.overwrite));
  const SharedSweep& shared = line.shared;
  if (!shared.launcher.empty() || shared.submit || !shared.hosts.empty())
    return launch_sweep(sweep, folder, line);
  if (!line.run.quiet) announce_change(sweep, earlier);
  return run_all(sweep, folder, line);
}

int resume_sweep(const CommandLine& line) {
  const fs::path file = line.runs.front() / "sweep.json";
  const Json before = Json::parse(read_whole(file), nullptr, false);
  if (!before.is_object() || !before.contains("file"))
    throw InputError(Position{file.string()}, "names no file");
  CommandLine again = line;
  again.deck = fs::proximate(before["file"].get<std::string>());
  if (!fs::exists(again.deck)) again.deck = line.runs.front() / "sweep.yaml";
  again.overrides = before.value("overrides", std::vector<std::string>{});
  std::ranges::copy(line.overrides, std::back_inserter(again.overrides));
  if (!line.run.folder.empty())
    throw InputError(Position{"--folder"}, "a sweep is resumed in its own folder");
  again.run.folder = line.runs.front();
  return command_sweep(again);
}

}  // namespace dda
