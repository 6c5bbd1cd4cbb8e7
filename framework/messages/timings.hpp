#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dda {

/// Where the wall-clock time of a run goes, by named phase.
///
///     Timings timings;
///     { auto scope = timings.measure("factorise"); ... }
///
/// A phase inside another one takes its time away from it, so that the phases add up to at most the total.
/// One thread only.
class Timings {
 public:
  class Scope {
   public:
    explicit Scope(Timings& owner) : owner_(&owner) {}
    ~Scope() { owner_->leave(); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Timings* owner_;
  };

  struct Phase {
    std::string name;
    double seconds = 0;  ///< without the phases inside it
    std::int64_t calls = 0;
  };

  /// Counts until the returned scope ends.
  [[nodiscard]] Scope measure(std::string_view phase);
  /// In the order of their first call.
  const std::vector<Phase>& phases() const { return phases_; }
  /// Marks the end of start-up: everything between the start of the process and the first useful work.
  void end_start_up();
  double start_up() const { return start_up_; }
  /// Since the start of the process [s].
  double total() const;

 private:
  using Clock = std::chrono::steady_clock;
  void leave();
  void charge_running();
  std::size_t index_of(std::string_view phase);

  std::vector<Phase> phases_;
  std::vector<std::size_t> running_;
  Clock::time_point since_;
  double start_up_ = 0;
};

/// Wall-clock time since the operating system started this process [s], loading of libraries included.
double seconds_since_process_start();

}  // namespace dda
