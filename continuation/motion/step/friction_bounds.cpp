#include "continuation/motion/step/friction_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

double FrictionBounds::change(const std::vector<Slider>& sliders) const {
  double change = 0, all = 0;
  for (const Slider& slider : sliders) {
    all += slider.bound;
    change += std::abs(slider.bound - used_.of(slider.meeting.key).force);
  }
  return all > 0 ? change / all : 0;
}

void FrictionBounds::relax(std::vector<Slider>& sliders) {
  Residuals residuals;
  if (is_begun_)
    for (const Slider& slider : sliders)
      residuals[slider.meeting.key] = slider.bound - used_.of(slider.meeting.key).force;
  if (!residuals_.empty()) factor_ = factor_of(residuals);
  SliderMemory used;
  for (Slider& slider : sliders) {
    if (is_begun_) slider.bound = std::max(0.0, slider.bound + (factor_ - 1) * residuals[slider.meeting.key]);
    used.set(slider.meeting.key, {0, slider.bound});
  }
  used_ = used;
  residuals_ = std::move(residuals);
  is_begun_ = true;
}

/// ω, a tenth at least, and growing by no more than to its double. Where residuals grow along themselves, as of a body that
/// friction jams, the way leads on to where it sticks.
double FrictionBounds::factor_of(const Residuals& residuals) const {
  constexpr double least = 0.1;
  const double most = std::max(1.5, 2 * factor_);
  double along = 0, square = 0;
  for (const auto& [key, now] : residuals) {
    const auto before = residuals_.find(key);
    const double then = before != residuals_.end() ? before->second : 0;
    along += then * (now - then);
    square += (now - then) * (now - then);
  }
  if (square == 0) return factor_;
  return along > 0 ? most : std::clamp(-factor_ * along / square, least, most);
}

}  // namespace dda
