#include "continuation/solve/contact_solver.hpp"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

/// A tie of exact multipliers holds 1/δ times as firmly as its own stiffness P, and where a body has more
/// ties than motions the openings would answer a traction with that factor's rounding. With a share of P
/// instead the multiplier follows from the gap, m = s/(1 + δ − s) g, so that the joint of the base is a
/// spring.
constexpr double loosened = 0.9;

/// Along joints of bodies that only touch the stiff spring of an iterated multiplier makes a long slide out
/// of a tiny load: the load factor would be told from the rounding of q. A softer one leaves less of that.
constexpr double softened = 0.1;

}  // namespace

void ContactSolver::prepare(const State& guess) {
  constexpr std::size_t few = 100;
  const bool is_cracked = num_changed(system_, guess) > few;
  const auto laws = system_.laws_at(guess.d, guess.load_factor);
  std::vector<Mat2> base;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const InterfacePoint& point = system_.equilibrium().point(p);
    const History& h = system_.history()[p];
    Mat2 tangent = point.intact_stiffness().asDiagonal();
    if (is_cracked && point.law->contact(h, point.stiffness) && !point.is_separate())
      tangent = point.law->respond_frozen(laws->opening[p], h, point.stiffness).tangent;
    if (point.is_separate() && point.multiplier == Multiplier::unknown) tangent *= loosened;
    if (point.is_separate() && point.multiplier == Multiplier::iterated) tangent(1, 1) *= softened;
    base.emplace_back(0.5 * (tangent + tangent.transpose()));
  }
  LinearSystem& linear = system_.contact_linear();
  if (!linear.start_from(base)) {
    for (std::size_t p = 0; p < base.size(); ++p)
      base[p] = system_.equilibrium().point(p).intact_stiffness().asDiagonal();
    linear.start_from(base);
  }
  linear.add_points(newly_cracked(system_, linear, guess));
}

std::optional<Reduced> ContactSolver::solve(const StepGoal& goal) {
  if (has_offsets(system_) || !system_.has_contacts()) return {};
  if (const auto sum = goal.control.as_sum(goal.step)) return solve_sum(*sum, goal.start, goal.guess);
  return solve_tangents(goal);
}

/// Under a control that is a sum, taking points in until none is left out.
std::optional<Reduced> ContactSolver::solve_sum(const ControlSum& sum, const State& start,
                                                const State& guess) {
  LinearSystem& linear = system_.contact_linear();
  Reduced out{.state = guess};
  constexpr int most_rounds = 60;
  for (int round = 0; round < most_rounds; ++round) {
    if (linear.updated_points().size() > settings_.most_points) return {};
    if (!points_ || points_->num_points() != linear.updated_points().size())
      points_.emplace(system_, linear, sum);
    const auto scope = system_.timings().measure("contact");
    const auto iterations = iterate(start, guess);
    if (!iterations) return {};
    out.iterations += *iterations;
    out.state = points_->state();
    out.state.multipliers = guess.multipliers;
    const std::vector<std::size_t> added = newly_cracked(system_, linear, out.state);
    if (added.empty()) {
      refine(out);
      return out;
    }
    linear.add_points(added);
  }
  return {};
}

/// Under a control that looks at every point: its tangent is a gauge, taken anew at each state found.
std::optional<Reduced> ContactSolver::solve_tangents(const StepGoal& goal) {
  Reduced out{.state = goal.guess};
  constexpr int most = 20;
  for (int i = 0; i < most; ++i) {
    const auto laws = system_.laws_at(out.state.d, out.state.load_factor);
    const ControlPoint at{out.state.d, out.state.load_factor, *laws};
    constexpr double good = 1e-10;
    if (i > 0 && std::abs(goal.control.residual(at, goal.step)) <= good) return out;
    const auto tangent = goal.control.tangent_gauge(at, goal.step);
    if (!tangent) return {};
    const ControlSum sum{.gauge = &tangent->gauge, .spends = false, .target = tangent->value, .scale = 1};
    points_.reset();
    const auto found = solve_sum(sum, goal.start, out.state);
    if (!found) return {};
    out.state = found->state;
    out.iterations += found->iterations;
  }
  return {};
}

/// By Newton's method where something cracks, that is wanted and does it, else by walking: where only
/// contacts change one walk is all, and Newton's method steps round between their pieces.
std::optional<int> ContactSolver::iterate(const State& start, const State& guess) {
  points_->start_at(guess);
  if (tries_newton_ && !points_->only_touch())
    if (const auto iterations = points_->newton(settings_.max_iterations, CrackedPoints::Cycles::end_it))
      return iterations;
  points_->start_at(start);
  return points_->walk(settings_.max_iterations);
}

/// What rounding leaves of the equations of the whole structure is taken off as far as it can be, and where
/// bodies only touch what the weak springs bear.
void ContactSolver::refine(Reduced& found) {
  constexpr int most = 3;
  double excess = system_.excess_residual(found.state);
  const bool once = points_->only_touch();
  for (int i = 0; i < most && (excess > settings_.tolerance || (once && i == 0)); ++i) {
    using enum CrackedPoints::Accuracy;
    points_->refine();
    const auto accuracy = once && excess > settings_.tolerance ? of_what_is_carried : of_openings;
    if (!points_->walk(settings_.max_iterations, 1, accuracy)) return;
    State next = points_->state();
    next.multipliers = found.state.multipliers;
    const double left = system_.excess_residual(next);
    if (left > std::max(excess, settings_.tolerance)) return;
    excess = left;
    found.state = std::move(next);
  }
}

}  // namespace dda
