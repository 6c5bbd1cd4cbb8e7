// Energies of a system.
#include <cmath>

#include "continuation/state/at_once.hpp"
#include "continuation/state/system.hpp"
#include "framework/base/threads.hpp"

namespace dda {

double System::dissipated(const std::vector<History>& history) const {
  double sum = 0;
  for (std::size_t p = 0; p < history.size(); ++p)
    sum += equilibrium_.point(p).weight * history[p].dissipated;
  return sum;
}

double System::supplied_by_water(const std::vector<History>& history) const {
  if (!equilibrium_.interfaces().has_water) return 0;
  double sum = 0;
  for (std::size_t p = 0; p < history.size(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    sum += point.weight * point.law->supplied(history[p]);
  }
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

/// Where the displacements are a sum of kept solutions, by the work of all forces on them, which
/// equilibrium makes twice the energies of the parts, without a look at every block:
///
///     ½ (f · d − Σ W t · q − Σ k (c · d)²) + Σ p̄ (½ e − l · d) e,     k, c of the driven springs, p̄, l, e of the supports
double System::passive_energy(const State& state, const LawValues& laws) const {
  if (!state.d.sum())
    return equilibrium_.passive_energy(state.d) +
           (joins_by_contact_ ? 0.0 : equilibrium_.weak_energy(state.d));
  const Displacements::Sum& d = *state.d.sum();
  double twice = d.dead_work() + state.load_factor * d.product(reference_);
  twice -= parallel_sum(laws.opening.size(), points_at_once, [&](std::size_t p) {
    return equilibrium_.point(p).weight * laws.traction[p].dot(d.openings()[p]);
  });
  for (const Spring& spring : equilibrium_.driven_springs()) {
    const double u = d.product(spring.displacement);
    twice -= spring.stiffness * u * u;
  }
  for (const Spring& spring : equilibrium_.supports())
    if (spring.rest != 0)
      twice += spring.stiffness * (spring.rest - 2 * d.product(spring.displacement)) * spring.rest;
  return twice / 2;
}

double System::dead_product(std::span<const double> d) const {
  if (!has_dead_) return 0;
  return parallel_sum(d.size(), numbers_at_once, [&](std::size_t i) { return loading_->dead[i] * d[i]; });
}

double System::dead_work(const State& state) const {
  if (!has_dead_) return 0;
  const double all = state.d.sum() ? state.d.sum()->dead_work() : dead_product(state.d);
  return all - state.d.value(dead_springs_, 0);
}

double System::sum_of_forces(const State& at) const {
  double sum = 0;
  for (const auto& [node, dead, live] : loaded_)
    if (node < equilibrium_.num_blocks()) sum += (dead + at.load_factor * live).head<2>().norm();
  for (const WorkPair& pair : loading_->driven) sum += std::abs(at.value(pair.force));
  return sum;
}

System::LoadSizes System::load_sizes(const State& at) const {
  LoadSizes out;
  for (const auto& [node, dead, live] : loaded_) {
    const Vec6 now = dead + at.load_factor * live;
    const double size = *equilibrium_.strain_size(node);
    const bool is_block = node < equilibrium_.num_blocks();
    if (is_block) out.couples += std::abs(now[2]) / size;
    out.all += is_block ? now.head<2>().norm() + now.tail<4>().norm() / size : now.norm() / size;
  }
  return out;
}

double System::movement_of_loads(const State& at) const {
  double dead_sum = 0, live_sum = 0, out = 0;
  for (const auto& [node, dead, live] : loaded_) {
    if (node >= equilibrium_.num_blocks()) continue;
    dead_sum += dead.head<2>().norm();
    live_sum += live.head<2>().norm();
  }
  if (dead_sum > 0) out = std::abs(dead_work(at)) / dead_sum;
  if (live_sum > 0) out = std::max(out, std::abs(at.d.value(reference_work_, 0)) / live_sum);
  for (const WorkPair& pair : loading_->driven)
    out = std::max(out, std::abs(at.d.value(pair.displacement, 0)));
  return out;
}

double System::block_forces(std::span<const double> d) const {
  const double of_means = parallel_sum(equilibrium_.num_blocks(), blocks_at_once, [&](std::size_t b) {
    const Vec3 resultant = equilibrium_.strain_stiffness()[b] * Eigen::Map<const Vec3>(d.data() + 6 * b + 3);
    const double size = equilibrium_.block_size()[b];
    return resultant.squaredNorm() / (size * size);
  });
  const std::size_t blocks = equilibrium_.num_blocks();
  return std::sqrt(of_means + parallel_sum(equilibrium_.num_gradients(), blocks_at_once, [&](std::size_t i) {
                     const Vec6 resultant = equilibrium_.gradients()[i].stiffness *
                                            Eigen::Map<const Vec6>(d.data() + block_unknowns * (blocks + i));
                     const double size = *equilibrium_.strain_size(blocks + i);
                     return resultant.squaredNorm() / (size * size);
                   }));
}

}  // namespace dda
