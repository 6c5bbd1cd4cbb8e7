#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {

std::optional<Point> unload_step(PathState& path) {
  const Landing goal = path.leg().until.front();
  const double rest = goal.value - path.walker.value(goal.gauge);
  if (path.walker.leaving().d.empty())
    return path.stop_early(Stop::singular, "the tangent stiffness is singular here");
  if (path.walker.leaving().rate(goal.gauge) * rest < 0 && !path.walker.leaving().dissipates)
    path.walker.turn_back();
  const double rate = path.walker.leaving().rate(goal.gauge);
  const bool has_turned = !(rate * rest > 0);
  if (has_turned && path.walker.leaving().dissipates)
    return controlled_step(path, dissipation_move(path.walker));
  if (has_turned)
    return path.stop_early(Stop::unloading,
                           fmt::format("unloading does not lead to {} = {:g}", goal.name, goal.value));
  const Move move{.kind = StepKind::unloading, .equation = make_gauge_equation(goal.gauge), .rate = rate};
  constexpr double part = 0.1;
  const bool is_known = path.memory.step > 0 && path.memory.step_kind == StepKind::unloading;
  const double first = is_known ? path.memory.step : part * std::abs(rest);
  for (double length = first; length > smallest_share * first; length *= cut) {
    const bool arrives = length > (1 - 1e-9) * std::abs(rest);
    const double amount = arrives ? rest / rate : length / std::abs(rate);
    const auto candidate = try_step(path, move, amount);
    if (!candidate || refuse_jump(path, *candidate, to_string(move.kind))) continue;
    path.memory.step = first;
    path.memory.step_kind = StepKind::unloading;
    if (path.walker.system().joins_by_contact()) {  // whose tries are dear
      resize(path, *candidate, amount, move);
      path.memory.step = std::clamp(path.memory.step, length, std::max(length, part * std::abs(rest)));
    }
    Point point = keep(path, *candidate, move.kind);
    if (arrives) point.landed.push_back(fmt::format("{}={:g}", goal.name, goal.value));
    return point;
  }
  return path.stop_early(Stop::unloading, "unloading found no next equilibrium: " + path.refusal);
}

}  // namespace dda
