#include "studies/dda/sweep/sweep_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <sstream>
#include <thread>

#include "framework/messages/interrupt.hpp"
#include "studies/dda/sweep/case_command.hpp"
#include "studies/dda/sweep/processes/keeper.hpp"
#include "studies/dda/sweep/sweep_figure.hpp"
#include "studies/dda/sweep/sweep_files.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// Between two looks at the processes; a small part of the shortest run.
constexpr auto pause = std::chrono::milliseconds(10);
constexpr auto between_files = std::chrono::milliseconds(500);
constexpr int part_of_writing = 20;  ///< one of so many parts of the time at most goes into writing files
/// Between two looks at what other processes do.
constexpr auto between_looks = std::chrono::seconds(1);

constexpr int signal_base = 128;  ///< exit code of a process that a signal ended, less the signal

/// Lines of a file that a message shows begin with a space, and are none of its own.
std::string last_line_of(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line.front() != ' ') last = line.substr(0, line.find_last_not_of(' ') + 1);
  return last;
}

/// The last line that a failed run said, or what ended it.
std::string reason_of(const EndedProcess& ended) {
  const std::string said = last_line_of(ended.said);
  if (!said.empty()) return said;
  const int signal = ended.exit_code - signal_base;
  return signal > 0 ? fmt::format("ended by signal {}: {}", signal, strsignal(signal))
                    : fmt::format("ended with exit code {} and said nothing", ended.exit_code);
}

bool is_unfinished(const CaseState& state) {
  return state.status == CaseStatus::pending || state.status == CaseStatus::interrupted;
}

}  // namespace

SweepRunner::SweepRunner(const Sweep& sweep, fs::path folder, SweepCases& cases, const SweepOptions& options)
    : sweep_(sweep),
      folder_(std::move(folder)),
      cases_(cases),
      options_(options),
      progress_(sweep, folder_, options.quiet) {}

void SweepRunner::run() {
  const InterruptGuard guard;
  write();
  for (;;) {
    if (interrupted() && !is_stopping_) stop();
    const bool has_changed = take_ended() || start_next();
    look();
    if (has_news_ && Clock::now() >= may_write_at_) write();
    progress_.show(cases_);
    if (has_changed) continue;
    if (is_over()) break;
    std::this_thread::sleep_for(pause);
  }
  cases_.let_go();
  was_interrupted_ = interrupted() && std::ranges::any_of(states(), is_unfinished);
  finish();
}

/// To be asked when there is nothing to start.
bool SweepRunner::is_over() {
  if (processes_.size() > 0) return false;
  return is_stopping_ || cases_.are_over() || (options_.may_leave && !cases_.wait_for_all());
}

void SweepRunner::look() {
  if (Clock::now() - looked_at_ < between_looks) return;
  has_news_ = cases_.refresh() || has_news_;
  looked_at_ = Clock::now();
}

/// With hundreds of short runs writing after each of them would take a good part of the time.
void SweepRunner::write() {
  if (!options_.writes_files) return;
  const auto start = Clock::now();
  write_sweep_files(sweep_, folder_, states());
  const auto end = Clock::now();
  may_write_at_ = end + std::max<Clock::duration>(between_files, part_of_writing * (end - start));
  has_news_ = false;
}

/// While this process writes others may end cases and write, too; whoever writes last has seen them all.
void SweepRunner::finish() {
  if (!options_.writes_files) return;
  cases_.refresh();
  do {
    write();
    write_sweep_figure(sweep_, folder_, states());
  } while (cases_.refresh());
}

void SweepRunner::stop() {
  is_stopping_ = true;
  progress_.note(fmt::format("stopping {} runs", processes_.size()));
  processes_.stop();
}

bool SweepRunner::start_next() {
  if (is_stopping_ || processes_.size() >= static_cast<std::size_t>(options_.jobs)) return false;
  const auto taken = cases_.take_next();
  if (!taken) return false;
  const auto command = case_command(sweep_, folder_, *taken, states()[*taken].can_resume);
  processes_.start(*taken, command, cases_.claims(), cases_.claim(*taken));
  has_news_ = true;
  return true;
}

bool SweepRunner::take_ended() {
  const auto ended = processes_.take_ended();
  if (!ended) return false;
  has_news_ = true;
  if (ended->exit_code == exit_code_of_lost_claim) {
    cases_.lose(ended->id);
    progress_.note(
        fmt::format("{}  another process has taken over", case_folder(sweep_, ended->id).string()));
    return true;
  }
  cases_.end(ended->id, outcome(*ended));
  progress_.ended(ended->id, states()[ended->id]);
  return true;
}

CaseState SweepRunner::outcome(const EndedProcess& ended) const {
  CaseState out = state_of(folder_ / case_folder(sweep_, ended.id));
  const bool has_kept_word = out.has_result() && out.exit_code == ended.exit_code;
  out.exit_code = ended.exit_code;
  if (has_kept_word || (out.status == CaseStatus::interrupted && ended.exit_code == 130)) return out;
  out.summary = Json();
  const bool was_asked = is_stopping_ && (ended.exit_code == 130 || ended.exit_code == signal_base + SIGTERM);
  out.status = was_asked ? CaseStatus::interrupted : CaseStatus::failed;
  out.reason = reason_of(ended);
  return out;
}

}  // namespace dda
