#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/detour/release.hpp"
#include "continuation/detour/sequentially_linear.hpp"
#include "continuation/detour/staggered.hpp"
#include "continuation/follow/goals.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {

std::optional<Point> sequential_step(PathState& path) {
  constexpr double any = std::numeric_limits<double>::min();
  const auto found = sequentially_linear(path.walker.system(), path.walker.state(), any);
  if (!found || is_mechanism(path, found->state)) return {};
  return jump_to(path, path.walker.settled(*found), StepKind::event);
}

namespace {

/// The equilibrium to which the structure goes on by itself with the displacement of its load held; none of a mechanism.
std::optional<Candidate> held_at(PathState& path, double displacement) {
  const State& start = path.walker.state();
  const WantedGauge wanted{path.displacement, displacement};
  const auto found = path.releases_at_once ? release_at_gauge(path.walker.stepper(), start, wanted)
                                           : staggered_at_gauge(path.walker.stepper(), start, wanted);
  if (!found || is_mechanism(path, found->state)) return {};
  return path.walker.settled(*found);
}

/// A jump there, if the path may take it.
std::optional<Point> rescued_at(PathState& path, Candidate found, const std::string& how) {
  auto point = jump_to(path, std::move(found), StepKind::jump);
  if (!point) return {};
  ++path.walker.effort().rescues;
  path.report("rescued", how);
  return point;
}

}  // namespace

std::optional<Point> jump_step(PathState& path) {
  constexpr double largest = 0.02, smallest = 1e-4;  // of the displacement so far
  if (path.memory.largest_displacement == 0) return {};
  const double here = path.displacement_of(path.walker.state());
  for (double share = largest; share > smallest; share *= cut) {
    auto found = held_at(path, here + std::copysign(share * path.memory.largest_displacement, here));
    if (!found) continue;
    if (auto point = rescued_at(
            path, *std::move(found),
            fmt::format("the displacement of the load was raised by {:.1e} of its largest", share)))
      return point;
  }
  return {};
}

namespace {

/// What a structure that is loaded again beyond its farthest way comes to, if it is found; the path remembers how much it bears.
std::optional<Candidate> reloaded(PathState& path) {
  constexpr double beyond = 0.005;
  PathMemory& memory = path.memory;
  const double way = path.displacement_of(path.walker.state()) - memory.way_from;
  auto found = held_at(path, memory.way_from + std::copysign((1 + beyond) * memory.farthest_way, way));
  memory.reloaded_way = memory.farthest_way;
  memory.reloaded_share = found ? std::max(0.0, path.load_of(found->state) / memory.peak_load) : -1;
  return found;
}

}  // namespace

std::optional<Point> reload_step(PathState& path) {
  constexpr double whole = 0.99;
  PathMemory& memory = path.memory;
  const bool is_last = has_fallen(path), is_new = memory.reloaded_way < memory.farthest_way;
  if (!may_reload(path) || !(is_last || is_new) ||
      path.load_of(path.walker.state()) > still_borne * memory.peak_load || !has_turned_round(path))
    return {};
  auto found = reloaded(path);
  if (found && memory.reloaded_share >= (is_last ? still_borne : whole)) {
    if (auto point = rescued_at(path, *std::move(found),
                                fmt::format("the path unloaded while hardly anything cracked: beyond its "
                                            "farthest displacement {:.3g} of its peak is borne",
                                            memory.reloaded_share)))
      return point;
    memory.reloaded_share = -1;
  }
  return is_last && has_turned_round(path) ? stop_turned_round(path) : std::nullopt;
}

std::optional<Point> end_without_equilibrium(PathState& path, Stop stop, const std::string& why) {
  constexpr double hardly_any = 0.01;
  const double left = path.share_of_peak();
  if (left < hardly_any && !bears_load(path))
    return path.end_with_structure(fmt::format("complete rupture: {:.1e} of the peak was left", left));
  return path.stop_early(stop, why);
}

}  // namespace dda
