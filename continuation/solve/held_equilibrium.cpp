#include "continuation/solve/held_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "continuation/solve/contact_step.hpp"

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
  auto found = solve_by_newton(at);
  return found || !system_.joins_by_contact() ? found : solve_contacts_from(at);
}

/// Contact and friction of separate bodies solved exactly, where Newton's method runs in circles.
std::optional<State> HeldEquilibrium::solve_contacts_from(const State& at) {
  const auto control = make_gauge_equation(held_);
  const double now = held_.value(at.d, at.load_factor);
  system_.set_multipliers(at.multipliers);
  control->start_at({at.d, at.load_factor, *system_.laws_at(at.d, at.load_factor)},
                    std::max(std::abs(now), std::abs(value_)));
  const Attempt found =
      contact_step(system_, {at, *control, value_ - now, at}, parameters_, Thoroughness::full);
  iterations_ += found.reduced_iterations;
  return found.converged ? std::optional(found.state) : std::nullopt;
}

std::optional<State> HeldEquilibrium::solve_by_newton(State at) {
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
  std::vector<double> before;  // the excess of the iterations
  for (int iteration = 0; iteration < 2 * parameters_.newton.max_iterations; ++iteration) {
    const auto laws = system_.laws_at(at.d, at.load_factor);
    std::vector<double> residual(at.d.size()), slope(at.d.size());
    system_.residual(at.d, at.load_factor, *laws, residual);
    const double excess = system_.excess_residual(residual, at.d, at.load_factor);
    if (!std::isfinite(excess)) return false;
    const bool is_good = excess <= parameters_.newton.tolerance;
    if (is_good && std::exchange(polished, true)) return true;
    constexpr double same = 1e-9;
    const auto is_here_again = [&](double value) { return std::abs(excess - value) <= same * excess; };
    if (!is_good && std::ranges::any_of(before, is_here_again)) return false;  // round and round
    before.push_back(excess);
    system_.load_derivative(*laws, slope);
    if (!system_.use_tangent(system_.new_stamp(), laws->tangent)) return false;
    const Correction correction = correct(at, residual, slope);
    ++iterations_;
    at = is_good || !meets_gauge(at) ? moved(at, correction, 1)
                                     : search(at, correction, system_.residual_norm(residual));
  }
  return false;
}

bool HeldEquilibrium::meets_gauge(const State& at) const {
  constexpr double round_off = 1e-9;
  return std::abs(held_.value(at.d, at.load_factor) - value_) <= round_off * std::abs(value_);
}

/// Along a correction to where the residual has become smaller by some of what a smooth one would, or is
/// least among what was tried: contacts that change make the full step overshoot.
State HeldEquilibrium::search(const State& from, const Correction& correction, double norm) const {
  constexpr double cut = 0.6, of_smooth = 0.1;
  constexpr int most = 8;
  State best;
  double least = std::numeric_limits<double>::infinity(), share = 1;
  for (int i = 0; i < most; ++i, share *= cut) {
    State tried = moved(from, correction, share);
    std::vector<double> residual(tried.d.size());
    system_.residual(tried.d, tried.load_factor, *system_.laws_at(tried.d, tried.load_factor), residual);
    const double now = system_.residual_norm(residual);
    if (now >= least) continue;
    least = now;
    best = std::move(tried);
    if (least <= (1 - of_smooth * share) * norm) break;
  }
  return best.d.empty() ? moved(from, correction, 1) : best;
}

/// −K⁻¹ R + δλ K⁻¹ ∂R/∂λ and δλ, from the gauge.
HeldEquilibrium::Correction HeldEquilibrium::correct(const State& at, const std::vector<double>& residual,
                                                     const std::vector<double>& slope) {
  std::vector<double> y(at.d.size()), z(at.d.size());
  system_.linear().solve(residual, y);
  system_.linear().solve(slope, z);
  const auto gauge = [&](const std::vector<double>& v) {
    return std::inner_product(v.begin(), v.end(), per_d_.begin(), 0.0);
  };
  const double miss = held_.value(at.d, at.load_factor) - value_;
  const double change = (miss - gauge(y)) / (gauge(z) - held_.per_load_factor);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = -(y[i] + change * z[i]);
  return {std::move(y), change};
}

State HeldEquilibrium::moved(const State& from, const Correction& correction, double share) {
  State out = from;
  for (std::size_t i = 0; i < out.d.size(); ++i) out.d[i] += share * correction.d[i];
  out.load_factor += share * correction.load_factor;
  return out;
}

}  // namespace dda
