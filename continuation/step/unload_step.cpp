#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {

namespace {

/// Whether what has gone on as a mechanism comes back as one, under the load that stays until gaps have closed.
bool goes_back_freely(const PathState& path) {
  return path.walker.system().has_contacts() && moves_freely(path) &&
         path.displacement_rate(path.walker.leaving()) * path.displacement_of(path.walker.state()) < 0;
}

}  // namespace

std::optional<Point> unload_step(PathState& path) {
  const Landing goal = path.leg().until.front();
  const double rest = goal.value - path.walker.value(goal.gauge);
  if (path.walker.leaving().d.empty())
    return path.stop_early(Stop::singular, "the tangent stiffness is singular here");
  if (goes_back_freely(path)) return controlled_step(path, displacement_move(path));
  const double rate = path.walker.leaving().rate(goal.gauge);
  const bool has_turned = !(rate * rest > 0);
  if (has_turned && path.walker.leaving().dissipates)
    return controlled_step(path, dissipation_move(path.walker));
  if (has_turned)
    return path.stop_early(Stop::unloading,
                           fmt::format("unloading does not lead to {} = {:g}", goal.name, goal.value));
  const Move move{.kind = StepKind::unloading, .equation = make_gauge_equation(goal.gauge), .rate = rate};
  const bool is_known = path.memory.step > 0 && path.memory.step_kind == StepKind::unloading;
  constexpr double part = 0.1;
  const double to_goal = rest / rate;
  const double longest = part * std::abs((goal.value - path.memory.travels.at(goal.name).from) / rate);
  const double first =
      std::min(longest, bounded(path, move, is_known ? path.memory.step / unit_of(path, move) : longest));
  for (double amount = first; amount > smallest_share * first; amount *= cut) {
    const bool arrives = amount > (1 - 1e-9) * to_goal;
    if (arrives) amount = to_goal;
    const auto candidate = try_step(path, move, amount);
    if (!candidate) {
      if (auto point = land_on_turn(path, {.move = move, .amount = amount}, true)) return point;
      if (auto point = land_on_contact_change(path, amount, move.kind)) return point;
    }
    if (!candidate || refuse_jump(path, *candidate, to_string(move.kind))) continue;
    resize(path, *candidate, amount, move);
    Point point = keep(path, *candidate, move.kind);
    if (arrives) point.landed.push_back(fmt::format("{}={:g}", goal.name, goal.value));
    return point;
  }
  if (path.walker.leaving().dissipates) return controlled_step(path, dissipation_move(path.walker));
  return path.stop_early(Stop::unloading, "unloading found no next equilibrium: " + path.refusal);
}

}  // namespace dda
