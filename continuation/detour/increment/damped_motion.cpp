#include "continuation/detour/increment/damped_motion.hpp"

#include <algorithm>
#include <numeric>

namespace dda {
namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

DampedMotion::DampedMotion(const FictitiousMass& mass, std::vector<double> d)
    : mass_(mass), d_(std::move(d)), momentum_(d_.size()), velocity_(d_.size()) {}

bool DampedMotion::move(std::span<const double> residual) {
  const double share = is_at_rest_ ? 0.5 : 1;
  for (std::size_t i = 0; i < d_.size(); ++i) momentum_[i] -= share * residual[i];
  std::vector<double> velocity = momentum_;
  mass_.solve(velocity);
  const double energy = 0.5 * dot(momentum_, velocity);
  if (energy < energy_) {
    stop(dot(residual, velocity_));
    return true;
  }
  velocity_ = std::move(velocity);
  slope_ = dot(residual, velocity_);
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] += velocity_[i];
  energy_ = energy;
  is_at_rest_ = false;
  return false;
}

/// Back along the last step to the valley; `slope` is R·v at its end.
void DampedMotion::stop(double slope) {
  const double back = slope > 0 ? slope / (slope - std::min(slope_, 0.0)) : 0;
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] -= back * velocity_[i];
  std::ranges::fill(momentum_, 0.0);
  energy_ = 0;
  is_at_rest_ = true;
}

}  // namespace dda
