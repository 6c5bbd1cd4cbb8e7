#pragma once

#include <functional>
#include <iterator>
#include <optional>
#include <string>

#include "continuation/course/path_state.hpp"

namespace dda {

/// The equilibrium path of the followed stages as a range: `for (const Point& p : path)`.
///
/// Common to every control: the first crack is located by the event control; steps are sized by how well the
/// tangent predicted the last one; a step across the limit point is shortened until the peak is bracketed;
/// steps land on wanted gauge values; a converged step that no continuous path explains (its energies do not
/// balance), or that retraces the unloading branch, is rejected; where Newton fails at the smallest step,
/// a jump at the displacement of the load carries on (detour/staggered.hpp); points whose law loses its strength at once are released event by
/// event (detour/release.hpp). The path may have several legs: loading, unloading to a gauge value, loading
/// again, or going on with other loads while those so far are held. The walker must stand at the start of the first
/// stage.
class Path {
 public:
  Path(Walker& walker, const PathParameters& parameters, const GaugeBook& gauges, Route route);

  /// The next accepted point, or nothing at the end; then `ending()` says why.
  std::optional<Point> next();
  const Ending& ending() const { return state_.ending; }
  PathMemory memory() const;
  void restore(const PathMemory& memory);
  /// Asked before each step and within one; true ends the path as interrupted, where it stood before the
  /// step. Steps that have accepted something, and those of running cracks, are taken to their end.
  void interrupt_when(std::function<bool()> asked);
  /// Goes on by the control that its parameters name by now; gauges and route are looked up again. Its first step has the
  /// size that a first step has. Throws InputError for a gauge that there is not.
  void switch_control(const Aims& aims);
  /// Holds the loads as they are and goes on with the next leg, which has loads of its own.
  void begin_next_stage(std::string reason);
  /// Size of the next step in the quantity that the control prescribes; 0 where no step under one has been taken.
  double next_step() const { return state_.memory.step_kind ? state_.memory.step : 0; }
  /// Sets it: above 0, and only where it is known. The path may still shorten it.
  void set_next_step(double size) { state_.memory.step = size; }
  /// Told about every rejected attempt and rescue, for the log.
  void report_to(std::function<void(const std::string& event, const std::string& text)> listener) {
    state_.listener = std::move(listener);
  }
  /// Lets legs begin that have loads of their own.
  void go_on_with(LaterStages stages) { state_.later_stages.emplace(std::move(stages)); }
  /// Lets cracks run through the blocks.
  void run(RunningCracks cracks) { state_.cracks.emplace(std::move(cracks)); }
  /// The load gauge of the path.
  const Functional& load_gauge() const { return state_.load; }
  /// How much of its way the gauge has gone that is nearest to a value which ends the path; 0 without any.
  double share_of_goals() const;
  /// Accepted steps after which the path is stopped early.
  int most_steps() const { return state_.most_steps; }
  /// Whether it has become a mechanism and is one where it stands: under the same load it would move on.
  bool stands_in_mechanism() const;
  /// Stability of the equilibrium at which the walker stands.
  void judge(Point& point) const;

  class Iterator {
   public:
    using iterator_concept = std::input_iterator_tag;
    using difference_type = std::ptrdiff_t;
    using value_type = Point;
    explicit Iterator(Path* path) : path_(path) { ++*this; }
    const Point& operator*() const { return *point_; }
    Iterator& operator++() {
      point_ = path_->next();
      return *this;
    }
    void operator++(int) { ++*this; }
    friend bool operator==(const Iterator& it, std::default_sentinel_t) { return !it.point_; }

   private:
    Path* path_;
    std::optional<Point> point_;
  };
  Iterator begin() { return Iterator(this); }
  std::default_sentinel_t end() const { return {}; }

 private:
  /// The next step; nothing, and nothing changed, where it has been broken off.
  std::optional<Point> take();

  PathState state_;
  std::function<bool()> interrupted_;
  int accepted_before_ =
      -1;  ///< steps before the one that is being taken; −1 where it is not to be broken off
};

}  // namespace dda
