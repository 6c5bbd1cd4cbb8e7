// Legs of a path: off the damage surfaces to a gauge value, and on again.
#include <fmt/format.h>

#include <cmath>

#include "continuation/path/path.hpp"

namespace dda {

void Path::begin_next_leg() {
  ++memory_.leg;
  memory_.leg_start = walker_.effort().accepted;
  memory_.step = 0;
  walker_.unload();
  set_out();
  report("leg", leg().name);
}

/// A tenth of the way to the leg's goal, off the damage surfaces.
std::optional<Point> Path::unload_step() {
  const Landing goal = leg().until.front();
  const double rest = goal.value - walker_.value(goal.gauge);
  if (walker_.leaving().d.empty())
    return end(Ending::Kind::stopped_early, "the tangent stiffness is singular here");
  if (walker_.leaving().rate(goal.gauge) * rest < 0 && !walker_.leaving().dissipates) walker_.turn_back();
  const double rate = walker_.leaving().rate(goal.gauge);
  if (!(rate * rest > 0))
    return end(Ending::Kind::stopped_early,
               fmt::format("unloading does not lead to {} = {:g}", goal.name, goal.value));
  constexpr double parts = 10, smallest_share = 1e-4, cut = 0.25;
  if (memory_.step == 0) memory_.step = std::abs(rest) / parts;
  const Move move{
      .control = "unloading", .equation = make_gauge_equation(goal.gauge), .arc = {}, .rate = rate};
  std::string why;
  for (double length = memory_.step; length > smallest_share * memory_.step; length *= cut) {
    const bool arrives = length > (1 - 1e-9) * std::abs(rest);
    const double amount = arrives ? rest / rate : length / std::abs(rate);
    const auto candidate = try_step(move, amount, why);
    if (!candidate) continue;
    Point point = keep(*candidate, move.control);
    if (arrives) point.landed.push_back(fmt::format("{}={:g}", goal.name, goal.value));
    return point;
  }
  return end(Ending::Kind::stopped_early, "unloading found no next equilibrium: " + why);
}

}  // namespace dda
