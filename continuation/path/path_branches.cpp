// Where a path may branch: the first equilibrium that another branch leaves, and the branch that nature
// takes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/path/path.hpp"
#include "continuation/stability/branches.hpp"

namespace dda {

void Path::judge(Point& point) const {
  const Candidate& here = walker_.here();
  point.num_negative = here.num_negative;
  point.num_negative_work = here.num_negative_work;
  if (!here.num_negative) return;
  const bool turned = control_->prescribed_rate(here.arriving) * here.arriving.load_factor < 0;
  point.num_negative_under_control = std::abs(*here.num_negative - (turned ? 1 : 0));
}

/// Where a step has passed a bifurcation: the first equilibrium beyond it, which bisection brings within 1e-6
/// of the load and of the displacement.
std::optional<Candidate> Path::first_unstable(const Candidate& beyond, double amount, const Move& move) {
  if (move.arc || memory_.surplus > 0 || beyond.surplus().value_or(0) == 0) return {};
  constexpr double resolved = 1e-6;
  const auto differ = [&](double a, double b, double unit) { return std::abs(a - b) > resolved * unit; };
  State stable = walker_.state();
  Candidate unstable = beyond;
  std::string why;
  for (double low = 0, high = amount;;) {
    const double load = std::max(memory_.peak_load, std::abs(load_of(stable)));
    const double displacement = std::max(memory_.largest_displacement, std::abs(displacement_of(stable)));
    if (!differ(load_of(stable), load_of(unstable.state), load) &&
        !differ(displacement_of(stable), displacement_of(unstable.state), displacement))
      return unstable;
    const double middle = 0.5 * (low + high);
    const auto between = try_step(move, middle, why);
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

/// At a bifurcation: leaves by the branch on which the load falls fastest per dissipated energy, and by a
/// branch of that one where it is not stable either.
void Path::choose_branch(Point& point) {
  if (parameters_.branch != Branching::to_lowest || !walker_.leaving().dissipates) return;
  if (walker_.here().surplus().value_or(0) == 0) return;
  System& system = walker_.system();
  const auto scope = system.timings().measure("branches");
  const double sign = memory_.direction < 0 ? -1 : 1;
  const auto rate = [&](const Branch& branch) { return sign * branch.leaving.rate(load_); };
  Branch best{walker_.leaving(), system.history(), {}};
  const double by_itself = rate(best);
  constexpr double clearly = 1e-6;
  Candidate from = walker_.here();
  for (bool improves = true; improves;) {
    improves = false;
    for (Branch& other : branches_at(system, from, parameters_.linear)) {
      if (rate(other) >= rate(best) - clearly * std::abs(rate(best))) continue;
      best = std::move(other);
      improves = point.switched = true;
    }
    if (best.surplus() == 0) break;
    from.history = best.flags;
    from.arriving = best.leaving;
    from.num_negative = best.num_negative;
  }
  walker_.turn_to(best.leaving, best.flags);
  if (!point.switched) return;
  memory_.step = 0;
  report("switched",
         fmt::format("the load changes by {:.6g} per dissipated energy on this branch, by {:.6g} on the "
                     "one left",
                     sign * rate(best), sign * by_itself));
}

}  // namespace dda
