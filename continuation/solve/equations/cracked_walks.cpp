#include <fmt/format.h>

#include <cmath>

#include "continuation/linear/dense/two_by_two.hpp"
#include "continuation/solve/equations/cracked_equations.hpp"

namespace dda {

Verdict CrackedEquations::judge_walks(int iterations) {
  using enum Verdict::Kind;
  if (iterations >= rule_.at_least && is_solved(rule_.accuracy)) return {converged};
  const double error = error_of_walks();
  constexpr int most_rises = 5;
  constexpr double hardly = 1e-8;  // what rounding leaves the full equations judge
  const bool stays = iterations > 1 && error > 0.5 * error_before_,
             is_hardly_any = error <= hardly * opening_scale();
  const bool is_of_control = gap().lpNorm<Eigen::Infinity>() <= largest_miss(rule_.accuracy);
  if (stays && is_hardly_any && is_of_control)
    return {converged};  // no smaller residual stiffness brings that nearer
  if (stays && ++rises_ > most_rises) {
    if (is_hardly_any) return {converged};
    return {failed, "walks between the pieces of contact and friction lead no nearer"};
  }
  error_before_ = error;
  if (iterations >= rule_.max_iterations)
    return {failed, fmt::format("no convergence in {} walks", iterations)};
  return {goes_on, "contact and friction allow no equilibrium here"};
}

/// Of the openings, that of the control among them.
double CrackedEquations::error_of_walks() const {
  const double missed = control_.scale > 0 ? std::abs(value() - control_.target) / control_.scale : 0;
  return std::max(gap().lpNorm<Eigen::Infinity>(), missed * opening_scale());
}

std::vector<double> CrackedEquations::walk_from(const Iterate& at) {
  const auto scope = system_.timings().measure("contact");
  evaluate(at);
  linearise();
  constexpr double smaller = 0.03;
  WalkRule rule{.patience = Patience::little, .is_over = rule_.is_over};
  rule.share *= std::pow(smaller, rises_);
  auto found = dda::walk_from(problem_, walk_start_, matrix_, rule);
  if (!found && rule_.searches) found = search(rule);
  if (!found || !found->allFinite()) return {};
  walk_start_ = *found;
  return {found->begin(), found->end()};
}

/// The other ways to walk, the patient ones last.
std::optional<CrackedEquations::Vector> CrackedEquations::search(WalkRule rule) {
  if (auto found = walk_proximally(problem_, walk_start_, matrix_, rule)) return found;
  rule.patience = Patience::much;
  if (auto found = dda::walk_from(problem_, walk_start_, matrix_, rule)) return found;
  return walk_covered(problem_, matrix_, rule);
}

/// All but contact and friction made linear where the iteration stands, the control in units of the openings:
/// in powers of two, so that the matrix is hardly ever another one for it.
void CrackedEquations::linearise() {
  const Eigen::Index n = length();
  const double size_now = opening_scale();
  const bool has_unit = size_now > 0 && control_.scale > 0;
  const double unit = has_unit ? std::exp2(std::round(std::log2(size_now / control_.scale))) : 1;
  if (unit != unit_ || control_.spends) set_coefficients(unit);
  const double spent = control_.spends ? spent_ - spending_.dot(q_) : 0;
  problem_.constant.resize(n + 1);
  const double gauge = control_.gauge ? gauge_dead_ - load_origin_ * gauge_live_ : 0;
  problem_.constant << load_origin_ * live_ - dead_, unit * (gauge + spent - control_.target);
  problem_.constant -= problem_.couplings * z_origin_;
  problem_.accuracy = 1e-3 * good * size_now;
  problem_.points.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) problem_.points.push_back(point_of(i));
}

void CrackedEquations::set_coefficients(double unit) {
  const Eigen::Index n = length();
  unit_ = unit;
  matrix_.reset();
  problem_.live = live_;
  problem_.control = Vector::Zero(n + 1);
  if (control_.spends) problem_.control.head(n) = unit * spending_;
  problem_.control[n] = unit * (control_.gauge ? gauge_live_ : 0);
  problem_.couplings.resize(n + 1, n);
  problem_.couplings.topRows(n) = linear_.couplings().topLeftCorner(n, n);
  problem_.couplings.row(n).setZero();
  if (control_.gauge) problem_.couplings.row(n) = -unit * along_.transpose();
}

/// A point as contact where the damage stays at its q, else linear by its tangent.
ContactProblem::Point CrackedEquations::point_of(std::size_t i) const {
  const std::size_t p = points_[i];
  const InterfacePoint& point = system_.equilibrium().point(p);
  const History& h = system_.history()[p];
  const Vec2 q = pair_of(q_, i);
  const Response now = system_.respond(p, q);
  ContactProblem::Point out{.weight = point.weight,
                            .trial = point.trial_stiffness(),
                            .base = linear_.base()[p],
                            .multiplier = multiplier(i),
                            .contact = point.law->contact(h, point.stiffness),
                            .is_exact = point.multiplier == Multiplier::unknown,
                            .slides = h.sliding,
                            .traction = now.traction - now.tangent * q,
                            .tangent = now.tangent};
  const bool is_damaged = out.contact && !point.is_separate();
  if (is_damaged && !system_.frozen() &&
      point.law->equivalent_opening(q, h, point.stiffness) > point.law->kappa(h, point.stiffness))
    out.contact.reset();
  return out;
}

}  // namespace dda
