#include "continuation/reduced.hpp"

#include <cmath>

#include "framework/threads.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

auto pair(Vector& v, std::size_t i) { return v.segment<2>(2 * static_cast<Eigen::Index>(i)); }

/// The equations of the points with columns, in their order, under one control.
class CrackedPoints {
 public:
  CrackedPoints(System& system, const ControlSum& control)
      : system_(system),
        linear_(system.linear()),
        control_(control),
        points_(linear_.updated_points()),
        dead_(size()),
        live_(size()) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      pair(dead_, i) = system.equilibrium().opening(points_[i], linear_.dead_solution());
      pair(live_, i) = system.equilibrium().opening(points_[i], linear_.reference_solution());
    }
    if (!control.gauge) return;
    gauge_dead_ = control.gauge->value(linear_.dead_solution(), 0);
    gauge_live_ = control.gauge->value(linear_.reference_solution(), 1) - control.gauge->constant;
    along_ = linear_.along_columns(*control.gauge);
  }

  /// Newton from a guess; the number of iterations, or nothing.
  std::optional<int> solve(const State& guess, int max_iterations) {
    q_.resize(size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      pair(q_, i) = system_.equilibrium().opening(points_[i], guess.d);
    load_factor_ = guess.load_factor;
    evaluate();
    for (int iteration = 0; iteration <= max_iterations; ++iteration) {
      if (is_solved()) return iteration;
      const double step = correct();
      if (!std::isfinite(step)) return {};
      evaluate();
      constexpr double rounding = 1e-12;  // below which the equations cannot be met better
      if (step <= rounding * q_.lpNorm<Eigen::Infinity>()) return iteration + 1;
    }
    return {};
  }

  State state() const {
    State out{linear_.dead_solution(), load_factor_};
    const std::vector<double>& live = linear_.reference_solution();
    for (std::size_t i = 0; i < out.d.size(); ++i) out.d[i] += load_factor_ * live[i];
    std::vector<std::size_t> points;
    Matrix z(2 * static_cast<Eigen::Index>(active_.size()), 1);
    for (std::size_t a = 0; a < active_.size(); ++a) {
      points.push_back(points_[active_[a]]);
      z.middleRows<2>(2 * static_cast<Eigen::Index>(a)) =
          z_.segment<2>(2 * static_cast<Eigen::Index>(active_[a]));
    }
    const std::span<double> d(out.d);
    linear_.subtract_columns(points, z, std::span<const std::span<double>>(&d, 1));
    return out;
  }

 private:
  Eigen::Index size() const { return 2 * static_cast<Eigen::Index>(points_.size()); }

  bool is_solved() {
    constexpr double good = 1e-11;
    return gap().lpNorm<Eigen::Infinity>() <= good * q_.lpNorm<Eigen::Infinity>() &&
           std::abs(value() - control_.target) <= good * control_.scale;
  }

  /// z and its derivative E at q; which points are not as in the base.
  void evaluate() {
    z_ = Vector::Zero(size());
    change_.assign(points_.size(), Mat2::Zero());
    spent_ = 0;
    spending_ = Vector::Zero(size());
    active_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const std::size_t p = points_[i];
      const InterfacePoint& point = system_.equilibrium().point(p);
      const History& h = system_.history()[p];
      const Vec2 q = pair(q_, i);
      const Response now = point.law->respond(q, h, point.stiffness);
      if (control_.spends) {
        const Spending spending = point.law->spending(q, h, point.stiffness);
        spent_ += point.weight * spending.value;
        pair(spending_, i) = point.weight * spending.gradient;
      }
      if (linear_.is_as_in_base(p, q, now)) continue;
      active_.push_back(i);
      pair(z_, i) = point.weight * (now.traction - linear_.base()[p] * q);
      change_[i] = point.weight * (now.tangent - linear_.base()[p]);
    }
  }

  /// Columns of G of the point at a place.
  auto couplings(std::size_t i) const {
    return linear_.couplings().block(0, 2 * static_cast<Eigen::Index>(i), size(), 2);
  }

  /// q − q_dead − λ q_ref + G z.
  Vector gap() {
    constexpr std::size_t rows_at_once = 500;
    Vector out = q_ - dead_ - load_factor_ * live_;
    parallel_pieces(static_cast<std::size_t>(size()), rows_at_once, [&](std::size_t begin, std::size_t end) {
      const auto first = static_cast<Eigen::Index>(begin), rows = static_cast<Eigen::Index>(end - begin);
      for (const std::size_t i : active_)
        out.segment(first, rows).noalias() += couplings(i).middleRows(first, rows) * pair(z_, i);
    });
    return out;
  }

  /// One Newton step; its largest change of an opening.
  double correct() {
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
  void solve_in_place(const Matrix& columns, Matrix& x) const {
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
  double value() const {
    double out = control_.spends ? spent_ : 0;
    if (control_.gauge) out += gauge_dead_ + load_factor_ * gauge_live_ - along_.dot(z_);
    return out;
  }
  /// Their change along a change of the openings, the load factor staying.
  double slope(const Vector& dq) const {
    double out = control_.spends ? spending_.dot(dq) : 0;
    if (!control_.gauge) return out;
    for (const std::size_t i : active_) {
      const auto at = 2 * static_cast<Eigen::Index>(i);
      out -= along_.segment<2>(at).dot(change_[i] * dq.segment<2>(at));
    }
    return out;
  }

  System& system_;
  LinearSystem& linear_;
  const ControlSum& control_;
  const std::vector<std::size_t> points_;
  Vector dead_, live_;  ///< q_dead, q_ref
  Vector along_;        ///< Zᵀ ∂g/∂d
  double gauge_dead_ = 0, gauge_live_ = 0;
  Vector q_, z_, spending_;
  double load_factor_ = 0, spent_ = 0;
  std::vector<Mat2> change_;         ///< E
  std::vector<std::size_t> active_;  ///< places in points_ with z or E
};

/// Points without columns that are not as in the base.
std::vector<std::size_t> newly_cracked(System& system, const State& at) {
  const auto laws = system.laws_at(at.d, at.load_factor);
  std::vector<std::size_t> out;
  for (std::size_t p = 0; p < laws->opening.size(); ++p)
    if (!system.linear().has_columns(p) &&
        !system.linear().is_as_in_base(p, laws->opening[p], {laws->traction[p], laws->tangent[p]}))
      out.push_back(p);
  return out;
}

}  // namespace

std::optional<Reduced> solve_reduced(System& system, const Control& control, double s, const State& guess,
                                     int max_iterations) {
  const auto sum = control.as_sum(s);
  if (!sum || system.frozen() || !system.linear().updates() || system.iterates_multipliers()) return {};
  if (!system.loading().dead_offset.empty() || !system.loading().reference_offset.empty()) return {};
  Reduced out;
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    CrackedPoints points(system, *sum);
    const auto iterations = [&] {
      const auto scope = system.timings().measure("reduced iterations");
      return points.solve(guess, max_iterations);
    }();
    if (!iterations) return {};
    out.iterations += *iterations;
    out.state = points.state();
    const std::vector<std::size_t> added = newly_cracked(system, out.state);
    if (added.empty()) return out;
    if (!system.linear().make_columns(added)) return {};
  }
  return {};
}

}  // namespace dda
