// Energies of a system.
#include <cmath>

#include "continuation/state/system.hpp"
#include "framework/base/threads.hpp"

namespace dda {
namespace {

constexpr std::size_t points_at_once = 2000, numbers_at_once = 50'000;

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
  return passive_energy(state, laws) + of_joints;
}

/// Where the displacements are put together from kept solutions, by the work of all forces on them, which
/// equilibrium makes twice the energies of the parts, without a look at every block:
///
///     ½ (f · d − Σ W t · q − Σ k (c · d)²),     k, c of the driven springs
double System::passive_energy(const State& state, const LawValues& laws) const {
  if (!state.d.dead_work())
    return equilibrium_.passive_energy(state.d) +
           (joins_by_contact_ ? 0.0 : equilibrium_.weak_energy(state.d));
  double twice = *state.d.dead_work() + state.load_factor * reference_.value(state.d.asked_by(reference_), 0);
  twice -= parallel_sum(laws.opening.size(), points_at_once, [&](std::size_t p) {
    return equilibrium_.point(p).weight * laws.traction[p].dot(equilibrium_.opening(p, state.d.watched()));
  });
  for (const Spring& spring : equilibrium_.driven_springs()) {
    const double u = spring.displacement.value(state.d.asked_by(spring.displacement), 0);
    twice -= spring.stiffness * u * u;
  }
  return twice / 2;
}

double System::dead_product(std::span<const double> d) const {
  if (!has_dead_) return 0;
  return parallel_sum(d.size(), numbers_at_once, [&](std::size_t i) { return loading_->dead[i] * d[i]; });
}

double System::dead_work(const State& state) const {
  if (!has_dead_) return 0;
  const double all = state.d.dead_work() ? *state.d.dead_work() : dead_product(state.d);
  return all - dead_springs_.value(state.d.asked_by(dead_springs_), 0);
}

}  // namespace dda
