#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "framework/output/interrupt.hpp"
#include "framework/output/run_folder.hpp"
#include "studies/commands.hpp"
#include "studies/parallel_line.hpp"
#include "studies/processes.hpp"
#include "studies/sweep_figure.hpp"
#include "studies/sweep_files.hpp"
#include "studies/sweep_progress.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Between two looks at the processes; a small part of the shortest run.
constexpr auto pause = std::chrono::milliseconds(10);
constexpr auto between_files = std::chrono::milliseconds(500);

int num_jobs(const CommandLine& line) {
  return line.jobs > 0 ? line.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string last_line_of(const std::string& text) {
  const auto end = text.find_last_not_of(" \n");
  if (end == std::string::npos) return "";
  const auto begin = text.rfind('\n', end);
  return begin == std::string::npos ? text.substr(0, end + 1) : text.substr(begin + 1, end - begin);
}

/// Runs the cases that have no result, so many at a time, and keeps the sweep's files up to date.
class Sweeping {
 public:
  Sweeping(const Sweep& sweep, fs::path folder, std::vector<CaseState> states, const CommandLine& line)
      : sweep_(sweep),
        folder_(std::move(folder)),
        states_(std::move(states)),
        jobs_(static_cast<std::size_t>(num_jobs(line))),
        progress_(sweep, folder_, line.run.quiet) {}

  void run() {
    const InterruptGuard guard;
    write();
    while (!is_over()) {
      if (interrupted() && !is_stopping_) stop();
      const bool has_changed = take_ended() || start_next();
      if (is_due()) write();
      progress_.show(states_);
      if (!has_changed) std::this_thread::sleep_for(pause);
    }
    was_interrupted_ = interrupted() && std::ranges::any_of(states_, is_unfinished);
    write();
    write_sweep_figure(sweep_, folder_, states_);
  }

  const std::vector<CaseState>& states() const { return states_; }
  bool was_interrupted() const { return was_interrupted_; }

 private:
  static bool is_unfinished(const CaseState& state) {
    return state.status == CaseStatus::pending || state.status == CaseStatus::interrupted;
  }

  /// With hundreds of short runs writing after each of them would take a good part of the time.
  bool is_due() const { return has_news_ && Clock::now() - written_at_ >= between_files; }

  void write() {
    write_sweep_files(sweep_, folder_, states_);
    written_at_ = Clock::now();
    has_news_ = false;
  }

  bool is_over() const {
    return processes_.size() == 0 && (is_stopping_ || interrupted() || next() == states_.size());
  }

  /// The first case that has had no process yet and has no result.
  std::size_t next() const {
    std::size_t i = next_;
    while (i < states_.size() && states_[i].has_result()) ++i;
    return i;
  }

  void stop() {
    is_stopping_ = true;
    progress_.note(fmt::format("stopping {} runs", processes_.size()));
    processes_.stop();
  }

  bool start_next() {
    const std::size_t i = next();
    if (is_stopping_ || processes_.size() >= jobs_ || i == states_.size()) return false;
    processes_.start(i, arguments(i));
    states_[i].status = CaseStatus::running;
    next_ = i + 1;
    return true;
  }

  std::vector<std::string> arguments(std::size_t i) const {
    const std::string folder = (folder_ / case_folder(sweep_, i)).string();
    if (states_[i].can_resume) return {"resume", folder, "--quiet"};
    std::vector<std::string> out{"run",        sweep_.cases[i].deck.string(), "--folder", folder, "--quiet",
                                 "--overwrite"};
    for (const std::string& text : sweep_.cases[i].overrides) {
      out.emplace_back("--set");
      out.push_back(text);
    }
    return out;
  }

  bool take_ended() {
    const auto ended = processes_.take_ended();
    if (!ended) return false;
    states_[ended->id] = outcome(*ended);
    progress_.ended(ended->id, states_[ended->id]);
    has_news_ = true;
    return true;
  }

  CaseState outcome(const EndedProcess& ended) const {
    CaseState out = state_of(folder_ / case_folder(sweep_, ended.id));
    const bool has_kept_word = out.has_result() && out.exit_code == ended.exit_code;
    out.exit_code = ended.exit_code;
    if (has_kept_word || (out.status == CaseStatus::interrupted && ended.exit_code == 130)) return out;
    out.summary = Json();
    const bool was_asked = is_stopping_ && (ended.exit_code == 130 || ended.exit_code == 128 + SIGTERM);
    out.status = was_asked ? CaseStatus::interrupted : CaseStatus::failed;
    out.reason = last_line_of(ended.said);
    if (out.reason.empty() && ended.exit_code > 128)
      out.reason =
          fmt::format("ended by signal {}: {}", ended.exit_code - 128, strsignal(ended.exit_code - 128));
    return out;
  }

  const Sweep& sweep_;
  const fs::path folder_;
  std::vector<CaseState> states_;
  const std::size_t jobs_;
  SweepProgress progress_;
  Processes processes_;
  std::size_t next_ = 0;
  Clock::time_point written_at_;
  bool has_news_ = false, is_stopping_ = false, was_interrupted_ = false;
};

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

void announce(const Sweep& sweep, const std::string& parallel, const Earlier& earlier,
              const std::vector<CaseState>& states) {
  if (earlier.has_changed)
    fmt::print(stderr, "{} has changed since: {} of its {} cases were there before\n", sweep.file.string(),
               earlier.num_kept(), sweep.cases.size());
  const auto done = std::ranges::count_if(states, &CaseState::has_result);
  fmt::print(stderr, "{}{}\n{}\n", count_text(states), done > 0 ? "; those with a result stay" : "",
             parallel);
}

int dry_run(const Sweep& sweep, const std::string& parallel, const std::vector<CaseState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i)
    fmt::print("{}  {}{}\n", case_folder(sweep, i).filename().string(), settings_text(sweep, sweep.cases[i]),
               states[i].has_result() ? "  (" + name_of(states[i].status) + " before)"
               : states[i].can_resume ? "  (to be resumed)"
                                      : "");
  fmt::print("{}\n", parallel);
  return 0;
}

}  // namespace

int command_sweep(const CommandLine& line) {
  const auto start = Clock::now();
  if (line.run.profile) throw InputError(Position{"--profile"}, "is for one run, not for a sweep");
  const Sweep sweep = read_sweep(line.deck, line.overrides);
  const fs::path folder = folder_of(line);
  const Earlier earlier = examine(folder, sweep);
  std::vector<CaseState> states = states_of(earlier, line.run.overwrite);
  const std::string parallel = parallel_line(sweep, folder, num_jobs(line));
  if (line.dry_run) return dry_run(sweep, parallel, states);
  if (!line.run.overwrite) refuse_loss(folder, sweep, earlier);
  open_folder(folder, line.run.overwrite);
  const SweepLock lock(folder);
  place_cases(folder, sweep, earlier, line.run.overwrite);
  write_whole(folder / "sweep.yaml", sweep.text, Flush::to_system);
  if (!line.run.quiet) announce(sweep, parallel, earlier, states);
  Sweeping sweeping(sweep, folder, std::move(states), line);
  sweeping.run();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  fmt::print("{}: {}, {}\n", folder.string(), count_text(sweeping.states()), duration_text(seconds));
  return exit_code_of(sweeping.states(), sweeping.was_interrupted());
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
