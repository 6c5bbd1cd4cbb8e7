#include "continuation/linear/linear_system.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

LinearSystem::LinearSystem(const Equilibrium& equilibrium, const DirectSolverChoice& solver, Update update)
    : equilibrium_(equilibrium), solver_(solver.make()), update_(update), slot_(equilibrium.num_crackable(), -1) {
  std::vector<Mat2> intact(equilibrium.num_crackable());
  for (std::size_t p = 0; p < intact.size(); ++p)
    intact[p] = equilibrium.point(p).trial_stiffness().asDiagonal();
  if (!rebase(intact)) throw InputError({}, "the stiffness matrix is singular; check supports and materials");
}

BlockMatrix LinearSystem::matrix_with(std::span<const Mat2> tangents) const {
  BlockMatrix a = equilibrium_.intact();
  for (std::size_t p = 0; p < tangents.size(); ++p) {
    const InterfacePoint& point = equilibrium_.point(p);
    const Mat2 change = point.weight * (tangents[p] - Mat2(point.trial_stiffness().asDiagonal()));
    if (change.isZero(0)) continue;
    const Mat26 first = change * point.rows.first, second = change * point.rows.second;
    a.add(point.first, point.first, point.rows.first.transpose() * first);
    a.add(point.second, point.second, point.rows.second.transpose() * second);
    a.add(point.first, point.second, point.rows.first.transpose() * second);
    a.add(point.second, point.first, point.rows.second.transpose() * first);
  }
  return a;
}

bool LinearSystem::rebase(std::span<const Mat2> tangents) {
  base_.assign(tangents.begin(), tangents.end());
  tangent_ = base_;
  updated_.clear();
  active_.clear();
  z_.clear();
  std::ranges::fill(slot_, -1);
  kept_solution_.clear();
  ++num_factorisations_;
  return solver_->factor(matrix_with(tangents));
}

bool LinearSystem::restore(std::span<const Mat2> base, std::span<const std::size_t> updated) {
  if (!rebase(base)) return false;
  for (const std::size_t point : updated) add_columns(point);
  return true;
}

bool LinearSystem::wants_rebase() const {
  const double rank = 2 * static_cast<double>(updated_.size());
  constexpr double iterations_per_base = 10, smallest_rank = 48;
  return rank > smallest_rank && iterations_per_base * 2.0 / 3.0 * rank * rank * rank > solver_->factor_flops();
}

bool LinearSystem::set_tangent(std::span<const Mat2> tangents) {
  if (update_ == Update::refactorise)
    return std::ranges::equal(tangents, base_) || rebase(tangents);
  tangent_.assign(tangents.begin(), tangents.end());
  active_.clear();
  for (std::size_t p = 0; p < tangents.size(); ++p) {
    if (tangents[p] == base_[p]) continue;
    if (slot_[p] < 0) add_columns(p);
    active_.push_back(p);
  }
  return factor_small();
}

/// Computes Z for one point and its couplings in G with every point before it. Always one point at a time, so that
/// a restored run makes the same numbers.
void LinearSystem::add_columns(std::size_t point) {
  const std::size_t s = updated_.size();
  slot_[point] = static_cast<int>(s);
  updated_.push_back(point);
  z_.resize(2 * n() * updated_.size(), 0.0);
  const std::span<double> columns(z_.data() + 2 * n() * s, 2 * n());
  const InterfacePoint& at = equilibrium_.point(point);
  for (int c = 0; c < 2; ++c) {
    const std::span<double> column = columns.subspan(static_cast<std::size_t>(c) * n(), n());
    Eigen::Map<Vec6>(column.data() + 6 * at.first.value()) += at.rows.first.row(c).transpose();
    Eigen::Map<Vec6>(column.data() + 6 * at.second.value()) += at.rows.second.row(c).transpose();
  }
  solver_->solve(columns, 2);
  num_solves_ += 2;
  if (g_.rows() < static_cast<Eigen::Index>(2 * s + 2)) g_.conservativeResize(4 * static_cast<Eigen::Index>(s) + 16, 4 * static_cast<Eigen::Index>(s) + 16);
  for (std::size_t a = 0; a <= s; ++a)
    for (int c = 0; c < 2; ++c) {
      const auto row = static_cast<Eigen::Index>(2 * a), column = static_cast<Eigen::Index>(2 * s) + c;
      g_.block<2, 1>(row, column) = rows_times(updated_[a], columns.subspan(static_cast<std::size_t>(c) * n(), n()));
      if (a < s) g_.block<1, 2>(column, row) = g_.block<2, 1>(row, column).transpose();
    }
}

bool LinearSystem::factor_small() {
  const auto r = static_cast<Eigen::Index>(2 * active_.size());
  if (r == 0) return true;
  Eigen::MatrixXd m = Eigen::MatrixXd::Identity(r, r);
  for (std::size_t a = 0; a < active_.size(); ++a) {
    const Mat2 e = equilibrium_.point(active_[a]).weight * (tangent_[active_[a]] - base_[active_[a]]);
    for (std::size_t b = 0; b < active_.size(); ++b)
      m.block<2, 2>(2 * static_cast<Eigen::Index>(a), 2 * static_cast<Eigen::Index>(b)) +=
          e * g_.block<2, 2>(2 * slot_[active_[a]], 2 * slot_[active_[b]]);
  }
  small_.compute(m);
  const auto pivots = small_.matrixLU().diagonal().cwiseAbs();
  return std::isfinite(pivots.sum()) && pivots.minCoeff() > 0;
}

void LinearSystem::keep_solution_of(std::vector<double> b) {
  kept_ = std::move(b);
  kept_solution_.clear();
}

void LinearSystem::base_solve(std::span<const double> b, std::span<double> x) {
  const bool same = std::ranges::equal(b, kept_);
  const bool opposite = !same && std::ranges::equal(b, kept_, [](double u, double v) { return u == -v; });
  if ((same || opposite) && !kept_solution_.empty()) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = same ? kept_solution_[i] : -kept_solution_[i];
    return;
  }
  std::ranges::copy(b, x.begin());
  solver_->solve(x, 1);
  ++num_solves_;
  if (!same && !opposite) return;
  kept_solution_.assign(x.begin(), x.end());
  if (opposite)
    for (double& value : kept_solution_) value = -value;
}

void LinearSystem::solve(std::span<const double> b, std::span<double> x) {
  base_solve(b, x);
  if (active_.empty()) return;
  Eigen::VectorXd right(static_cast<Eigen::Index>(2 * active_.size()));
  for (std::size_t a = 0; a < active_.size(); ++a) {
    const Mat2 e = equilibrium_.point(active_[a]).weight * (tangent_[active_[a]] - base_[active_[a]]);
    right.segment<2>(2 * static_cast<Eigen::Index>(a)) = e * rows_times(active_[a], x);
  }
  const Eigen::VectorXd c = small_.solve(right);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * updated_.size()));
  for (std::size_t a = 0; a < active_.size(); ++a)
    all.segment<2>(2 * slot_[active_[a]]) = c.segment<2>(2 * static_cast<Eigen::Index>(a));
  const auto size = static_cast<Eigen::Index>(n());
  Eigen::Map<Eigen::VectorXd>(x.data(), size).noalias() -=
      Eigen::Map<const Eigen::MatrixXd>(z_.data(), size, static_cast<Eigen::Index>(2 * updated_.size())) * all;
}

void LinearSystem::multiply(std::span<const double> x, std::span<double> y) const {
  std::ranges::fill(y, 0.0);
  equilibrium_.intact().multiply_add(x, y);
  std::vector<double> t(2 * equilibrium_.num_crackable());
  for (std::size_t p = 0; p < equilibrium_.num_crackable(); ++p) {
    const Mat2 change = tangent_[p] - Mat2(equilibrium_.point(p).trial_stiffness().asDiagonal());
    Eigen::Map<Vec2>(t.data() + 2 * p) = change.isZero(0) ? Vec2(Vec2::Zero()) : Vec2(change * rows_times(p, x));
  }
  equilibrium_.scatter_add(t, y);
}

}  // namespace dda
