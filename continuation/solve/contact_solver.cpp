#include "continuation/solve/contact_solver.hpp"

#include <algorithm>
#include <cmath>

#include "continuation/linear/dense/two_by_two.hpp"

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
  const auto laws = system_.laws_at(guess);
  std::vector<Mat2> base;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const InterfacePoint& point = system_.equilibrium().point(p);
    const History& h = system_.history()[p];
    Mat2 tangent = point.intact_stiffness().asDiagonal();
    if (is_cracked && point.law->contact(h, point.stiffness) && !point.is_separate())
      tangent =
          held_at_least(point.law->respond_frozen(laws->opening[p], h, point.stiffness).tangent, tangent);
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
  if (!system_.has_contacts()) return {};
  if (const auto sum = goal.control.as_sum(goal.step)) return solve_sum(*sum, goal, goal.guess);
  auto found = solve_tangents(system_, goal, [&](const ControlSum& sum, const State& guess) {
    points_.reset();
    return solve_sum(sum, goal, guess);
  });
  return found && found->converged ? std::move(found) : std::nullopt;
}

/// Under a control that is a sum, taking points in until none is left out: each time from what has been found.
std::optional<Reduced> ContactSolver::solve_sum(const ControlSum& sum, const StepGoal& goal,
                                                const State& guess) {
  LinearSystem& linear = system_.contact_linear();
  std::optional<Reduced> out;
  int iterations = 0;
  constexpr int most_rounds = 60;
  for (int round = 0; round < most_rounds; ++round) {
    if (linear.updated_points().size() > limits_.points) return {};
    if (!points_ || points_->num_points() != linear.updated_points().size())
      points_.emplace(system_, linear, sum);
    const auto scope = system_.timings().measure("contact");
    out = out ? iterate(out->state, out->state, goal.step) : iterate(goal.start, guess, goal.step);
    if (!out) return {};
    out->iterations = iterations += out->iterations;
    out->state.multipliers = guess.multipliers;
    const std::vector<std::size_t> added = newly_cracked(system_, linear, out->state);
    if (added.empty()) {
      refine(*out, goal.step);
      return out;
    }
    linear.add_points(added);
  }
  return {};
}

CrackedEquations::Rule ContactSolver::rule() const {
  auto out = CrackedEquations::Rule::of(stepper_.parameters().newton);
  out.searches = points_->num_points() <= limits_.searched;
  out.is_over = [&stepper = stepper_] { return stepper.is_broken_off(); };
  return out;
}

/// By Newton's method where something cracks, that is wanted and does it, else by walking: where only
/// contacts change one walk is all, and Newton's method steps round between their pieces, or ends far away.
std::optional<Reduced> ContactSolver::iterate(const State& start, const State& guess, double step) {
  const auto rule = this->rule();
  std::optional<Reduced> far_away;
  if (tries_newton_ && !points_->only_touch()) {
    auto found = solve_from(points_->begin(guess, rule), step, Method::newton);
    if (found && !strays(system_, found->state, start, guess)) return found;
    far_away = std::move(found);
  }
  const State& linear_at = points_->only_touch() ? start : guess;
  auto found = solve_from(points_->begin_walks(start, linear_at, rule), step, Method::walk);
  return found ? std::move(found) : std::move(far_away);
}

std::optional<Reduced> ContactSolver::solve_from(const Iterate& at, double step, Method method) {
  Solved found = stepper_.solve({*points_, at, step, method});
  if (!found.converged) return {};
  State state = points_->state({found.x, found.load_factor});
  return Reduced{.state = std::move(state), .x = std::move(found.x), .iterations = found.iterations};
}

/// What rounding leaves of the equations of the whole structure is taken off as far as it can be, and where
/// bodies only touch what the weak springs bear.
void ContactSolver::refine(Reduced& found, double step) {
  constexpr int most = 3;
  const NewtonParameters& newton = stepper_.parameters().newton;
  double excess = system_.excess_residual(found.state);
  const bool once = points_->only_touch();
  for (int i = 0; i < most && (excess > newton.tolerance || (once && i == 0)); ++i) {
    using enum CrackedEquations::Accuracy;
    points_->refine();
    auto rule = this->rule();
    rule.at_least = 1;
    rule.accuracy = once && excess > newton.tolerance ? of_what_is_carried : of_openings;
    auto next = solve_from(points_->go_on_walking(rule), step, Method::walk);
    if (!next) return;
    next->state.multipliers = found.state.multipliers;
    const double left = system_.excess_residual(next->state);
    if (left > std::max(excess, newton.tolerance)) return;
    excess = left;
    next->iterations += found.iterations;
    found = *std::move(next);
  }
}

}  // namespace dda
