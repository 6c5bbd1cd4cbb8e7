#pragma once

#include <chrono>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dda {

/// What the user sees of one accepted step.
struct ProgressPoint {
  int step = 0;
  double load_factor = 0;
  std::string control;                                 ///< name of the control of this step
  std::vector<std::pair<std::string, double>> gauges;  ///< name and value, the most telling first
  int iterations = 0;
  double step_size = 0;
  double goal = std::numeric_limits<double>::quiet_NaN();     ///< part of the way done, 0 to 1; NaN = unknown
  double seconds = std::numeric_limits<double>::quiet_NaN();  ///< since it began; NaN = not told
};

/// A time that has passed: "12.4 s", from a minute on "0:03:05".
std::string duration_text(double seconds);

/// One line for a step of at most `width` characters: what does not fit is left out, gauges first. As long as
/// nothing of the way is done, as before a peak whose height nobody knows, a mark in the bar moves on with each step.
std::string progress_line(const ProgressPoint& point, std::size_t width);

/// The text cut to so many characters on the screen.
std::string clipped(const std::string& text, std::size_t width);

/// Characters that a line of a terminal takes; 79 of what is no terminal.
std::size_t line_width(std::FILE* stream);

/// Shows a run while it goes: one line that renews itself on a terminal, plain lines elsewhere, nothing when
/// quiet.
class Progress {
 public:
  enum class Style { live, lines, quiet };

  /// Style by what the stream is: live on a terminal, plain lines in a file or pipe.
  static Progress for_stream(std::FILE* stream, bool quiet);
  Progress(std::FILE* stream, Style style);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// With the time since this was made.
  void show(ProgressPoint point);
  /// Whether every line stays: then some steps of very many are enough.
  bool keeps_lines() const { return style_ == Style::lines; }
  /// A line that stays, above the live line.
  void note(std::string_view text);
  /// Ends the live line; the last one shown stays.
  void finish();

 private:
  std::FILE* stream_;
  Style style_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::size_t shown_ = 0;  ///< characters of the live line now on the terminal
};

}  // namespace dda
