#include <fmt/format.h>

#include <cmath>

#include "continuation/detour/increment/load_increment.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {

std::optional<Point> increment_step(PathState& path) {
  if (path.memory.step == 0) path.memory.step = path.control->load_increment() * next_event(path.walker);
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
