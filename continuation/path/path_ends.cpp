// Where a path has reached what it was to reach: decided here alone, of the equilibrium at which the walker
// stands, whatever has led to it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/path/advice.hpp"
#include "continuation/path/path.hpp"

namespace dda {
namespace {

/// What is true of a load that has fallen below a share of its peak; a jump may have turned it round.
std::string fallen_load(double share, double now) {
  std::string text = fmt::format("load below {:g} % of its peak", 100 * share);
  return now < -same_value ? fmt::format("{}, turned round to {:g} %", text, 100 * now) : text;
}

}  // namespace

/// A leg begins: gauges travel from here.
void Path::set_out() {
  memory_.travels.clear();
  for (const NamedGauge& gauge : travelling_) {
    const double now = walker_.value(gauge.functional);
    memory_.travels[gauge.name] = {now, now};
  }
  memory_.leg_peak = load_of(walker_.state());
}

void Path::note_travel() {
  memory_.leg_peak = std::max(memory_.leg_peak, load_of(walker_.state()));
  for (const NamedGauge& gauge : travelling_) {
    const double now = walker_.value(gauge.functional);
    Travel& travel = memory_.travels[gauge.name];
    if (std::abs(now - travel.from) > std::abs(travel.farthest - travel.from)) travel.farthest = now;
  }
}

/// What is true of the present equilibrium if a gauge stands at a goal or, as it came, beyond it; else "". A
/// gauge that has set out from the goal must have left it and come back.
std::string Path::reached(const Landing& goal) const {
  const Travel& travel = memory_.travels.at(goal.name);
  const double now = walker_.value(goal.gauge), way = travel.farthest - travel.from;
  const double on_it = same_value * std::max(std::abs(goal.value), std::abs(way));
  double side = goal.value - travel.from;
  if (std::abs(side) <= on_it) side = -way;
  if (side == 0 || (now - goal.value) * std::copysign(1, side) < -on_it) return {};
  if (std::abs(now - goal.value) <= on_it) return fmt::format("{} reached {}", goal.name, goal.value);
  return fmt::format("{} reached {} and stands at {}", goal.name, goal.value, now);
}

/// Whether no load is left of a structure that has cracked.
bool Path::has_ruptured() const {
  constexpr double nothing = 1e-6;
  const bool at_leg_start = memory_.leg > 0 && walker_.effort().accepted == memory_.leg_start;
  return !leg().unloads && !at_leg_start && memory_.peak_load > 0 && walker_.here().dissipated > 0 &&
         std::abs(load_of(walker_.state())) <= nothing * memory_.peak_load;
}

/// Which of the stopping rules is met here; "" when none is.
std::string Path::goal_of_path() const {
  for (const Landing& landing : landings_)
    if (landing.ends_leg)
      if (std::string text = reached(landing); !text.empty()) return text;
  const StopRules& stop = parameters_.stop;
  if (const double target = stop.load_below * memory_.peak_load * (1 + same_value);
      target > 0 && is_last_leg() && !leg().unloads && memory_.leg_peak > std::max(target, smallest_load()) &&
      load_of(walker_.state()) <= target)
    return fallen_load(stop.load_below, load_of(walker_.state()) / memory_.peak_load);
  if (has_ruptured()) return "complete rupture";
  return {};
}

double Path::share_of_goals() const {
  double share = 0;
  for (const Landing& landing : landings_) {
    const double from = memory_.travels.at(landing.name).from, way = landing.value - from;
    if (landing.ends_leg && way != 0) share = std::max(share, (walker_.value(landing.gauge) - from) / way);
  }
  return share;
}

/// Ends the path where it has reached its goal, and begins the next leg where only the leg has.
void Path::settle() {
  while (ending_.kind == Ending::Kind::running) {
    if (std::string text = goal_of_path(); !text.empty()) {
      end(Ending::Kind::goal_reached, std::move(text));
      return;
    }
    const auto& until = leg().until;
    const auto goal =
        std::ranges::find_if(until, [&](const Landing& landing) { return !reached(landing).empty(); });
    if (goal == until.end()) break;
    if (is_last_leg())
      end(Ending::Kind::goal_reached, reached(*goal));
    else
      begin_next_leg();
  }
  const int wanted = parameters_.stop.after_steps;
  if (ending_.kind == Ending::Kind::running && wanted > 0 && walker_.effort().accepted >= wanted)
    end(Ending::Kind::goal_reached, fmt::format("{} steps", walker_.effort().accepted));
}

/// Ends the path where nothing changes any more.
void Path::look_for_standstill(const Point& point) {
  const Candidate& here = walker_.here();
  const bool is_rescue = point.control == "sequentially_linear";
  const std::string since =
      standstill_.add({here.state.d, here.state.load_factor, here.dissipated, is_rescue});
  if (ending_.kind != Ending::Kind::running || since.empty()) return;
  const auto points = active_points(walker_.system(), here.state);
  end(Ending::Kind::stopped_early,
      fmt::format("standstill: {}{}; {}", since,
                  points.empty() ? "" : "; active: " + places_of(walker_.system(), points), what_to_try));
}

/// Wanted values between which no equilibrium is recorded.
void Path::report_passed(const State& from, const State& to) const {
  for (const Landing& landing : present_landings()) {
    const double before = landing.gauge.value(from.d, from.load_factor),
                 after = landing.gauge.value(to.d, to.load_factor);
    if ((before - landing.value) * (after - landing.value) < 0)
      report("passed", fmt::format("{} = {:g} is passed by a jump from {:g} to {:g}", landing.name,
                                   landing.value, before, after));
  }
}

}  // namespace dda
