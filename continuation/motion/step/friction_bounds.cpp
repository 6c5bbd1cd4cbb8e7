#include "continuation/motion/step/friction_bounds.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr std::size_t most_past = 6;
constexpr int patience = 15;  // passes before residuals are taken to turn

double at(const std::map<MeetingKey, double>& forces, const MeetingKey& key) {
  const auto found = forces.find(key);
  return found != forces.end() ? found->second : 0;
}

}  // namespace

double FrictionBounds::change(const std::vector<Slider>& sliders) const {
  double change = 0, all = 0;
  for (const Slider& slider : sliders) all += slider.bound;
  for (const auto& [key, residual] : pass_of(sliders).residuals) change += std::abs(residual);
  if (all > 0) return change / all;
  return change > 0 ? 1 : 0;
}

/// b and r of all contacts that are here or were in the last pass.
FrictionBounds::Pass FrictionBounds::pass_of(const std::vector<Slider>& sliders) const {
  Pass out;
  SliderMemory here;
  for (const Slider& slider : sliders) {
    const MeetingKey& key = slider.meeting.key;
    here.set(key, {0, 1});
    out.bounds[key] = used_.of(key).force;
    out.residuals[key] = slider.bound - out.bounds[key];
  }
  for (const auto& [key, kept] : used_.all()) {
    if (here.of(key).force > 0) continue;
    out.bounds[key] = kept.force;
    out.residuals[key] = -kept.force;
  }
  return out;
}

void FrictionBounds::relax(std::vector<Slider>& sliders) {
  SliderMemory used;
  if (passes_++ > 0) {
    Pass now = pass_of(sliders);
    if (!past_.empty()) factor_ = factor_of(now.residuals);
    const Forces next = next_of(now);
    for (Slider& slider : sliders) slider.bound = std::max(0.0, at(next, slider.meeting.key));
    past_.push_back(std::move(now));
    if (past_.size() > most_past) past_.pop_front();
  }
  for (const Slider& slider : sliders) used.set(slider.meeting.key, {0, slider.bound});
  used_ = used;
}

/// ω, a tenth at least, and growing by no more than to its double. Where residuals grow along themselves, as of a body that
/// friction jams, the way leads on to where it sticks.
double FrictionBounds::factor_of(const Forces& residuals) {
  constexpr double least = 0.1;
  const double most = std::max(1.5, 2 * factor_);
  double along = 0, square = 0;
  for (const auto& [key, now] : residuals) {
    const double then = at(past_.back().residuals, key);
    along += then * (now - then);
    square += (now - then) * (now - then);
  }
  grows_ = along > 0;
  if (square == 0) return factor_;
  return along > 0 ? most : std::clamp(-factor_ * along / square, least, most);
}

FrictionBounds::Forces FrictionBounds::next_of(const Pass& now) const {
  const bool turns = passes_ > patience && !grows_;
  const double factor = turns ? std::min(1.0, factor_) : factor_;
  Forces out;
  for (const auto& [key, bound] : now.bounds) out[key] = bound + factor * at(now.residuals, key);
  if (!turns) return out;
  const auto rows = static_cast<Eigen::Index>(out.size()), columns = static_cast<Eigen::Index>(past_.size());
  Eigen::MatrixXd bounds(rows, columns), residuals(rows, columns);
  Eigen::VectorXd left(rows);
  Eigen::Index row = 0;
  for (const auto& [key, next] : out) {
    left[row] = at(now.residuals, key);
    for (Eigen::Index i = 0; i < columns; ++i) {
      const Pass& then = past_[static_cast<std::size_t>(i)];
      bounds(row, i) = at(now.bounds, key) - at(then.bounds, key);
      residuals(row, i) = left[row] - at(then.residuals, key);
    }
    ++row;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> least(residuals);
  least.setThreshold(1e-4);
  const Eigen::VectorXd less = (bounds + factor * residuals) * least.solve(left);
  row = 0;
  for (auto& [key, next] : out) next -= less[row++];
  return out;
}

}  // namespace dda
