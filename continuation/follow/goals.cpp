#include "continuation/follow/goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "continuation/detour/release.hpp"
#include "continuation/follow/advice.hpp"
#include "continuation/follow/mechanism.hpp"

namespace dda {
namespace {

/// What is true of a load that has fallen below a share of its peak; a jump may have turned it round.
std::string fallen_load(double share, double now) {
  std::string text = fmt::format("load below {:g} % of its peak", 100 * share);
  return now < -same_value ? fmt::format("{}, turned round to {:g} %", text, 100 * now) : text;
}

/// What is true of the present equilibrium if a gauge stands at a goal or, as it came, beyond it; else "". A
/// gauge that has set out from the goal must have left it and come back.
std::string reached(const PathState& path, const Landing& goal) {
  const Travel& travel = path.memory.travels.at(goal.name);
  const double now = path.walker.value(goal.gauge), way = travel.farthest - travel.from;
  const double on_it = same_value * std::max(std::abs(goal.value), std::abs(way));
  double side = goal.value - travel.from;
  if (std::abs(side) <= on_it) side = -way;
  if (goal.only_falling) side = std::max(travel.from, travel.farthest) > goal.value + on_it ? -1 : 0;
  if (side == 0 || (now - goal.value) * std::copysign(1, side) < -on_it) return {};
  if (std::abs(now - goal.value) <= on_it) return fmt::format("{} reached {}", goal.name, goal.value);
  return fmt::format("{} reached {} and stands at {}", goal.name, goal.value, now);
}

/// Whether no load is left of a structure that has cracked, nor would it bear one again.
bool has_ruptured(PathState& path) {
  constexpr double nothing = 1e-6;
  const bool at_leg_start = path.memory.leg > 0 && path.walker.effort().accepted == path.memory.leg_start;
  return !path.leg().unloads && !at_leg_start && path.walker.here().dissipated > 0 &&
         path.share_of_peak() <= nothing && !bears_load(path);
}

/// Whether the last step has led to a load above that before it, and to no strength that would end that: what a release has left
/// bears load anew, and may bear more.
bool rises(PathState& path) {
  return path.memory.load_before < path.load_of(path.walker.state()) &&
         !(path.releases_at_once && is_release_pending(path.walker.system()));
}

/// Whether a reload has been tried since the path went farthest.
bool is_reloaded(const PathMemory& memory) { return memory.reloaded_way >= memory.farthest_way; }

}  // namespace

bool has_fallen(PathState& path) {
  const double target = path.parameters.stop.load_below * path.memory.peak_load * (1 + same_value),
               load = path.load_of(path.walker.state());
  return target > 0 && path.is_last_leg() && !path.leg().unloads && !path.memory.releases &&
         path.memory.leg_peak > std::max(target, path.smallest_load()) && load <= target &&
         load >= -path.memory.peak_load && !rises(path);
}

namespace {

std::string fallen_load(const PathState& path) {
  return fallen_load(path.parameters.stop.load_below,
                     path.load_of(path.walker.state()) / path.memory.peak_load);
}

/// Which of the stopping rules is met here; "" when none is.
std::string goal_of_path(PathState& path) {
  for (const Landing& landing : path.route.landings)
    if (landing.ends_leg)
      if (std::string text = reached(path, landing); !text.empty()) return text;
  if (has_fallen(path) && !has_turned_round(path)) return fallen_load(path);
  return {};
}

/// What is true of the present equilibrium if the leg ends here; else "".
std::string end_of_leg(const PathState& path) {
  for (const Landing& landing : path.leg().until)
    if (std::string text = reached(path, landing); !text.empty()) return text;
  return {};
}

void count_leg(PathState& path) {
  ++path.memory.leg;
  path.memory.leg_start = path.walker.effort().accepted;
  path.memory.step = 0;
  path.memory.mechanism_way = path.memory.mechanism_share = path.memory.standing_way = 0;
  path.memory.plateau_load = std::numeric_limits<double>::infinity();
  path.memory.before.reset();
}

void begin_next_leg(PathState& path) {
  count_leg(path);
  set_out(path);
  set_heading(path);
  path.walker.unload();
  path.report("leg", path.leg().name);
}

}  // namespace

void begin_stage(PathState& path, std::string reason) {
  const StageEnd end{path.walker.state().load_factor, std::move(reason)};
  path.walker.head_for({});
  const Aims aims = path.later_stages->hold(end);
  count_leg(path);
  path.memory.begin_stage();
  path.memory.standstill = Standstill(path.size);
  path.control.reset();
  path.look_up(aims);
  set_out(path);
  path.later_stages->has_begun();
  path.report("leg", fmt::format("{}; what acted before is held at load factor {:.9g} ({})", path.leg().name,
                                 end.load_factor, end.reason));
}

void set_out(PathState& path) {
  path.memory.travels.clear();
  for (const NamedGauge& gauge : path.travelling) {
    const double now = path.walker.value(gauge.functional);
    path.memory.travels[gauge.name] = {now, now};
  }
  path.memory.leg_peak = path.load_of(path.walker.state());
  path.memory.way_from = path.displacement_of(path.walker.state());
  path.memory.farthest_way = path.memory.reloaded_way = 0;
  path.memory.load_before = std::numeric_limits<double>::infinity();
}

void set_heading(PathState& path) {
  if (!path.leg().unloads) return path.walker.head_for({});
  const Landing& goal = path.leg().until.front();
  path.walker.head_for(Heading{goal.gauge, goal.value < path.memory.travels.at(goal.name).from ? -1.0 : 1.0});
}

bool has_turned_round(PathState& path) {
  constexpr double back = 0.9, little = 0.1, near = 2;
  const PathMemory& memory = path.memory;
  const bool has_softened =
      is_reloaded(memory) && memory.reloaded_share >= 0 && memory.reloaded_share < still_borne;
  return !has_softened && memory.cracked_since_peak <= little * memory.cracked_to_peak &&
         way_of_leg(path, path.walker.state()) < back * memory.farthest_way && bears_load(path, near);
}

bool may_reload(const PathState& path) {
  return path.control->may_be_rescued() && !path.releases_at_once &&
         !(is_reloaded(path.memory) && path.memory.reloaded_share < still_borne);
}

std::optional<Point> stop_turned_round(PathState& path) {
  return path.stop_early(
      Stop::turned_round,
      fmt::format(
          "{}, but hardly anything has cracked since the peak: the path has turned round and unloads; {}",
          fallen_load(path), what_to_try(path.walker.system().equilibrium())));
}

void note_travel(PathState& path) {
  path.memory.leg_peak = std::max(path.memory.leg_peak, path.load_of(path.walker.state()));
  for (const NamedGauge& gauge : path.travelling) {
    const double now = path.walker.value(gauge.functional);
    Travel& travel = path.memory.travels[gauge.name];
    if (std::abs(now - travel.from) > std::abs(travel.farthest - travel.from)) travel.farthest = now;
  }
}

double share_of_way(const PathState& path, const Landing& landing) {
  const double from = path.memory.travels.at(landing.name).from, way = landing.value - from;
  return way == 0 ? 0 : (path.walker.value(landing.gauge) - from) / way;
}

double share_of_goals(const PathState& path) {
  double share = 0;
  for (const Landing& landing : path.route.landings)
    if (landing.ends_leg) share = std::max(share, share_of_way(path, landing));
  return share;
}

namespace {

/// A load that falls although nothing gives way: no rupture has been followed. Where strength is lost at once the load goes up
/// and down like teeth of a saw, and the path goes on from a low one as long as the structure bears load.
void end_where_turned_round(PathState& path) {
  if (path.ending.kind == Ending::Kind::running && has_fallen(path) && has_turned_round(path) &&
      !path.releases_at_once && !may_reload(path))
    stop_turned_round(path);
}

void end_where_stuck(PathState& path) {
  if (!path.cracks || path.ending.kind != Ending::Kind::running) return;
  const CrackFront& front = path.cracks->structure.front();
  for (int crack = 0; crack < static_cast<int>(front.num_cracks()); ++crack)
    if (front.is_stuck(crack)) {
      path.stop_early(
          Stop::crack_stuck,
          fmt::format("crack {} cannot be followed any farther at ({:.6g}, {:.6g}): {}; other blocks, "
                      "of another size "
                      "or seed, may lead it on",
                      crack, front.tip(crack).x(), front.tip(crack).y(), front.end_of(crack)));
      return;
    }
}

}  // namespace

void settle(PathState& path) {
  while (path.ending.kind == Ending::Kind::running) {
    if (std::string text = goal_of_path(path); !text.empty()) {
      path.end(Ending::Kind::goal_reached, std::move(text));
      return;
    }
    if (has_ruptured(path)) {
      path.end_with_structure("complete rupture");
      return;
    }
    std::string end = end_of_leg(path);
    if (end.empty() || path.is_last_of_stage()) break;
    if (path.is_last_leg())
      path.end(Ending::Kind::goal_reached, std::move(end));
    else
      begin_next_leg(path);
  }
  const int wanted = path.parameters.stop.after_steps;
  if (path.ending.kind == Ending::Kind::running && wanted > 0 && path.walker.effort().accepted >= wanted)
    path.end(Ending::Kind::goal_reached, fmt::format("{} steps", path.walker.effort().accepted));
  end_where_turned_round(path);
  end_where_stuck(path);
}

void begin_stages(PathState& path) {
  const auto is_releasing = [&] { return path.releases_at_once && is_release_pending(path.walker.system()); };
  while (path.ending.kind == Ending::Kind::running && path.is_last_of_stage() && !is_releasing()) {
    std::string end = end_of_leg(path);
    if (end.empty()) return;
    begin_stage(path, std::move(end));
    settle(path);
  }
}

namespace {

/// What moves of the structure: openings, gauges, and what the live load works on.
std::vector<double> movements(const PathState& path) {
  const System& system = path.walker.system();
  const State& state = path.walker.state();
  std::vector<double> out;
  for (std::size_t p = 0; p < system.equilibrium().num_active(); ++p)
    for (const double component : system.jump(p, state.d)) out.push_back(component);
  for (const NamedGauge& gauge : path.travelling)
    if (gauge.dimension == dimension::length) out.push_back(state.value(gauge.functional));
  out.push_back(system.movement_of_loads(state));
  return out;
}

}  // namespace

void look_for_standstill(PathState& path, const Point& point) {
  const Candidate& here = path.walker.here();
  const bool is_rescue = point.kind == StepKind::jump;
  const std::string since = path.memory.standstill.add(
      {movements(path), here.state.load_factor, here.dissipated, is_rescue, path.memory.leg});
  if (path.ending.kind != Ending::Kind::running || since.empty()) return;
  const auto points = active_points(path.walker.system(), here.state);
  path.stop_early(Stop::standstill,
                  fmt::format("standstill: {}{}; {}", since,
                              points.empty() ? "" : "; active: " + places_of(path.walker.system(), points),
                              what_to_try(path.walker.system().equilibrium())));
}

}  // namespace dda
