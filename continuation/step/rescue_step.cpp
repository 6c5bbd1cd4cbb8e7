#include <fmt/format.h>

#include <cmath>

#include "continuation/detour/release.hpp"
#include "continuation/detour/rescue.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
std::optional<Point> sequential_step(PathState& path, StepKind kind, double quantum) {
  const auto found = sequentially_linear(path.walker.system(), path.walker.state(), quantum);
  if (!found || is_mechanism(path, found->state)) return {};
  const double dissipated = path.walker.here().dissipated;
  auto point = jump_to(path, path.walker.settled(*found), kind);
  if (point && kind != StepKind::event) {
    ++path.walker.effort().rescues;
    path.report("rescued", fmt::format("sequentially linear steps dissipated {:.3e}",
                                       path.walker.here().dissipated - dissipated));
  }
  return point;
}

std::optional<Point> driven_step(PathState& path) {
  constexpr double largest = 0.02, smallest = 1e-4;  // of the displacement so far
  if (path.memory.largest_displacement == 0) return {};
  const State& start = path.walker.state();
  const double here = path.displacement_of(start);
  for (double share = largest; share > smallest; share *= cut) {
    const double value = here + std::copysign(share * path.memory.largest_displacement, here);
    const auto found = release_at_gauge(path.walker.stepper(), start, {path.displacement, value});
    if (!found || is_mechanism(path, found->state)) continue;
    auto point = jump_to(path, path.walker.settled(*found), StepKind::displacement);
    if (!point) continue;
    ++path.walker.effort().rescues;
    path.report("rescued",
                fmt::format("the displacement of the load was raised by {:.1e} of its largest", share));
    return point;
  }
  return {};
}

std::optional<Point> end_without_equilibrium(PathState& path, Stop stop, const std::string& why) {
  constexpr double hardly_any = 0.01;
  const double left = std::abs(path.load_of(path.walker.state())) / path.memory.peak_load;
  if (left < hardly_any && !bears_load(path))
    return path.end_with_structure(fmt::format("complete rupture: {:.1e} of the peak was left", left));
  return path.stop_early(stop, why);
}

}  // namespace dda
