#include "continuation/motion/step/friction_bounds.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr std::size_t most_past = 6;
constexpr int patience = 15;  // passes before residuals are taken to turn

}  // namespace

double FrictionBounds::change(const std::vector<Slider>& sliders) const {
  double change = 0, all = 0;
  for (const Slider& slider : sliders) all += slider.bound;
  for (const Bound& bound : pass_of(sliders)) change += std::abs(bound.residual);
  if (all > 0) return change / all;
  return change > 0 ? 1 : 0;
}

/// b and r of all contacts that are here or were in the last pass.
FrictionBounds::Pass FrictionBounds::pass_of(const std::vector<Slider>& sliders) const {
  Pass out;
  SliderMemory here;
  for (const Slider& slider : sliders) {
    const double used = used_.of(slider.meeting.key).force;
    out.push_back({slider.meeting.key, used, slider.bound - used});
    here.set(slider.meeting.key, {0, 1});
  }
  for (const auto& [key, kept] : used_.all())
    if (here.of(key).force == 0) out.push_back({key, kept.force, -kept.force});
  std::ranges::sort(out, {}, &Bound::key);
  return out;
}

/// What was of a contact in a pass: nothing where it was not there.
FrictionBounds::Bound FrictionBounds::at(const Pass& pass, const MeetingKey& key) {
  const auto found = std::ranges::lower_bound(pass, key, {}, &Bound::key);
  return found != pass.end() && found->key == key ? *found : Bound{key};
}

void FrictionBounds::relax(std::vector<Slider>& sliders) {
  if (passes_++ > 0) {
    Pass now = pass_of(sliders);
    if (!past_.empty()) factor_ = factor_of(now);
    const Eigen::VectorXd next = next_of(now);
    for (Slider& slider : sliders) {
      const auto place = std::ranges::lower_bound(now, slider.meeting.key, {}, &Bound::key) - now.begin();
      slider.bound = std::max(0.0, next[place]);
    }
    past_.push_back(std::move(now));
    if (past_.size() > most_past) past_.pop_front();
  }
  used_ = {};
  for (const Slider& slider : sliders) used_.set(slider.meeting.key, {0, slider.bound});
}

/// ω, a tenth at least, and growing by no more than to its double. Where residuals grow along themselves, as of a body that
/// friction jams, the way leads on to where it sticks.
double FrictionBounds::factor_of(const Pass& now) {
  constexpr double least = 0.1;
  const double most = std::max(1.5, 2 * factor_);
  double along = 0, square = 0;
  for (const Bound& bound : now) {
    const double then = at(past_.back(), bound.key).residual, change = bound.residual - then;
    along += then * change;
    square += change * change;
  }
  grows_ = along > 0;
  if (square == 0) return factor_;
  return grows_ ? most : std::clamp(-factor_ * along / square, least, most);
}

/// b of the next pass, in the order of this one.
Eigen::VectorXd FrictionBounds::next_of(const Pass& now) const {
  const bool turns = passes_ > patience && !grows_;
  const double factor = turns ? std::min(1.0, factor_) : factor_;
  const auto rows = static_cast<Eigen::Index>(now.size()), columns = static_cast<Eigen::Index>(past_.size());
  Eigen::VectorXd next(rows), residual(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Bound& bound = now[static_cast<std::size_t>(row)];
    residual[row] = bound.residual;
    next[row] = bound.used + factor * bound.residual;
  }
  if (!turns) return next;
  Eigen::MatrixXd changes(rows, columns), of_residuals(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Bound& bound = now[static_cast<std::size_t>(row)];
    for (Eigen::Index i = 0; i < columns; ++i) {
      const Bound then = at(past_[static_cast<std::size_t>(i)], bound.key);
      changes(row, i) = bound.used - then.used;
      of_residuals(row, i) = bound.residual - then.residual;
    }
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> least(of_residuals);
  least.setThreshold(1e-4);
  return next - (changes + factor * of_residuals) * least.solve(residual);
}

}  // namespace dda
