#include "studies/dda/sweep/sweep_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <thread>

#include "framework/messages/interrupt.hpp"
#include "studies/dda/sweep/case_command.hpp"
#include "studies/dda/sweep/sweep_figure.hpp"
#include "studies/dda/sweep/sweep_files.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// Between two looks at the processes; a small part of the shortest run.
constexpr auto pause = std::chrono::milliseconds(10);
constexpr auto between_files = std::chrono::milliseconds(500);

constexpr int signal_base = 128;  ///< exit code of a process that a signal ended, less the signal

std::string last_line_of(const std::string& text) {
  const auto end = text.find_last_not_of(" \n");
  if (end == std::string::npos) return "";
  const auto begin = text.rfind('\n', end);
  return begin == std::string::npos ? text.substr(0, end + 1) : text.substr(begin + 1, end - begin);
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

SweepRunner::SweepRunner(const Sweep& sweep, fs::path folder, std::vector<CaseState> states,
                         const SweepOptions& options)
    : sweep_(sweep),
      folder_(std::move(folder)),
      states_(std::move(states)),
      jobs_(static_cast<std::size_t>(options.jobs)),
      progress_(sweep, folder_, options.quiet) {}

void SweepRunner::run() {
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

/// With hundreds of short runs writing after each of them would take a good part of the time.
bool SweepRunner::is_due() const { return has_news_ && Clock::now() - written_at_ >= between_files; }

void SweepRunner::write() {
  write_sweep_files(sweep_, folder_, states_);
  written_at_ = Clock::now();
  has_news_ = false;
}

bool SweepRunner::is_over() const {
  return processes_.size() == 0 && (is_stopping_ || interrupted() || next() == states_.size());
}

/// The first case that has had no process yet and has no result.
std::size_t SweepRunner::next() const {
  std::size_t i = next_;
  while (i < states_.size() && states_[i].has_result()) ++i;
  return i;
}

void SweepRunner::stop() {
  is_stopping_ = true;
  progress_.note(fmt::format("stopping {} runs", processes_.size()));
  processes_.stop();
}

bool SweepRunner::start_next() {
  const std::size_t i = next();
  if (is_stopping_ || processes_.size() >= jobs_ || i == states_.size()) return false;
  processes_.start(i, case_command(sweep_, folder_, i, states_[i].can_resume));
  states_[i].status = CaseStatus::running;
  next_ = i + 1;
  has_news_ = true;
  return true;
}

bool SweepRunner::take_ended() {
  const auto ended = processes_.take_ended();
  if (!ended) return false;
  states_[ended->id] = outcome(*ended);
  progress_.ended(ended->id, states_[ended->id]);
  has_news_ = true;
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
