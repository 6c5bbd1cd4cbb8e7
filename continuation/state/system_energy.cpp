// Energies of a system.
#include <cmath>

#include "continuation/state/system.hpp"
#include "framework/base/threads.hpp"

namespace dda {
namespace {

constexpr std::size_t points_at_once = 2000;

}  // namespace

double System::dissipated(const std::vector<History>& history) const {
  double sum = 0;
  for (std::size_t p = 0; p < history.size(); ++p)
    sum += equilibrium_.point(p).weight * history[p].dissipated;
  return sum;
}

double System::stored(const State& state, const LawValues& laws) const {
  const double of_joints = parallel_sum(laws.opening.size(), points_at_once, [&](std::size_t p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const double energy = point.law->stored(laws.opening[p], history_[p], point.stiffness);
    if (point.multiplier != Multiplier::iterated) return point.weight * energy;
    const Vec2 carried = (1 + point.perturbation) * point.trial_stiffness().cwiseProduct(multipliers_[p]);
    return point.weight * (energy - 0.5 * multipliers_[p].dot(carried));
  });
  return equilibrium_.passive_energy(state.d) + of_joints;
}

}  // namespace dda
