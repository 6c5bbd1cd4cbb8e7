#include "continuation/linear/update_columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "continuation/linear/column_groups.hpp"
#include "continuation/linear/direct/bordered_solver.hpp"
#include "continuation/linear/shared_columns.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;

/// Z column by column. It is kept while it is small and replaced by a solution per product from then on, so
/// that memory follows the factor and not the cracks.
class WholeColumns final : public UpdateColumns {
 public:
  WholeColumns(const Equilibrium& equilibrium, DirectSolver& solver, std::size_t batch)
      : equilibrium_(equilibrium), solver_(solver), batch_(batch) {}

  void add(std::span<const std::size_t> points, Matrix& g) override {
    for (const std::span<const std::size_t> some : neighbours(points, batch_)) add_batch(some, g);
  }

  void begin_anew() override {
    points_.clear();
    z_.clear();
    keeps_z_ = true;
    std::size_t kept = 0;
    for (const auto& [first, columns] : batches_) kept += columns.size();
    if (kept > most_kept_numbers) forget();
  }

  /// They have other unknowns now.
  bool follow(std::span<const std::size_t>, std::span<const std::size_t>, std::size_t, Matrix&) override {
    return false;
  }

  void subtract(std::span<const std::size_t> places, const Matrix& shares,
                std::span<const std::span<double>> solutions) override {
    if (keeps_z_) return subtract_kept(places, shares, solutions);
    std::vector<double> product(solutions.size() * n(), 0.0);
    for (std::size_t c = 0; c < solutions.size(); ++c)
      for (std::size_t a = 0; a < places.size(); ++a)
        add_rows(points_[places[a]], shares.block<2, 1>(pair_at(a), static_cast<Eigen::Index>(c)),
                 product.data() + c * n());
    solve(product, solutions.size());
    for (std::size_t c = 0; c < solutions.size(); ++c)
      for (std::size_t i = 0; i < n(); ++i) solutions[c][i] -= product[c * n() + i];
  }

  Eigen::VectorXd along(const Functional& gauge) override {
    Eigen::VectorXd out(2 * std::ssize(points_));
    std::vector<double> solution;  // K is symmetric: Zᵀ g = U K⁻¹ g
    if (!keeps_z_) {
      solution.assign(n(), 0.0);
      gauge.add_gradient(1, solution);
      solve(solution, 1);
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t c = 0; c < 2; ++c)
        out[pair_at(i) + static_cast<Eigen::Index>(c)] =
            keeps_z_ ? gauge.value({z_[i] + c * n(), n()}, 0) - gauge.constant
                     : equilibrium_.opening(points_[i], solution)[static_cast<Eigen::Index>(c)];
    return out;
  }

  bool product_is_cheap() const override { return keeps_z_; }

  std::size_t most_at_once() const override { return most_whole_columns; }

 private:
  void add_batch(std::span<const std::size_t> points, Matrix& g) {
    const auto [kept, is_new] = batches_.try_emplace(points.front());
    std::vector<double>& columns = kept->second;
    if (is_new) columns = columns_of(points);
    const std::size_t first = points_.size();
    points_.insert(points_.end(), points.begin(), points.end());
    for (std::size_t s = first; s < points_.size(); ++s)
      couple(s, first, std::span<const double>(columns).subspan(2 * (s - first) * n(), 2 * n()), g);
    keeps_z_ = keeps_z_ && 2 * points_.size() * n() <= most_kept_numbers;
    if (keeps_z_)
      for (std::size_t at = 0; at < columns.size(); at += 2 * n()) z_.push_back(columns.data() + at);
    else
      forget();
  }

  void forget() {
    z_ = {};
    batches_ = {};
  }

  std::vector<double> columns_of(std::span<const std::size_t> points) {
    std::vector<double> out(2 * points.size() * n(), 0.0);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t c = 0; c < 2; ++c)
        add_rows(points[i], Vec2::Unit(static_cast<Eigen::Index>(c)), out.data() + (2 * i + c) * n());
    solve(out, 2 * points.size());
    return out;
  }

  std::size_t n() const { return equilibrium_.num_unknowns(); }

  void solve(std::vector<double>& columns, std::size_t count) {
    solver_.solve(columns, static_cast<int>(count));
    num_solves_ += count;
  }

  /// Uᵀ: adds the rows of a point times a force to a vector of size n.
  void add_rows(std::size_t point, const Vec2& force, double* to) const {
    equilibrium_.point(point).for_each_part([&](BlockId part, const Mat26& rows) {
      Eigen::Map<Vec6>(to + 6 * part.value()) += rows.transpose() * force;
    });
  }

  /// G of the point at a place, with columns z, and those before it; of those from `first` on one half.
  void couple(std::size_t place, std::size_t first, std::span<const double> z, Matrix& g) const {
    for (std::size_t a = 0; a < points_.size(); ++a) {
      for (std::size_t c = 0; c < 2; ++c)
        g.block<2, 1>(pair_at(a), pair_at(place) + static_cast<Eigen::Index>(c)) =
            equilibrium_.opening(points_[a], z.subspan(c * n(), n()));
      if (a < first)
        g.block<2, 2>(pair_at(place), pair_at(a)) = g.block<2, 2>(pair_at(a), pair_at(place)).transpose();
    }
  }

  void subtract_kept(std::span<const std::size_t> places, const Matrix& shares,
                     std::span<const std::span<double>> solutions) const {
    const auto size = static_cast<Eigen::Index>(n());
    for (std::size_t a = 0; a < places.size(); ++a) {
      const Eigen::Map<const Eigen::MatrixX2d> z(z_[places[a]], size, 2);
      for (std::size_t c = 0; c < solutions.size(); ++c)
        Eigen::Map<Eigen::VectorXd>(solutions[c].data(), size).noalias() -=
            z * shares.block<2, 1>(pair_at(a), static_cast<Eigen::Index>(c));
    }
  }

  const Equilibrium& equilibrium_;
  DirectSolver& solver_;
  const std::size_t batch_;
  std::vector<std::size_t> points_;
  bool keeps_z_ = true;
  /// Z by the first point of a batch, also of batches that were added before it began anew.
  std::map<std::size_t, std::vector<double>> batches_;
  std::vector<const double*> z_;  ///< n × 2 of each point
};

}  // namespace

std::size_t most_columns_beside(double factor_flops) {
  constexpr double iterations_per_base = 5, sparse_over_dense = 20, fewest = 48;
  return static_cast<std::size_t>(
      std::max(fewest, std::cbrt(1.5 * sparse_over_dense * factor_flops / iterations_per_base)));
}

std::unique_ptr<UpdateColumns> update_columns(const Equilibrium& equilibrium, BorderedSolver& solver,
                                              std::size_t batch) {
  const bool has_border = solver.border().num_nodes() > 0;
  if (const auto* shared = dynamic_cast<const SharedMatrix*>(solver.halves()); shared && !has_border)
    return shared_columns(equilibrium, *shared, batch);
  if (solver.halves()) return half_columns(equilibrium, solver, batch);
  return std::make_unique<WholeColumns>(equilibrium, solver, batch);
}

}  // namespace dda
