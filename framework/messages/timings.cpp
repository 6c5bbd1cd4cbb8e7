#include "framework/messages/timings.hpp"

#include <fcntl.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace dda {
namespace {

/// Start of this process in clock ticks after the boot: field 22 of /proc/self/stat, see proc(5).
double process_start_ticks() {
  std::ifstream stream("/proc/self/stat");
  std::string text;
  std::getline(stream, text);
  // Field 2 is the program's name in parentheses and may hold anything.
  std::istringstream rest(text.substr(text.rfind(')') + 1));
  std::string field;
  for (int number = 3; number <= 22; ++number) rest >> field;
  return rest ? std::stod(field) : 0.0;
}

double seconds_since_boot() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A process that was something else before it became this program says in DDA_STARTED_AT since when it is.
double start_of_program(double now) {
  const double process = process_start_ticks() / static_cast<double>(sysconf(_SC_CLK_TCK));
  const char* text = std::getenv("DDA_STARTED_AT");
  const double program = text ? std::strtod(text, nullptr) : 0;
  return program > process && program <= now ? program : process;
}

}  // namespace

Timings::Scope Timings::measure(std::string_view phase) {
  charge_running();
  const std::size_t index = index_of(phase);
  running_.push_back(index);
  ++phases_[index].calls;
  return Scope(*this);
}

void Timings::leave() {
  charge_running();
  running_.pop_back();
}

void Timings::charge_running() {
  const Clock::time_point now = Clock::now();
  if (!running_.empty()) {
    phases_[running_.back()].seconds += std::chrono::duration<double>(now - since_).count();
  }
  since_ = now;
}

std::size_t Timings::index_of(std::string_view phase) {
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    if (phases_[i].name == phase) return i;
  }
  phases_.push_back({std::string(phase)});
  return phases_.size() - 1;
}

void Timings::end_start_up() { start_up_ = seconds_since_process_start(); }

double Timings::total() const { return seconds_since_process_start(); }

double seconds_since_process_start() {
  static const double start = start_of_program(seconds_since_boot());
  return seconds_since_boot() - start;
}

}  // namespace dda
