#include "continuation/contact/cracked_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/base/threads.hpp"

namespace dda {
namespace {

auto pair(Eigen::VectorXd& v, std::size_t i) { return v.segment<2>(2 * static_cast<Eigen::Index>(i)); }
auto pair(const Eigen::VectorXd& v, std::size_t i) { return v.segment<2>(2 * static_cast<Eigen::Index>(i)); }

/// By so much the equations may be missed, of the size of the openings or of what the points carry.
constexpr double good = 1e-11;

}  // namespace

CrackedPoints::CrackedPoints(const System& system, LinearSystem& linear, const ControlSum& control)
    : system_(system),
      linear_(linear),
      control_(control),
      points_(linear_.updated_points()),
      dead_(size()),
      live_(size()) {
  for (std::size_t i = 0; i < points_.size(); ++i)
    pair(live_, i) = system.equilibrium().opening(points_[i], linear_.reference_solution());
  only_touch_ = std::ranges::all_of(
      points_, [&](std::size_t p) { return system.equilibrium().point(p).is_separate(); });
  if (!control.gauge) return;
  gauge_live_ = control.gauge->value(linear_.reference_solution(), 1) - control.gauge->constant;
  along_ = linear_.along_columns(*control.gauge);
}

Vec2 CrackedPoints::multiplier(std::size_t i) const {
  return system_.iterates_multipliers() ? system_.multipliers()[points_[i]] : Vec2(Vec2::Zero());
}

void CrackedPoints::start_at(const State& guess) {
  origin_ = linear_.dead_solution();
  z_origin_ = Vector::Zero(size());
  q_.resize(size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    pair(dead_, i) = system_.equilibrium().opening(points_[i], origin_) + multiplier(i);
    pair(q_, i) = system_.equilibrium().opening(points_[i], guess.d) + multiplier(i);
  }
  if (control_.gauge) gauge_dead_ = control_.gauge->value(origin_, 0);
  load_factor_ = guess.load_factor;
  scale_ = std::max({dead_.lpNorm<Eigen::Infinity>(), q_.lpNorm<Eigen::Infinity>(),
                     std::abs(load_factor_) * live_.lpNorm<Eigen::Infinity>()});
  evaluate();
}

std::optional<int> CrackedPoints::newton(int max_iterations, Cycles cycles) {
  constexpr int most = 50;
  std::set<std::size_t> seen;
  std::size_t last = 0;
  int counted = 0;
  for (int iteration = 0; iteration <= most; ++iteration) {
    if (is_solved()) return iteration;
    const std::size_t now = pieces();
    const bool is_old = !seen.insert(now).second;
    if (is_old && now != last && cycles == Cycles::end_it) return {};
    last = now;
    if (is_old && counted++ >= max_iterations) return {};
    const double step = correct();
    if (!std::isfinite(step)) return {};
    evaluate();
    constexpr double rounding = 1e-12;  // below which the equations cannot be met better
    if (step <= rounding * opening_scale()) return iteration + 1;
  }
  return {};
}

std::optional<int> CrackedPoints::walk(int max_iterations, int at_least, Accuracy accuracy) {
  double before = std::numeric_limits<double>::infinity();
  int rises = 0;
  for (int iteration = 0; iteration <= max_iterations; ++iteration) {
    if (iteration >= at_least && is_solved(accuracy)) return iteration;
    const double error = gap().lpNorm<Eigen::Infinity>();
    constexpr int most_rises = 5;
    constexpr double smaller = 0.03, hardly = 1e-8;  // what rounding leaves the full equations judge
    if (iteration > 1 && error > 0.5 * before && ++rises > most_rises)
      return error <= hardly * opening_scale() ? std::optional(iteration) : std::nullopt;
    before = error;
    linearise();
    ResidualStiffness residual;
    residual.share *= std::pow(smaller, rises);
    Vector start(size() + 1);
    start << q_, load_factor_;
    auto found = walk_from(problem_, start, matrix_, residual);
    if (!found) found = walk_proximally(problem_, start, matrix_, residual);
    if (!found) found = walk_covered(problem_, matrix_, residual);
    if (!found || !found->allFinite()) return {};
    q_ = found->head(size());
    load_factor_ = (*found)[size()];
    evaluate();
  }
  return {};
}

void CrackedPoints::refine() {
  const std::vector<double>& live = linear_.reference_solution();
  constexpr int times = 2;
  for (int i = 0; i < times; ++i) {
    const State at = state();
    std::vector<double> change = unbalanced(at);
    linear_.solve_base(change, change);
    for (std::size_t k = 0; k < change.size(); ++k) origin_[k] = at.d[k] - change[k] - load_factor_ * live[k];
    z_origin_ = z_;
    difference_.setZero();
  }
  const State at = state();
  for (std::size_t i = 0; i < points_.size(); ++i)
    pair(dead_, i) =
        system_.equilibrium().opening(points_[i], at.d) + multiplier(i) - load_factor_ * pair(live_, i);
  if (control_.gauge) gauge_dead_ = control_.gauge->value(at.d, load_factor_) - load_factor_ * gauge_live_;
}

/// The equations of the whole structure at d, with the z of the iteration. Weak springs are none of it: where
/// several courses slide under the same load they alone would tell which, by forces that are next to nothing.
std::vector<double> CrackedPoints::unbalanced(const State& at) const {
  const LawValues laws = system_.laws(at.d, at.load_factor);
  std::vector<double> out(at.d.size()), differences(2 * laws.opening.size(), 0.0);
  system_.residual(at.d, at.load_factor, laws, out);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t p = points_[i];
    const Vec2 q = pair(q_, i);
    Eigen::Map<Vec2> difference(&differences[2 * p]);
    difference =
        system_.respond(p, q).traction - laws.traction[p] - linear_.base()[p] * (q - laws.opening[p]);
  }
  system_.equilibrium().scatter_add(differences, out);
  system_.equilibrium().subtract_weak_forces(at.d, out);
  return out;
}

State CrackedPoints::state() const {
  State out{origin_, load_factor_};
  const std::vector<double>& live = linear_.reference_solution();
  for (std::size_t i = 0; i < out.d.size(); ++i) out.d[i] += load_factor_ * live[i];
  std::vector<std::size_t> points;
  std::vector<double> z;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (pair(difference_, i).isZero(0)) continue;
    points.push_back(points_[i]);
    for (const double component : pair(difference_, i)) z.push_back(component);
  }
  const Matrix forces = Eigen::Map<const Vector>(z.data(), std::ssize(z));
  const std::span<double> d(out.d);
  linear_.subtract_columns(points, forces, std::span<const std::span<double>>(&d, 1));
  return out;
}

double CrackedPoints::opening_scale() const {
  constexpr double far = 100;
  const double loads = std::max(scale_, std::abs(load_factor_) * live_.lpNorm<Eigen::Infinity>());
  return std::clamp(q_.lpNorm<Eigen::Infinity>(), loads, far * loads);
}

double CrackedPoints::largest_miss(Accuracy accuracy) const {
  constexpr double least = 1e-3;
  const double opened = opening_scale();
  return good *
         (accuracy == Accuracy::of_what_is_carried ? std::clamp(carried_, least * opened, opened) : opened);
}

bool CrackedPoints::is_solved(Accuracy accuracy) const {
  return gap().lpNorm<Eigen::Infinity>() <= largest_miss(accuracy) &&
         std::abs(value() - control_.target) <= std::max(good * control_.scale, rounding_of_value());
}

/// What rounding leaves of the gauge, a sum in which much may cancel.
double CrackedPoints::rounding_of_value() const {
  constexpr double round_off = 1e-15;
  if (!control_.gauge) return 0;
  return round_off * (std::abs(gauge_dead_) + std::abs(load_factor_ * gauge_live_) +
                      along_.cwiseAbs().dot(difference_.cwiseAbs()));
}

/// z and its derivative E at q; which points are not as in the base.
void CrackedPoints::evaluate() {
  z_ = Vector::Zero(size());
  change_.assign(points_.size(), Mat2::Zero());
  spent_ = carried_ = 0;
  spending_ = Vector::Zero(size());
  active_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t p = points_[i];
    const InterfacePoint& point = system_.equilibrium().point(p);
    const Vec2 q = pair(q_, i), jump = q - multiplier(i);
    const Response now = system_.respond(p, q);
    carried_ = std::max(carried_, now.traction.norm() / point.spring_unit);
    if (control_.spends) {
      const Spending spending = point.law->spending(q, system_.history()[p], point.stiffness);
      spent_ += point.weight * spending.value;
      pair(spending_, i) = point.weight * spending.gradient;
    }
    if (linear_.is_as_in_base(p, jump, now)) continue;
    active_.push_back(i);
    pair(z_, i) = point.weight * (now.traction - linear_.base()[p] * jump);
    change_[i] = point.weight * (now.tangent - linear_.base()[p]);
  }
  difference_ = z_ - z_origin_;
}

/// A fingerprint of the pieces of their laws that the points are on.
std::size_t CrackedPoints::pieces() const {
  std::size_t hash = 1469598103934665603ull;  // FNV-1a
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const InterfacePoint& point = system_.equilibrium().point(points_[i]);
    const std::size_t piece = point.law->piece(pair(q_, i), system_.history()[points_[i]], point.stiffness);
    hash = (hash ^ (piece + 32 * (piece ? points_[i] + 1 : 0))) * 1099511628211ull;
  }
  return hash;
}

/// q − q_dead − λ q_ref + G (z − z₀).
Eigen::VectorXd CrackedPoints::gap() const {
  constexpr std::size_t rows_at_once = 500;
  Vector out = q_ - dead_ - load_factor_ * live_;
  parallel_pieces(static_cast<std::size_t>(size()), rows_at_once, [&](std::size_t begin, std::size_t end) {
    const auto first = static_cast<Eigen::Index>(begin), rows = static_cast<Eigen::Index>(end - begin);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (!pair(difference_, i).isZero(0))
        out.segment(first, rows).noalias() += couplings(i).middleRows(first, rows) * pair(difference_, i);
  });
  return out;
}

/// One Newton step; its largest change of an opening.
double CrackedPoints::correct() {
  Matrix columns(size(), 2 * static_cast<Eigen::Index>(active_.size()));
  constexpr std::size_t columns_at_once = 64;
  parallel_for(active_.size(), columns_at_once, [&](std::size_t a) {
    columns.middleCols<2>(2 * static_cast<Eigen::Index>(a)) = couplings(active_[a]) * change_[active_[a]];
  });
  Matrix x(size(), 2);
  x.col(0) = gap();
  x.col(1) = live_;
  solve_in_place(columns, x);
  const double miss = value() - control_.target;
  const double along = slope(x.col(1)) + (control_.gauge ? gauge_live_ : 0);
  const double change = -(miss - slope(x.col(0))) / along;
  const Vector step = change * x.col(1) - x.col(0);
  q_ += step;
  load_factor_ += change;
  return step.lpNorm<Eigen::Infinity>();
}

/// x ← (1 + G E)⁻¹ x, from the columns of G E that are not zero.
void CrackedPoints::solve_in_place(const Matrix& columns, Matrix& x) const {
  const Eigen::Index n = columns.cols();
  if (n == 0) return;
  Matrix matrix(n, n), right(n, 2);
  for (Eigen::Index a = 0; a < n / 2; ++a) {
    const auto at = 2 * static_cast<Eigen::Index>(active_[static_cast<std::size_t>(a)]);
    matrix.middleRows<2>(2 * a) = columns.middleRows<2>(at);
    right.middleRows<2>(2 * a) = x.middleRows<2>(at);
  }
  matrix.diagonal().array() += 1;
  DenseLu lu;
  lu.compute(std::move(matrix));  // a singular one gives a step that is no number
  x.noalias() -= columns * lu.solve(std::move(right));
}

/// Gauge and energy spent, as the control adds them.
double CrackedPoints::value() const {
  double out = control_.spends ? spent_ : 0;
  if (control_.gauge) out += gauge_dead_ + load_factor_ * gauge_live_ - along_.dot(difference_);
  return out;
}

/// Their change along a change of the openings, the load factor staying.
double CrackedPoints::slope(const Vector& dq) const {
  double out = control_.spends ? spending_.dot(dq) : 0;
  if (!control_.gauge) return out;
  for (const std::size_t i : active_) {
    const auto at = 2 * static_cast<Eigen::Index>(i);
    out -= along_.segment<2>(at).dot(change_[i] * dq.segment<2>(at));
  }
  return out;
}

/// All but contact and friction made linear where the iteration stands, the control in units of the openings:
/// in powers of two, so that the matrix is hardly ever another one for it.
void CrackedPoints::linearise() {
  const Eigen::Index n = size();
  const double size_now = opening_scale();
  const bool has_unit = size_now > 0 && control_.scale > 0;
  const double unit = has_unit ? std::exp2(std::round(std::log2(size_now / control_.scale))) : 1;
  if (unit != unit_ || control_.spends) set_coefficients(unit);
  const double spent = control_.spends ? spent_ - spending_.dot(q_) : 0;
  problem_.constant.resize(n + 1);
  problem_.constant << -dead_, unit * ((control_.gauge ? gauge_dead_ : 0) + spent - control_.target);
  problem_.constant -= problem_.couplings * z_origin_;
  problem_.accuracy = 1e-3 * good * size_now;
  problem_.points.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) problem_.points.push_back(point_of(i));
}

void CrackedPoints::set_coefficients(double unit) {
  const Eigen::Index n = size();
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
ContactProblem::Point CrackedPoints::point_of(std::size_t i) const {
  const std::size_t p = points_[i];
  const InterfacePoint& point = system_.equilibrium().point(p);
  const History& h = system_.history()[p];
  const Vec2 q = pair(q_, i);
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
  if (is_damaged &&
      point.law->equivalent_opening(q, h, point.stiffness) > point.law->kappa(h, point.stiffness))
    out.contact.reset();
  return out;
}

}  // namespace dda
