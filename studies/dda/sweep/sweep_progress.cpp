#include "studies/dda/sweep/sweep_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "framework/messages/tell.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_between_tables = 0.25;
constexpr std::streamoff longest_row = 4096;

/// The last whole line of a table that another process is writing; "" when there is none but its header.
std::string last_row(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(0, size - longest_row));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto end = text.rfind('\n');
  const auto begin = end == std::string::npos || end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  return begin == std::string::npos ? "" : text.substr(begin + 1, end - begin - 1);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Progress::Style style_of(bool quiet) {
  if (quiet) return Progress::Style::quiet;
  return isatty(fileno(stderr)) == 1 ? Progress::Style::live : Progress::Style::lines;
}

std::string outcome(const CaseState& state) {
  std::string out = name_of(state.status) + (state.reason.empty() ? "" : " (" + state.reason + ")");
  if (!state.summary.is_object()) return out;
  if (const auto peak = state.summary.find("peak"); peak != state.summary.end() && peak->contains("load"))
    out += fmt::format(" — peak {:.6g}", (*peak)["load"].get<double>());
  return out + fmt::format(", {} steps", state.summary.value("steps", 0));
}

}  // namespace

std::string last_step(const fs::path& run_folder) {
  const std::string row = last_row(run_folder / "curve.csv");
  return row.substr(0, row.find(','));
}

std::string count_text(const std::vector<CaseState>& states) {
  std::string out = fmt::format("{} case{}: ", states.size(), states.size() == 1 ? "" : "s");
  const char* separator = "";
  for (const CaseStatus status : {CaseStatus::goal_reached, CaseStatus::stopped_early, CaseStatus::failed,
                                  CaseStatus::interrupted, CaseStatus::running, CaseStatus::pending}) {
    const auto count = std::ranges::count(states, status, &CaseState::status);
    if (count == 0) continue;
    out += fmt::format("{}{} {}", separator, count, name_of(status));
    separator = ", ";
  }
  return out;
}

SweepProgress::SweepProgress(const Sweep& sweep, fs::path folder, bool quiet)
    : sweep_(sweep),
      folder_(std::move(folder)),
      style_(style_of(quiet)),
      start_(std::chrono::steady_clock::now()) {}

SweepProgress::~SweepProgress() { clear(); }

void SweepProgress::clear() {
  if (lines_ > 0) tell(stderr, "\033[{}A\r\033[J", lines_);  // up to its first line, erase downwards
  lines_ = 0;
  std::fflush(stderr);
}

void SweepProgress::note(const std::string& text) {
  if (style_ == Progress::Style::quiet) return;
  clear();
  tell(stderr, "{}\n", text);
}

void SweepProgress::ended(std::size_t index, const CaseState& state) {
  note(fmt::format("{}  {}  {}", case_folder(sweep_, index).filename().string(),
                   settings_text(sweep_, sweep_.cases[index]), outcome(state)));
}

std::string SweepProgress::running_line(const SweepCases& cases, std::size_t index) const {
  const fs::path name = case_folder(sweep_, index);
  const std::string step = last_step(folder_ / name), holder = cases.holder_of(index);
  return fmt::format("  {}  {}{}{}", name.filename().string(), settings_text(sweep_, sweep_.cases[index]),
                     step.empty() ? "" : "  step " + step, holder.empty() ? "" : "  by " + holder);
}

void SweepProgress::show(const SweepCases& cases) {
  if (style_ != Progress::Style::live || seconds_since(shown_at_) < seconds_between_tables) return;
  clear();
  const std::vector<CaseState>& states = cases.states();
  const std::size_t width = line_width(stderr);
  const auto line = [&](const std::string& text) {
    tell(stderr, "{}\n", clipped(text, width));
    ++lines_;
  };
  line(fmt::format("{}  {}", count_text(states), duration_text(seconds_since(start_))));
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i].status == CaseStatus::running) line(running_line(cases, i));
  std::fflush(stderr);
  shown_at_ = std::chrono::steady_clock::now();
}

}  // namespace dda
