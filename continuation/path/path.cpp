#include "continuation/path/path.hpp"

#include <fmt/format.h>

#include <utility>

#include "continuation/follow/branch.hpp"
#include "continuation/follow/goals.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/path/take_step.hpp"

namespace dda {
namespace {

/// What a step changes before it accepts anything, to be put back. The point before the last stays where it is, and so
/// does the history but for its flags: only an accepted step replaces them.
class BeforeStep {
 public:
  explicit BeforeStep(PathState& path) : effort_(path.walker.effort()) {
    auto point = std::exchange(path.memory.before, {});
    memory_ = path.memory;
    path.memory.before = std::move(point);
    for (const History& h : path.walker.system().history()) {
      loading_.push_back(h.loading);
      sliding_.push_back(h.sliding);
    }
  }
  void put_back(PathState& path) {
    memory_.before = std::move(path.memory.before);
    path.memory = std::move(memory_);
    path.walker.effort() = effort_;
    std::vector<History> history = path.walker.here().history;
    for (std::size_t p = 0; p < history.size(); ++p) {
      history[p].loading = loading_[p];
      history[p].sliding = sliding_[p];
    }
    path.walker.system().set_history(std::move(history));
    path.walker.system().set_multipliers(path.walker.state().multipliers);
  }

 private:
  PathMemory memory_;
  Effort effort_;
  std::vector<bool> loading_, sliding_;
};

}  // namespace

Path::Path(Walker& walker, const PathParameters& parameters, const GaugeBook& gauges, Route route)
    : state_(walker, parameters, gauges, std::move(route)) {
  set_out(state_);
}

bool Path::stands_in_mechanism() const { return state_.memory.is_mechanism && moves_freely(state_); }

PathMemory Path::memory() const {
  PathMemory out = state_.memory;
  out.control = state_.control->memory();
  return out;
}

void Path::restore(const PathMemory& memory) {
  auto here = std::move(state_.memory.travels);
  state_.memory = memory;
  state_.memory.travels.merge(here);  // gauges that the deck did not have before
  state_.control->restore(memory.control);
  set_heading(state_);
}

void Path::switch_control(const Aims& aims) {
  state_.control.reset();
  state_.look_up(aims);
  state_.memory.step = 0;
  state_.memory.step_kind.reset();
}

void Path::begin_next_stage(std::string reason) { begin_stage(state_, std::move(reason)); }

void Path::interrupt_when(std::function<bool()> asked) {
  interrupted_ = std::move(asked);
  state_.walker.stepper().break_off_when(
      [this] { return interrupted_() && state_.walker.effort().accepted == accepted_before_; });
}

std::optional<Point> Path::take() {
  if (state_.cracks || !interrupted_) return take_step(state_);
  accepted_before_ = state_.walker.effort().accepted;
  BeforeStep before(state_);
  try {
    return take_step(state_);
  } catch (const BrokenOff&) {
    before.put_back(state_);
    return state_.end(Ending::Kind::interrupted, "interrupted");
  } catch (...) {
    if (state_.walker.effort().accepted == accepted_before_) before.put_back(state_);
    throw;
  }
}

double Path::share_of_goals() const { return dda::share_of_goals(state_); }

void Path::judge(Point& point) const { judge_stability(state_, point); }

std::optional<Point> Path::next() {
  settle(state_);
  if (state_.ending.kind != Ending::Kind::running) return {};
  if (interrupted_ && interrupted_()) return state_.end(Ending::Kind::interrupted, "interrupted");
  if (state_.walker.effort().accepted >= state_.most_steps)
    return state_.stop_early(Stop::limit_of_steps,
                             fmt::format("the limit of {} steps is reached; `path.stop.steps` raises it, "
                                         "`path.stop.after_steps` makes a number of steps the goal",
                                         state_.most_steps));
  begin_stages(state_);
  if (state_.ending.kind != Ending::Kind::running) return {};
  state_.unsound.reset();
  auto point = take();
  state_.unsound.reset();
  if (!point) return {};
  note_travel(state_);
  settle(state_);
  look_for_standstill(state_, *point);
  return point;
}

}  // namespace dda
