#include "continuation/increment/damped_motion.hpp"

#include <algorithm>
#include <numeric>

namespace dda {

DampedMotion::DampedMotion(const FictitiousMass& mass, std::vector<double> d)
    : mass_(mass), d_(std::move(d)), momentum_(d_.size()), velocity_(d_.size()) {}

bool DampedMotion::move(std::span<const double> residual) {
  const double share = steps_ == 0 ? 0.5 : 1;
  for (std::size_t i = 0; i < d_.size(); ++i) momentum_[i] -= share * residual[i];
  std::vector<double> velocity = momentum_;
  mass_.solve(velocity);
  const double energy = 0.5 * std::inner_product(momentum_.begin(), momentum_.end(), velocity.begin(), 0.0);
  if (steps_ > 0 && energy < energy_[1]) {
    stop(energy);
    return true;
  }
  velocity_ = std::move(velocity);
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] += velocity_[i];
  energy_ = {energy_[1], energy};
  ++steps_;
  return false;
}

/// Back along the last step to the peak; `energy` is that of the step which would have come next.
void DampedMotion::stop(double energy) {
  const double back = 1 - share_to_peak(energy);
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] -= back * velocity_[i];
  std::ranges::fill(momentum_, 0.0);
  energy_ = {0, 0};
  steps_ = 0;
}

/// Where the peak lies on the last step, from 0 at its beginning to 1. Energies belong to the middle of their
/// steps, −½, ½ and 3/2; a first step begins at rest, which makes them 0, ½ and 3/2.
double DampedMotion::share_to_peak(double energy) const {
  const auto [before, last] = energy_;
  if (steps_ > 1) return std::clamp(0.5 + 0.5 * (energy - before) / (2 * last - before - energy), 0.0, 1.0);
  const double curvature = (energy - 3 * last) / 1.5, slope = 2 * last - 0.5 * curvature;
  return std::clamp(-slope / (2 * curvature), 0.0, 1.0);
}

}  // namespace dda
