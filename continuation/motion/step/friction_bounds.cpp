#include "continuation/motion/step/friction_bounds.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr std::size_t most_past = 6;
constexpr int patience = 15;  // passes before residuals are taken to turn

}  // namespace

std::vector<FrictionBound> Rubbing::bounds(const std::vector<Bond>& all) const {
  std::vector<FrictionBound> out;
  for (const Slider& slider : sliders) out.push_back({slider.meeting.key, slider.bound});
  for (const RubbingBond& rubbing : bonds) {
    const Bond& bond = all[rubbing.bond];
    out.push_back({{.body = static_cast<std::uint32_t>(bond.first),
                    .vertex = static_cast<std::uint32_t>(rubbing.bond),
                    .other = static_cast<std::uint32_t>(bond.second)},
                   rubbing.bound()});
  }
  return out;
}

void Rubbing::set_bounds(const std::vector<FrictionBound>& bounds) {
  for (std::size_t i = 0; i < sliders.size(); ++i) sliders[i].bound = bounds[i].force;
  for (std::size_t i = 0; i < bonds.size(); ++i)
    bonds[i].closing = bounds[sliders.size() + i].force / bonds[i].per_closing;
}

double FrictionBounds::change(const std::vector<FrictionBound>& asked) const {
  double change = 0, all = 0;
  for (const FrictionBound& bound : asked) all += bound.force;
  for (const Bound& bound : pass_of(asked)) change += std::abs(bound.residual);
  if (all > 0) return change / all;
  return change > 0 ? 1 : 0;
}

/// b and r of all contacts that are here or were in the last pass.
FrictionBounds::Pass FrictionBounds::pass_of(const std::vector<FrictionBound>& asked) const {
  Pass out;
  SliderMemory here;
  for (const auto& [key, force] : asked) {
    const double used = used_.of(key).force;
    out.push_back({key, used, force - used});
    here.set(key, {0, 1});
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

void FrictionBounds::relax(std::vector<FrictionBound>& asked) {
  if (passes_++ > 0) {
    Pass now = pass_of(asked);
    if (!past_.empty()) factor_ = factor_of(now);
    const Eigen::VectorXd next = next_of(now);
    for (auto& [key, force] : asked) {
      const auto place = std::ranges::lower_bound(now, key, {}, &Bound::key) - now.begin();
      force = std::max(0.0, next[place]);
    }
    past_.push_back(std::move(now));
    if (past_.size() > most_past) past_.pop_front();
  }
  used_ = {};
  for (const auto& [key, force] : asked) used_.set(key, {0, force});
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
