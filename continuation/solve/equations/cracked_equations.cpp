#include "continuation/solve/equations/cracked_equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "continuation/linear/dense/two_by_two.hpp"
#include "framework/base/threads.hpp"

namespace dda {

bool changes_by_contact_alone(const InterfacePoint& point) {
  return point.is_separate() || point.law->releases_at_once();
}

CrackedEquations::CrackedEquations(const System& system, LinearSystem& linear, const ControlSum& control)
    : system_(system),
      linear_(linear),
      control_(control),
      points_(linear_.updated_points()),
      dead_(length()),
      live_(length()),
      update_(linear_.couplings()) {
  live_change_ = opened_by(system.loading().reference_offset);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Equilibrium& equilibrium = system.equilibrium();
    pair_of(live_, i) = equilibrium.opening(points_[i], linear_.reference_solution()) +
                        system.loading().reference_opening(points_[i]);
    if (!live_change_.empty()) pair_of(live_, i) += equilibrium.opening(points_[i], live_change_);
  }
  only_touch_ = std::ranges::all_of(
      points_, [&](std::size_t p) { return changes_by_contact_alone(system.equilibrium().point(p)); });
  if (!control.gauge) return;
  gauge_live_ = control.gauge->value(linear_.reference_solution(), 1) - control.gauge->constant;
  if (!live_change_.empty()) gauge_live_ += control.gauge->value(live_change_, 0) - control.gauge->constant;
  along_ = points_.empty() ? Vector() : linear_.along_columns(*control.gauge);
}

Vec2 CrackedEquations::multiplier(std::size_t i) const {
  return system_.iterates_multipliers() ? system_.multipliers()[points_[i]] : Vec2(Vec2::Zero());
}

/// What opens it without displacements: its multiplier, and what initial stress does.
Vec2 CrackedEquations::offset(std::size_t i, double load_factor) const {
  const Loading& loading = system_.loading();
  return multiplier(i) + loading.dead_opening(points_[i]) +
         load_factor * loading.reference_opening(points_[i]);
}

Iterate CrackedEquations::begin(const State& guess, const Rule& rule) { return start_at(guess, rule, false); }

Iterate CrackedEquations::begin_walks(const State& start, const State& guess, const Rule& rule) {
  const Iterate out = start_at(guess, rule, true);
  walk_start_ = openings(start);
  return out;
}

/// q of a state and its λ.
Eigen::VectorXd CrackedEquations::openings(const State& at) const {
  Vector out(length() + 1);
  for (std::size_t i = 0; i < points_.size(); ++i)
    pair_of(out, i) = system_.jump(points_[i], at.d) + offset(i, at.load_factor);
  out[length()] = at.load_factor;
  return out;
}

Iterate CrackedEquations::start_at(const State& guess, const Rule& rule, bool walks) {
  is_condensed_ = false;
  origin_ = pulled_by_offsets();
  const std::vector<double>& dead = origin_ ? *origin_ : linear_.dead_solution();
  z_origin_ = Vector::Zero(length());
  load_origin_ = 0;
  for (std::size_t i = 0; i < points_.size(); ++i)
    pair_of(dead_, i) = system_.equilibrium().opening(points_[i], dead) + offset(i, 0);
  q_ = openings(guess).head(length());
  if (control_.gauge) gauge_dead_ = control_.gauge->value(dead, 0);
  load_factor_ = guess.load_factor;
  scale_ = std::max({dead_.lpNorm<Eigen::Infinity>(), q_.lpNorm<Eigen::Infinity>(),
                     std::abs(load_factor_) * live_.lpNorm<Eigen::Infinity>()});
  evaluate();
  rule_ = rule;
  walks_ = walks;
  pieces_ = {};
  rises_ = 0;
  start_.assign(q_.begin(), q_.end());
  return {start_, load_factor_};
}

/// d_dead with the forces of the multipliers of all points without columns, D_base m, and of what initial stress opens,
/// D_base q₀; nothing where there are none.
std::shared_ptr<const std::vector<double>> CrackedEquations::pulled_by_offsets() const {
  const std::vector<double>& initial = system_.loading().dead_offset;
  std::vector<double> offsets = initial;
  if (system_.iterates_multipliers()) {
    const std::vector<Vec2>& multipliers = system_.multipliers();
    offsets.resize(2 * multipliers.size(), 0.0);
    const std::set<std::size_t> with_columns(points_.begin(), points_.end());
    for (std::size_t p = 0; p < multipliers.size(); ++p)
      if (!with_columns.contains(p)) Eigen::Map<Vec2>(&offsets[2 * p]) += multipliers[p];
  }
  const std::vector<double> change = opened_by(offsets);
  if (change.empty()) return {};
  std::vector<double> out = linear_.dead_solution();
  for (std::size_t k = 0; k < out.size(); ++k) out[k] += change[k];
  return std::make_shared<const std::vector<double>>(std::move(out));
}

/// −K_base⁻¹ Bᵀ W D_base q₀ of such openings, 2 per point; empty where they are none.
std::vector<double> CrackedEquations::opened_by(const std::vector<double>& offsets) const {
  if (std::ranges::all_of(offsets, [](double q) { return q == 0; })) return {};
  std::vector<double> tractions(offsets.size()), out(system_.equilibrium().num_unknowns(), 0.0);
  for (std::size_t p = 0; 2 * p < offsets.size(); ++p) {
    const Eigen::Map<const Vec2> offset(&offsets[2 * p]);
    Eigen::Map<Vec2> traction(&tractions[2 * p]);
    traction = -linear_.base()[p] * offset;
  }
  system_.equilibrium().scatter_add(tractions, out);
  linear_.solve_base(out, out);
  return out;
}

Iterate CrackedEquations::go_on_walking(const Rule& rule) {
  walk_start_.resize(length() + 1);
  walk_start_ << q_, load_factor_;
  rule_ = rule;
  rule_.searches = false;
  walks_ = true;
  rises_ = 0;
  start_.assign(q_.begin(), q_.end());
  return {start_, load_factor_};
}

void CrackedEquations::residual(const Iterate& at, std::span<double> out) {
  evaluate(at);
  Eigen::Map<Vector>(out.data(), length()) = gap();
}

double CrackedEquations::norm(const Iterate& at) {
  evaluate(at);
  return gap().norm();
}

void CrackedEquations::load_derivative(const Iterate&, std::span<double> out) {
  Eigen::Map<Vector>(out.data(), length()) = -live_;
}

/// 1 + G E: of what is left when the points whose E has stayed are eliminated.
bool CrackedEquations::factorise(const Iterate& at) {
  evaluate(at);
  if (std::exchange(is_factorised_, true)) return true;
  if (std::exchange(is_condensed_, true))
    update_.set(change_);
  else
    update_.begin(change_, steady_points());
  return true;
}

/// Points whose tangent is the same a little further on: their piece of the law is linear.
std::vector<bool> CrackedEquations::steady_points() const {
  constexpr double further = 1.001, round_off = 1e-12;
  std::vector<bool> out(points_.size(), false);
  for (const std::size_t i : active_) {
    const Mat2 there = system_.respond(points_[i], further * pair_of(q_, i)).tangent;
    const Mat2 here = system_.respond(points_[i], pair_of(q_, i)).tangent;
    out[i] = (there - here).cwiseAbs().maxCoeff() <= round_off * here.cwiseAbs().maxCoeff();
  }
  return out;
}

void CrackedEquations::solve(const Iterate&, std::span<const std::span<double>> columns) {
  Matrix x(length(), std::ssize(columns));
  for (std::size_t c = 0; c < columns.size(); ++c)
    x.col(static_cast<Eigen::Index>(c)) = Eigen::Map<const Vector>(columns[c].data(), length());
  update_.solve(x);
  for (std::size_t c = 0; c < columns.size(); ++c)
    Eigen::Map<Vector>(columns[c].data(), length()) = x.col(static_cast<Eigen::Index>(c));
}

void CrackedEquations::multiply(const Iterate&, std::span<const double> in, std::span<double> out) {
  const Matrix x = Eigen::Map<const Vector>(in.data(), length());
  Matrix y = -x;
  update_.subtract_product(x, y);
  Eigen::Map<Vector>(out.data(), length()) = -y;
}

double CrackedEquations::control(const Iterate& at) {
  evaluate(at);
  return (value() - control_.target) / control_.scale;
}

double CrackedEquations::control_gradient(const Iterate& at, std::span<double> per_x) {
  evaluate(at);
  Eigen::Map<Vector> out(per_x.data(), length());
  if (control_.spends) out += spending_ / control_.scale;
  if (!control_.gauge) return 0;
  for (const std::size_t i : active_) {
    const auto place = 2 * static_cast<Eigen::Index>(i);
    out.segment<2>(place) -= change_[i].transpose() * along_.segment<2>(place) / control_.scale;
  }
  return gauge_live_ / control_.scale;
}

Verdict CrackedEquations::judge(const Iterate& at, int iterations) {
  evaluate(at);
  if (!q_.allFinite() || !std::isfinite(load_factor_))
    return {Verdict::Kind::failed, "the iterate is not a number"};
  return walks_ ? judge_walks(iterations) : judge_newton(iterations);
}

Verdict CrackedEquations::judge_newton(int iterations) {
  using enum Verdict::Kind;
  constexpr double rounding = 1e-12;  // below which the equations cannot be met better
  const bool stands =
      iterations > 0 && (q_ - before_).lpNorm<Eigen::Infinity>() <= rounding * opening_scale();
  before_ = q_;
  if (stands || is_solved(rule_.accuracy)) return {converged};
  pieces_.see(pieces());
  if (pieces_.returns() && !rule_.may_settle)
    return {failed, "the iteration cycles between sets of loading points"};
  if (iterations >= rule_.most || pieces_.on_seen_sets() > rule_.max_iterations)
    return {failed, fmt::format("no convergence in {} iterations on the cracked points", iterations)};
  return {goes_on, "no further iterate was found on the cracked points"};
}

void CrackedEquations::refine() {
  constexpr int times = 2;
  for (int i = 0; i < times; ++i) {
    const State at = state_here();
    std::vector<double> change = unbalanced(at), origin = at.d;
    linear_.solve_base(change, change);
    for (std::size_t k = 0; k < change.size(); ++k) origin[k] -= change[k];
    origin_ = std::make_shared<const std::vector<double>>(std::move(origin));
    z_origin_ = z_;
    load_origin_ = load_factor_;
    difference_.setZero();
    coupled_.reset();
  }
  const State at = state_here();
  for (std::size_t i = 0; i < points_.size(); ++i)
    pair_of(dead_, i) = system_.jump(points_[i], at.d) + offset(i, at.load_factor);
  if (control_.gauge) gauge_dead_ = at.value(*control_.gauge);
}

/// The equations of the whole structure at d, with the z of the iteration. Weak springs are none of it: where
/// several courses slide under the same load they alone would tell which, by forces that are next to nothing.
std::vector<double> CrackedEquations::unbalanced(const State& at) const {
  const LawValues laws = system_.laws(at);
  std::vector<double> out(at.d.size()), differences(2 * laws.opening.size(), 0.0);
  system_.residual(at.d, at.load_factor, laws, out);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t p = points_[i];
    const Vec2 q = pair_of(q_, i);
    Eigen::Map<Vec2> difference(&differences[2 * p]);
    difference =
        system_.respond(p, q).traction - laws.traction[p] - linear_.base()[p] * (q - laws.opening[p]);
  }
  system_.equilibrium().scatter_add(differences, out);
  system_.equilibrium().subtract_weak_forces(at.d, out);
  return out;
}

State CrackedEquations::state(const Iterate& at) {
  evaluate(at);
  return state_here();
}

double CrackedEquations::residual_norm(const State& at) const {
  const Equilibrium& equilibrium = system_.equilibrium();
  std::map<BlockId, Vec6> forces;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t p = points_[i];
    const InterfacePoint& point = equilibrium.point(p);
    const Vec2 q = system_.jump(p, at.d) + offset(i, at.load_factor);
    const Vec2 missed =
        point.weight * (system_.respond(p, q).traction - linear_.base()[p] * (q - multiplier(i))) -
        pair_of(z_, i);
    point.for_each_part([&](BlockId node, const Mat26& rows) {
      forces.try_emplace(node, Vec6::Zero()).first->second += rows.transpose() * missed;
    });
  }
  double sum = 0;
  for (const auto& [node, force] : forces) sum += system_.square_of_residual(node, force);
  return std::sqrt(sum);
}

State CrackedEquations::state_here() {
  const double load = load_factor_ - load_origin_;
  auto origin = origin_;
  if (!live_change_.empty() && load != 0) {
    std::vector<double> moved = origin_ ? *origin_ : linear_.dead_solution();
    for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += load * live_change_[k];
    origin = std::make_shared<const std::vector<double>>(std::move(moved));
  }
  return {linear_.combined({.origin = std::move(origin), .load_factor = load, .z = difference_}),
          load_factor_};
}

double CrackedEquations::opening_scale() const {
  constexpr double far = 100;
  const double loads = std::max(scale_, std::abs(load_factor_) * live_.lpNorm<Eigen::Infinity>());
  return std::clamp(q_.lpNorm<Eigen::Infinity>(), loads, far * loads);
}

double CrackedEquations::largest_miss(Accuracy accuracy) const {
  constexpr double least = 1e-3;
  const double opened = opening_scale();
  return good *
         (accuracy == Accuracy::of_what_is_carried ? std::clamp(carried_, least * opened, opened) : opened);
}

bool CrackedEquations::is_solved(Accuracy accuracy) const {
  return gap().lpNorm<Eigen::Infinity>() <= largest_miss(accuracy) &&
         std::abs(value() - control_.target) <= std::max(good * control_.scale, rounding_of_value());
}

/// What rounding leaves of the gauge, a sum in which much may cancel.
double CrackedEquations::rounding_of_value() const {
  constexpr double round_off = 1e-15;
  if (!control_.gauge) return 0;
  return round_off * (std::abs(gauge_dead_) + std::abs((load_factor_ - load_origin_) * gauge_live_) +
                      along_.cwiseAbs().dot(difference_.cwiseAbs()));
}

void CrackedEquations::evaluate(const Iterate& at) {
  if (at.load_factor == load_factor_ && std::ranges::equal(at.x, q_)) return;
  q_ = Eigen::Map<const Vector>(at.x.data(), length());
  load_factor_ = at.load_factor;
  evaluate();
}

/// z and its derivative E at q; which points are not as in the base.
void CrackedEquations::evaluate() {
  is_factorised_ = false;
  z_ = Vector::Zero(length());
  change_.assign(points_.size(), Mat2::Zero());
  spent_ = carried_ = 0;
  spending_ = Vector::Zero(length());
  active_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t p = points_[i];
    const InterfacePoint& point = system_.equilibrium().point(p);
    const Vec2 q = pair_of(q_, i), jump = q - multiplier(i);
    const Response now = system_.respond(p, q);
    carried_ = std::max(carried_, now.traction.norm() / point.spring_unit);
    if (control_.spends) {
      const Spending spending = point.law->spending(q, system_.history()[p], point.stiffness);
      spent_ += point.weight * spending.value;
      pair_of(spending_, i) = point.weight * spending.gradient;
    }
    if (linear_.is_as_in_base(p, jump, now)) continue;
    active_.push_back(i);
    pair_of(z_, i) = point.weight * (now.traction - linear_.base()[p] * jump);
    change_[i] = point.weight * (now.tangent - linear_.base()[p]);
  }
  difference_ = z_ - z_origin_;
  coupled_.reset();
}

/// A fingerprint of the pieces of their laws that the points are on.
std::size_t CrackedEquations::pieces() const {
  std::size_t hash = 1469598103934665603ull;  // FNV-1a
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const InterfacePoint& point = system_.equilibrium().point(points_[i]);
    const std::size_t piece =
        point.law->piece(pair_of(q_, i), system_.history()[points_[i]], point.stiffness);
    hash = (hash ^ (piece + 32 * (piece ? points_[i] + 1 : 0))) * 1099511628211ull;
  }
  return hash;
}

/// q − q_dead − (λ − λ₀) q_ref + G (z − z₀).
Eigen::VectorXd CrackedEquations::gap() const {
  if (!coupled_) coupled_ = linear_.coupled(difference_).head(length());
  return q_ - dead_ - (load_factor_ - load_origin_) * live_ + *coupled_;
}

/// Gauge and energy spent, as the control adds them.
double CrackedEquations::value() const {
  double out = control_.spends ? spent_ : 0;
  if (control_.gauge)
    out += gauge_dead_ + (load_factor_ - load_origin_) * gauge_live_ - along_.dot(difference_);
  return out;
}

}  // namespace dda
