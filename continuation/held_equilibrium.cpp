#include "continuation/held_equilibrium.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace dda {

HeldEquilibrium::HeldEquilibrium(System& system, const StepperParameters& parameters, const Functional& held,
                                 double value)
    : system_(system),
      parameters_(parameters),
      held_(held),
      value_(value),
      per_d_(system.equilibrium().num_unknowns()) {
  held.add_gradient(1, per_d_);
}

std::optional<State> HeldEquilibrium::solve(State at) {
  for (int closing = 0; closing <= parameters_.multipliers.max_iterations; ++closing) {
    if (!converge(at)) return {};
    if (!system_.iterates_multipliers()) return at;
    const auto laws = system_.laws_at(at.d, at.load_factor);
    at.multipliers = system_.multipliers();
    if (system_.relative_gap(*laws) <= parameters_.multipliers.tolerance) return at;
    system_.set_multipliers(system_.next_multipliers(*laws));
  }
  return {};
}

bool HeldEquilibrium::converge(State& at) {
  bool polished = false;
  std::array<double, 2> before{};  // the excess of the last two iterations
  for (int iteration = 0; iteration < 4 * parameters_.newton.max_iterations; ++iteration) {
    const auto laws = system_.laws_at(at.d, at.load_factor);
    std::vector<double> residual(at.d.size()), slope(at.d.size());
    system_.residual(at.d, at.load_factor, *laws, residual);
    const double excess = system_.excess_residual(residual, at.d, at.load_factor);
    if (!std::isfinite(excess)) return false;
    if (excess <= parameters_.newton.tolerance && std::exchange(polished, true)) return true;
    constexpr double same = 1e-9;
    if (excess > parameters_.newton.tolerance && std::abs(excess - before[1]) <= same * excess)
      return false;  // to and fro between two sets of contacts
    before = {excess, before[0]};
    system_.load_derivative(*laws, slope);
    if (!system_.use_tangent(system_.new_stamp(), laws->tangent)) return false;
    correct(at, residual, slope);
    ++iterations_;
  }
  return false;
}

/// d −= K⁻¹ R + δλ K⁻¹ ∂R/∂λ, with δλ from the gauge.
void HeldEquilibrium::correct(State& at, const std::vector<double>& residual,
                              const std::vector<double>& slope) {
  std::vector<double> y(at.d.size()), z(at.d.size());
  system_.linear().solve(residual, y);
  system_.linear().solve(slope, z);
  const auto gauge = [&](const std::vector<double>& v) {
    return std::inner_product(v.begin(), v.end(), per_d_.begin(), 0.0);
  };
  const double miss = held_.value(at.d, at.load_factor) - value_;
  const double change = (miss - gauge(y)) / (gauge(z) - held_.per_load_factor);
  for (std::size_t i = 0; i < at.d.size(); ++i) at.d[i] -= y[i] + change * z[i];
  at.load_factor += change;
}

}  // namespace dda
