#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "framework/files/whole_file.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/sweep/case_command.hpp"
#include "studies/dda/sweep/processes.hpp"
#include "studies/dda/sweep/sweep_progress.hpp"
#include "studies/dda/sweep/sweep_runner.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

int num_jobs(const CommandLine& line) {
  return line.jobs > 0 ? line.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// 130 interrupted, 4 a run broke, 2 a run refused its deck, 3 a run stopped early, 0 all reached their
/// goals.
int exit_code_of(const std::vector<CaseState>& states, bool was_interrupted) {
  if (was_interrupted) return 130;
  const auto failed_with = [&](auto is) {
    return std::ranges::any_of(states, [&](const CaseState& state) {
      return state.status == CaseStatus::failed && is(state.exit_code.value_or(4));
    });
  };
  if (failed_with([](int code) { return code != 2; })) return 4;
  if (failed_with([](int code) { return code == 2; })) return 2;
  return std::ranges::any_of(states, [](const CaseState& s) { return s.status != CaseStatus::goal_reached; })
             ? 3
             : 0;
}

fs::path folder_of(const CommandLine& line) {
  const fs::path& named = line.run.folder;
  if (named.empty()) return default_sweep_folder(line.deck);
  return named.has_filename() ? named : named.parent_path();
}

/// What each case will be: its earlier result, the rest of an interrupted run, or a run.
std::vector<CaseState> states_of(const Earlier& earlier, bool overwrite) {
  std::vector<CaseState> out;
  for (const fs::path& folder : earlier.kept)
    out.push_back(folder.empty() || overwrite ? CaseState{} : state_of(folder));
  return out;
}

void announce(const Sweep& sweep, const std::string& by_cases, const Earlier& earlier,
              const std::vector<CaseState>& states) {
  if (earlier.has_changed)
    fmt::print(stderr, "{} has changed since: {} of its {} cases were there before\n", sweep.file.string(),
               earlier.num_kept(), sweep.cases.size());
  const auto done = std::ranges::count_if(states, &CaseState::has_result);
  fmt::print(stderr, "{}{}\n{}\n", count_text(states), done > 0 ? "; those with a result stay" : "",
             by_cases);
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

/// Becomes the run of one case, 1 the first; many at a time do no harm, each having its own folder.
int run_case(const Sweep& sweep, const fs::path& folder, const Earlier& earlier, int number) {
  const std::size_t count = sweep.cases.size(), index = static_cast<std::size_t>(number) - 1;
  if (index >= count)
    throw InputError(Position{"--case"},
                     fmt::format("the sweep has {} cases, there is no case {}", count, number));
  if (earlier.has_changed)
    throw InputError(
        Position{sweep.file.string()},
        "has changed since the sweep began; `dda sweep` without --case first gives the cases their folders");
  const CaseState state = state_of(folder / case_folder(sweep, index));
  if (state.has_result()) return state.exit_code.value_or(0);
  become(case_command(sweep, folder, index, state.can_resume));
}

}  // namespace

int command_sweep(const CommandLine& line) {
  const auto start = Clock::now();
  if (line.run.profile) throw InputError(Position{"--profile"}, "is for one run, not for a sweep");
  const Sweep sweep = read_sweep(line.deck, line.overrides);
  const fs::path folder = folder_of(line);
  const Earlier earlier = examine(folder, sweep);
  if (line.only_case > 0) return run_case(sweep, folder, earlier, line.only_case);
  std::vector<CaseState> states = states_of(earlier, line.run.overwrite);
  if (!line.run.overwrite) refuse_loss(folder, sweep, earlier);
  const std::string by_cases = line_of_cases(sweep, folder, num_jobs(line));
  if (line.dry_run) return dry_run(sweep, by_cases, states);
  open_folder(folder, line.run.overwrite);
  const auto lock = lock_sweep(folder);
  place_cases(folder, sweep, earlier, line.run.overwrite);
  write_whole(folder / "sweep.yaml", sweep.text, Flush::to_system);
  if (!line.run.quiet) announce(sweep, by_cases, earlier, states);
  SweepRunner runner(sweep, folder, std::move(states), {num_jobs(line), line.run.quiet});
  runner.run();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  fmt::print("{}: {}, {}\n", folder.string(), count_text(runner.states()), duration_text(seconds));
  return exit_code_of(runner.states(), runner.was_interrupted());
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
