#include "framework/messages/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "framework/messages/tell.hpp"

namespace dda {
namespace {

constexpr std::size_t bar_cells = 10;
constexpr std::size_t default_width = 80;

std::string bar(const ProgressPoint& point) {
  if (std::isnan(point.goal)) return "";
  const double part = std::clamp(point.goal, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(part * static_cast<double>(bar_cells));
  std::string cells = std::string(full, '#') + std::string(bar_cells - full, '.');
  if (full == 0) cells[static_cast<std::size_t>(point.step) % bar_cells] = '>';
  return fmt::format("  [{}] {:3.0f}%", cells, std::floor(100 * part));
}

std::string head(const ProgressPoint& point) {
  return fmt::format("step {:4}  λ {:<10.5g}", point.step, point.load_factor);
}

/// Characters on the screen: UTF-8 continuation bytes take no room.
std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(seconds);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string clipped(const std::string& text, std::size_t width) {
  std::string result;
  std::size_t used = 0;
  for (const char c : text) {
    if ((c & 0xC0) != 0x80 && ++used > width) break;
    result += c;
  }
  return result;
}

std::size_t line_width(std::FILE* stream) {
  winsize size{};
  const bool is_terminal = ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col >= 2;
  return (is_terminal ? size.ws_col : default_width) - 1u;  // the last column would wrap on some terminals
}

std::string progress_line(const ProgressPoint& point, std::size_t width) {
  std::string front = head(point);
  const std::string end = bar(point) + (std::isnan(point.seconds) ? "" : "  " + duration_text(point.seconds));
  const std::string how = fmt::format("  {:2} it.  ds {:<9.3g}", point.iterations, point.step_size);
  const std::string control = point.control.empty() ? "" : fmt::format("  {}", point.control);
  const auto fits = [&](const std::string& more) {
    return length(front) + length(more) + length(end) <= width;
  };
  const std::string tail = fits(how + control) ? how + control : fits(how) ? how : "";
  for (const auto& [name, value] : point.gauges) {
    const std::string gauge = fmt::format("  {} {:<10.4g}", name, value);
    if (!fits(gauge + tail)) break;
    front += gauge;
  }
  return clipped(front + tail + end, width);
}

Progress Progress::for_stream(std::FILE* stream, bool quiet) {
  if (quiet) return {stream, Style::quiet};
  return {stream, isatty(fileno(stream)) == 1 ? Style::live : Style::lines};
}

Progress::Progress(std::FILE* stream, Style style) : stream_(stream), style_(style) {}

Progress::~Progress() { finish(); }

void Progress::show(ProgressPoint point) {
  if (style_ == Style::quiet) return;
  point.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  if (style_ == Style::lines) {
    tell(stream_, "{}\n", progress_line(point, 160));
  } else {
    const std::string line = progress_line(point, line_width(stream_));
    const std::size_t now = length(line);
    tell(stream_, "\r{}{}", line, std::string(shown_ > now ? shown_ - now : 0, ' '));
    shown_ = now;
  }
  std::fflush(stream_);
}

void Progress::note(std::string_view text) {
  if (style_ == Style::quiet) return;
  if (shown_ > 0) tell(stream_, "\r{}\r", std::string(shown_, ' '));
  shown_ = 0;
  tell(stream_, "{}\n", text);
  std::fflush(stream_);
}

void Progress::finish() {
  if (shown_ > 0) std::fputc('\n', stream_);
  shown_ = 0;
  std::fflush(stream_);
}

}  // namespace dda
