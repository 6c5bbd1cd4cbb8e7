#include <algorithm>

#include "continuation/follow/trial.hpp"
#include "continuation/state/reach.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {
namespace {

/// A crack that begins in a step, or that the tangent lets begin there.
struct Beginning {
  double foreseen = 0;  ///< share of the step at which the tangent has it begin; 1: not in it
  double spent = 0;     ///< by the end of the step [FL]
};

bool is_new(const History& before) { return before.dissipated == 0 && !before.loading; }

bool begins_any(const PathState& path, const Candidate& candidate) {
  const std::vector<History>& before = path.walker.system().history();
  for (std::size_t p = 0; p < before.size(); ++p)
    if (is_new(before[p]) && candidate.history[p].dissipated > 0) return true;
  return false;
}

/// In the order in which the tangent has them.
std::vector<Beginning> beginnings(const PathState& path, const Candidate& candidate, double amount) {
  const System& system = path.walker.system();
  const std::vector<Vec2>& rates = path.walker.leaving().opening;
  const auto laws = system.laws(path.walker.state());
  std::vector<Beginning> out;
  for (std::size_t p = 0; p < rates.size(); ++p) {
    const History& before = system.history()[p];
    if (!is_new(before)) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const Vec2& here = laws.opening[p];
    const double spent = point.weight * candidate.history[p].dissipated,
                 foreseen =
                     share_to_kappa({*point.law, before, point.stiffness}, here, here + amount * rates[p], 0);
    if (spent > 0 || foreseen < 1) out.push_back({foreseen, spent});
  }
  std::ranges::sort(out, {}, &Beginning::foreseen);
  return out;
}

/// Share of the step at which the tangent lets a crack begin that has overtaken an earlier one; 1 when none has. The first
/// of all is to have spent half of what a later one has, others, which it may relieve, hardly anything.
double share_to_overtaking(const std::vector<Beginning>& ordered) {
  constexpr double apart = 0.1, half = 0.5, hardly = 0.02;
  double share = 1;
  for (std::size_t i = 0; i < ordered.size(); ++i)
    for (std::size_t j = i + 1; j < ordered.size(); ++j) {
      const Beginning &earlier = ordered[i], &later = ordered[j];
      if (later.foreseen > earlier.foreseen + apart && earlier.spent < (i == 0 ? half : hardly) * later.spent)
        share = std::min(share, later.foreseen);
    }
  return share;
}

}  // namespace

std::optional<Outcome> keep_order(PathState& path, const Candidate& candidate, Stride& stride) {
  if (stride.is_ordered || !path.walker.leaving().dissipates || !begins_any(path, candidate)) return {};
  constexpr double before_it = 0.9, least = 0.1;
  const double share = before_it * share_to_overtaking(beginnings(path, candidate, stride.amount));
  if (share >= before_it) return {};
  stride.is_ordered = true;
  return shorten(path, stride, "a crack overtakes one that was to begin before it", std::max(share, least));
}

}  // namespace dda
