#include "continuation/follow/branch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/follow/trial.hpp"
#include "continuation/stability/branches.hpp"

namespace dda {

void judge_stability(const PathState& path, Point& point) {
  const Candidate& here = path.walker.here();
  point.num_negative = here.num_negative;
  point.num_negative_work = here.num_negative_work;
  if (!here.num_negative) return;
  if (point.kind == StepKind::release) {  // on the way of a release no dead load is borne
    point.num_negative.reset();
    return;
  }
  const bool turned = path.control->prescribed_rate(here.arriving) * here.arriving.load_factor < 0;
  point.num_negative_under_control = std::max(0, *here.num_negative - (turned ? 1 : 0));
}

std::optional<Candidate> first_unstable(PathState& path, const Candidate& beyond, double amount,
                                        const Move& move) {
  if (path.memory.surplus > 0 || beyond.surplus().value_or(0) == 0) return {};
  // Of bodies that only touch stability changes with every few joints: it is bracketed where it is to be acted on.
  if (path.walker.system().joins_by_contact() && path.parameters.branch != Branching::to_lowest) return {};
  constexpr double resolved = 1e-6;
  const auto differ = [&](double a, double b, double unit) { return std::abs(a - b) > resolved * unit; };
  State stable = path.walker.state();
  Candidate unstable = beyond;
  for (double low = 0, high = amount;;) {
    const double load = std::max(path.memory.peak_load, std::abs(path.load_of(stable)));
    const double displacement =
        std::max(path.memory.largest_displacement, std::abs(path.displacement_of(stable)));
    if (!differ(path.load_of(stable), path.load_of(unstable.state), load) &&
        !differ(path.displacement_of(stable), path.displacement_of(unstable.state), displacement))
      return unstable;
    const double middle = 0.5 * (low + high);
    const auto between = try_step(path, move, middle);
    if (!between || middle == low || middle == high) return {};
    if (between->surplus().value_or(0) > 0) {
      unstable = *between;
      high = middle;
    } else {
      stable = between->state;
      low = middle;
    }
  }
}

void choose_branch(PathState& path, Point& point) {
  if (path.parameters.branch != Branching::to_lowest || !path.walker.leaving().dissipates) return;
  if (path.walker.here().surplus().value_or(0) == 0) return;
  System& system = path.walker.system();
  const auto scope = system.timings().measure("branches");
  const double sign = path.memory.direction < 0 ? -1 : 1;
  const auto rate = [&](const Branch& branch) { return sign * branch.leaving.rate(path.load); };
  Branch best{path.walker.leaving(), system.history(), {}};
  const double by_itself = rate(best);
  constexpr double clearly = 1e-6;
  Candidate from = path.walker.here();
  for (bool improves = true; improves;) {
    improves = false;
    for (Branch& other : branches_at(system, from, path.parameters.linear)) {
      if (rate(other) >= rate(best) - clearly * std::abs(rate(best))) continue;
      best = std::move(other);
      improves = point.switched = true;
    }
    if (best.surplus() == 0) break;
    from.history = best.flags;
    from.arriving = best.leaving;
    from.num_negative = best.num_negative;
  }
  path.walker.turn_to(best.leaving, best.flags);
  if (!point.switched) return;
  path.memory.step = 0;
  path.memory.before.reset();
  path.report("switched",
              fmt::format("the load changes by {:.6g} per dissipated energy on this branch, by {:.6g} on the "
                          "one left",
                          sign * rate(best), sign * by_itself));
}

}  // namespace dda
