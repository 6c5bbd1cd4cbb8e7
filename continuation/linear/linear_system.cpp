#include "continuation/linear/linear_system.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>

#include "continuation/linear/dense/two_by_two.hpp"
#include "framework/base/threads.hpp"

namespace dda {

namespace {

constexpr double far = 1e8;  // what a base may open more than the intact structure does

bool is_exactly_symmetric(const Mat2& a) { return is_same(a.transpose(), a); }

/// Whether the traction of a joint falls in some direction in which it opens.
bool softens(const Mat2& a) {
  const Mat2 s = symmetric_part(a);
  return s(0, 0) * s(1, 1) < s(0, 1) * s(1, 0) || s.trace() < 0;
}

/// Whether something has cracked and nothing softens: which cracks will grow, and would be in the way of a new
/// base for these tangents, they do not tell.
bool is_of_unloading(const Equilibrium& equilibrium, std::span<const Mat2> tangents) {
  bool has_cracked = false;
  for (std::size_t p = 0; p < tangents.size() && !has_cracked; ++p)
    has_cracked = !equilibrium.point(p).is_separate() &&
                  !is_same(tangents[p], equilibrium.point(p).intact_stiffness().asDiagonal());
  return has_cracked && std::ranges::none_of(tangents, softens);
}

}  // namespace

LinearSystem::LinearSystem(const Equilibrium& equilibrium, std::unique_ptr<DirectSolver> solver,
                           Update update)
    : equilibrium_(equilibrium), solver_(std::move(solver)), update_(update) {
  begin_anew();
}

LinearSystem::~LinearSystem() { settle_pending(); }

BlockMatrix LinearSystem::matrix_with(std::span<const Mat2> tangents) const {
  BlockMatrix a = equilibrium_.intact();
  for (std::size_t p = 0; p < tangents.size(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const Mat2 change = point.weight * (tangents[p] - Mat2(point.intact_stiffness().asDiagonal()));
    if (change.isZero(0)) continue;
    point.for_each_part([&](BlockId i, const Mat26& left) {
      const Mat62 forces = left.transpose() * change;
      point.for_each_part([&](BlockId j, const Mat26& right) { a.add(i, j, forces * right); });
    });
  }
  return a;
}

bool LinearSystem::rebase(std::span<const Mat2> tangents) {
  settle_pending();
  const std::vector<Mat2> before = base_;
  const double stiff = reference_size();
  const auto is_made = [&](const std::vector<Mat2>& base) {
    const std::size_t beside = num_columns_beside(base, tangents);
    base_ = base;
    return factor_base() && !is_loose(stiff) && (general_ || beside <= columns_->most_at_once());
  };
  const auto is_good = [&](const std::vector<Mat2>& base) {
    return is_made(base) && (general_ || !has_loose_parts() || is_made(held(base)) || is_made(base));
  };
  if (updates_softening_) {
    constexpr double full = 0.75;  // it would soon have to be left
    std::vector<Mat2> base = stiff_base(tangents);
    const auto beside = static_cast<double>(num_columns_beside(base, tangents));
    if (beside <= full * static_cast<double>(most_held_columns()) && is_good(base)) return true;
  }
  std::vector<Mat2> symmetric(tangents.size());
  std::ranges::transform(tangents, symmetric.begin(), symmetric_part);
  const std::size_t friction = num_columns_beside(symmetric, tangents);
  if (!takes_friction(friction) && is_good(symmetric)) return true;
  if (friction > 0 && is_good({tangents.begin(), tangents.end()})) return true;
  base_ = before;  // a singular tangent is no base: the old one stays in force
  factor_base();
  return false;
}

/// Largest displacement under the reference load, in the units of the unknowns.
double LinearSystem::reference_size() {
  double out = 0;
  for (const double value : solution_of(reference_)) out = std::max(out, std::abs(value));
  return out;
}

/// Whether hardly more than weak springs holds what the base before held: couplings of the points would leave
/// no digit of what they bear.
bool LinearSystem::is_loose(double size_before) { return reference_size() > far * size_before; }

/// Whether hardly more than weak springs holds a part of the structure, which the reference load need not move: tractions of
/// intact joints at every point, of random signs, open none of them by much more than their 1 where all is held.
bool LinearSystem::has_loose_parts() {
  std::mt19937 random(1);
  std::vector<double> tractions(2 * equilibrium_.num_active()), x(n(), 0.0);
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p) {
    const Vec2 stiffness = equilibrium_.point(p).intact_stiffness();
    for (Eigen::Index i = 0; i < 2; ++i)
      tractions[2 * p + static_cast<std::size_t>(i)] = (random() % 2 == 0 ? 1 : -1) * stiffness[i];
  }
  equilibrium_.scatter_add(tractions, x);
  solver_.solve(x, 1);
  for (std::size_t p = 0; p < equilibrium_.num_active(); ++p)
    if (!(rows_times(p, x).norm() <= far)) return true;
  return false;
}

/// A base with the intact stiffness of all joints of which next to none is left.
std::vector<Mat2> LinearSystem::held(std::span<const Mat2> base) const {
  std::vector<Mat2> out;
  for (std::size_t p = 0; p < base.size(); ++p)
    out.push_back(held_at_least(base[p], equilibrium_.point(p).intact_stiffness().asDiagonal()));
  return out;
}

/// Whether a base takes the friction whose columns these are, because it would have to be replaced at once
/// beside them. Where columns of half solutions can be had is seen when the symmetric part is factorised.
bool LinearSystem::takes_friction(std::size_t columns) const {
  if (columns == 0) return false;
  return update_ == Update::refactorise || columns > (general_ ? most_whole_columns : most_columns());
}

bool LinearSystem::factor_base() {
  const auto scope = timings_->measure("factorisation");
  tangent_ = base_;
  grown_ = {{equilibrium_.num_cuts(), equilibrium_.num_nodes()}};
  updated_.clear();
  active_.clear();
  gauges_.clear();
  std::ranges::fill(slot_, -1);
  for (Kept* kept : {&reference_, &dead_}) *kept = {std::move(kept->right)};
  ++num_factorisations_;
  if (columns_) num_solves_ += columns_->num_solves();
  columns_.reset();
  if (!std::ranges::all_of(base_, is_exactly_symmetric)) {
    if (!general_) general_.emplace(MumpsMatrix::Symmetry::none);
    general_->set(matrix_with(base_));
    return general_->factor();
  }
  general_.reset();
  if (!solver_.factor(matrix_with(base_))) return false;
  batch_ = batch();
  takes_all_ = are_few();
  columns_ = update_columns(equilibrium_, solver_, batch_);
  return true;
}

void LinearSystem::solve_with_base(std::span<double> x) {
  if (general_)
    general_->solve(x, 1);
  else
    solver_.solve(x, 1);
  ++num_solves_;
}

void LinearSystem::solve_load_with_base(std::span<double> x) {
  if (general_) return solve_with_base(x);
  solver_.solve_again(x);
  ++num_solves_;
}

bool LinearSystem::start_from(std::span<const Mat2> base) {
  const bool is_new = !std::ranges::equal(base, base_);
  const bool is_good = !is_new || restore(base);
  takes_all_ = false;
  if (is_new) return is_good;
  settle_pending();
  gauges_.clear();
  updated_.clear();
  active_.clear();
  std::ranges::fill(slot_, -1);
  columns_->begin_anew();
  return true;
}

std::size_t LinearSystem::most_columns() const { return most_columns_beside(solver_.factor_flops()); }

std::size_t LinearSystem::num_columns(std::span<const Mat2> tangents,
                                      const std::function<bool(const Mat2&, std::size_t)>& needs) const {
  std::vector<bool> is_counted(tangents.size() / batch_ + 1, false);
  std::size_t out = 0;
  for (std::size_t p = 0; p < tangents.size(); ++p) {
    if (is_counted[p / batch_] || !needs(tangents[p], p)) continue;
    is_counted[p / batch_] = true;
    out += 2 * batch_;
  }
  return out;
}

std::size_t LinearSystem::num_columns_beside(std::span<const Mat2> base,
                                             std::span<const Mat2> tangents) const {
  return num_columns(tangents, [&](const Mat2& d, std::size_t p) { return !is_same(d, base[p]); });
}

std::vector<Mat2> LinearSystem::stiff_base(std::span<const Mat2> tangents) const {
  std::vector<Mat2> out;
  for (std::size_t p = 0; p < tangents.size(); ++p)
    out.push_back(!softens(tangents[p]) ? symmetric_part(tangents[p])
                  : !softens(base_[p])  ? symmetric_part(base_[p])
                                        : Mat2(equilibrium_.point(p).intact_stiffness().asDiagonal()));
  return out;
}

bool LinearSystem::needs_new_base(std::span<const Mat2> tangents) const {
  if (!updates()) return !std::ranges::equal(tangents, base_, is_same);
  const std::size_t more = num_columns(tangents, [&](const Mat2& tangent, std::size_t p) {
    return slot_[p] < 0 && !is_same(tangent, base_[p]);
  });
  const std::size_t needed = 2 * updated_.size() + more + num_border_columns();
  if (more > columns_->most_at_once() || needed > most_held_columns()) return true;
  if (needed <= most_columns() || is_of_unloading(equilibrium_, tangents)) return false;
  const std::size_t then = num_columns_beside(stiff_base(tangents), tangents);
  return 2 * then <= needed || 5 * then <= 4 * num_columns_beside(base_, tangents);  // half of the dense part
}

bool LinearSystem::set_tangent(std::span<const Mat2> tangents) {
  if (needs_new_base(tangents) && !rebase(tangents)) return false;
  tangent_.assign(tangents.begin(), tangents.end());
  active_.clear();
  for (std::size_t p = 0; p < tangents.size(); ++p)
    if (!is_same(tangents[p], base_[p])) active_.push_back(p);
  add_columns(active_);
  return factor_small();
}

bool LinearSystem::is_as_in_base(std::size_t point, const Vec2& q, const Response& now) const {
  constexpr double round_off = 1e-14;
  const Vec2 linear = base_[point] * q;
  return (now.traction - linear).norm() <= round_off * linear.norm() && is_same(now.tangent, base_[point]);
}

bool LinearSystem::make_columns(std::span<const std::size_t> points) {
  if (!updates()) return false;
  std::vector<std::size_t> batches;
  for (const std::size_t p : points)
    if (batches.empty() || batches.back() != p / batch_) batches.push_back(p / batch_);
  const std::size_t columns = 2 * batch_ * batches.size();
  if (columns > columns_->most_at_once() ||
      2 * updated_.size() + columns + num_border_columns() > most_held_columns())
    return false;
  add_columns(points);
  return true;
}

void LinearSystem::subtract_columns(std::span<const std::size_t> points, const Eigen::MatrixXd& shares,
                                    std::span<const std::span<double>> solutions) {
  if (points.empty()) return;
  const auto scope = timings_->measure("products");
  columns_->subtract(places_of(points), shares, solutions);
}

std::vector<std::size_t> LinearSystem::places_of(std::span<const std::size_t> points) const {
  std::vector<std::size_t> out;
  for (const std::size_t p : points) out.push_back(static_cast<std::size_t>(slot_[p]));
  return out;
}

bool LinearSystem::factor_small() {
  if (active_.empty()) return true;
  std::vector<Mat2> e;
  for (const std::size_t p : active_) e.push_back(update_of(p));
  return small_.compute(one_plus_couplings(e));
}

Eigen::MatrixXd LinearSystem::one_plus_couplings(const std::vector<Mat2>& e) const {
  const auto r = static_cast<Eigen::Index>(2 * active_.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Identity(r, r);
  constexpr std::size_t columns_at_once = 64;
  parallel_for(active_.size(), columns_at_once, [&](std::size_t b) {
    for (std::size_t a = 0; a < active_.size(); ++a)
      m.block<2, 2>(2 * static_cast<Eigen::Index>(a), 2 * static_cast<Eigen::Index>(b)) +=
          e[a] * coupling(active_[a], active_[b]);
  });
  return m;
}

void LinearSystem::solve_base(std::span<const double> b, std::span<double> y) {
  if (std::ranges::equal(b, reference_.right)) {
    std::ranges::copy(solution_of(reference_), y.begin());
  } else if (std::ranges::equal(b, reference_.right, [](double u, double v) { return u == -v; })) {
    std::ranges::transform(solution_of(reference_), y.begin(), std::negate{});
  } else {
    const auto scope = timings_->measure("solutions");
    std::ranges::copy(b, y.begin());
    solve_with_base(y);
  }
}

bool LinearSystem::solve_base_residual(const Iterate& at, std::span<double> y) {
  if (!columns_ || !columns_->product_is_cheap()) return false;
  constexpr std::size_t points_at_once = 4000;
  std::vector<Vec2> z(at.traction.size());
  parallel_for(z.size(), points_at_once, [&](std::size_t p) {
    const Vec2 linear = base_[p] * equilibrium_.opening(p, at.d);
    z[p] = at.traction[p] - linear;
    constexpr double round_off = 1e-14;
    if (z[p].norm() <= round_off * linear.norm()) z[p].setZero();
  });
  std::vector<std::size_t> points;
  std::vector<double> minus_z;
  for (std::size_t p = 0; p < z.size(); ++p) {
    if (z[p].isZero(0)) continue;
    if (slot_[p] < 0) return false;
    points.push_back(p);
    for (const double component : z[p]) minus_z.push_back(-equilibrium_.point(p).weight * component);
  }
  const Eigen::MatrixXd forces =
      Eigen::Map<const Eigen::VectorXd>(minus_z.data(), static_cast<Eigen::Index>(minus_z.size()));
  const std::vector<double>&live = solution_of(reference_), &dead = solution_of(dead_);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = at.d[i] - at.load_factor * live[i] - dead[i];
  subtract_columns(points, forces, std::span<const std::span<double>>(&y, 1));
  return true;
}

void LinearSystem::solve(std::span<const double> b, std::span<double> x) {
  solve_base(b, x);
  correct(std::span<const std::span<double>>(&x, 1));
}

void LinearSystem::correct(std::span<const std::span<double>> solutions) {
  if (!active_.empty()) subtract_columns(active_, shares_of(solutions), solutions);
}

Eigen::MatrixXd LinearSystem::shares_of(std::span<const std::span<double>> solutions) const {
  Eigen::MatrixXd right(2 * std::ssize(active_), std::ssize(solutions));
  for (std::size_t a = 0; a < active_.size(); ++a) {
    const Mat2 e = update_of(active_[a]);
    for (std::size_t c = 0; c < solutions.size(); ++c)
      right.block<2, 1>(2 * static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(c)) =
          e * rows_times(active_[a], solutions[c]);
  }
  return small_.solve(right);
}

void LinearSystem::multiply(std::span<const double> x, std::span<double> y) const {
  multiply(tangent_, x, y);
}

void LinearSystem::multiply(std::span<const Mat2> tangents, std::span<const double> x,
                            std::span<double> y) const {
  std::ranges::fill(y, 0.0);
  equilibrium_.intact().multiply_add(x, y);
  std::vector<double> t(2 * equilibrium_.num_active());
  constexpr std::size_t points_at_once = 4000;
  parallel_for(equilibrium_.num_active(), points_at_once, [&](std::size_t p) {
    const Mat2 change = tangents[p] - Mat2(equilibrium_.point(p).intact_stiffness().asDiagonal());
    Eigen::Map<Vec2>(t.data() + 2 * p) =
        change.isZero(0) ? Vec2(Vec2::Zero()) : Vec2(change * rows_times(p, x));
  });
  equilibrium_.scatter_add(t, y);
}

}  // namespace dda
