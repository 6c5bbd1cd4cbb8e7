#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/detour/increment/load_increment.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {

namespace {

/// The load factor of which increments are a part: that at which something begins to crack; on the way, where the next
/// point is near whatever the load, that of loads as large as any so far.
double load_factor_of_increments(const PathState& path) {
  const double event = next_event(path.walker);
  const Tangent& leaving = path.walker.leaving();
  const double rate = std::abs(leaving.rate(path.load) / leaving.load_factor);
  const bool is_intact = path.walker.here().dissipated == 0 && path.walker.state().load_factor == 0;
  if (is_intact || !(rate > 0)) return event;
  return std::max(event, path.as_load(path.memory.largest_force) / rate);
}

}  // namespace

std::optional<Point> increment_step(PathState& path) {
  if (path.memory.step == 0)
    path.memory.step = path.control->load_increment() * load_factor_of_increments(path);
  if (!std::isfinite(path.memory.step)) return linear_step(path);
  const double first = path.memory.step;
  const double smallest = smallest_share * std::max(first, std::abs(path.walker.state().load_factor));
  std::string why = fmt::format("the increments have fallen below {:g} of it", smallest_share);
  for (double increment = first; increment > smallest; increment *= 0.5) {
    const Increment found =
        load_increment(path.walker.stepper(), path.walker.state(), {increment, *path.control->load_solver()});
    path.walker.effort().relaxation_iterations += found.relaxation_iterations;
    if (!found.settled || is_mechanism(path, found.settled->state)) {
      why = found.settled ? "what is left is a mechanism" : found.why;
      path.reject("load_increments", why);
      continue;
    }
    auto point = jump_to(path, path.walker.settled(*found.settled), StepKind::load_increments);
    if (!point) {
      why = "what was found is not the next point of this path";
      continue;
    }
    path.memory.step = increment;
    return point;
  }
  return path.stop_early(Stop::increments_failed,
                         fmt::format("failure: no equilibrium beyond a load factor of {:g}: {}",
                                     path.walker.state().load_factor, why));
}

}  // namespace dda
