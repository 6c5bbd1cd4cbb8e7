#include "continuation/solve/reduced.hpp"

#include <algorithm>
#include <cmath>

#include "continuation/solve/equations/cracked_equations.hpp"

namespace dda {
namespace {

/// Points of some kind that are not held at a state as in the intact structure.
template <class Kind>
std::size_t count_changed(System& system, const State& at, Kind is_of_kind) {
  const auto laws = system.laws_at(at);
  std::size_t out = 0;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const Vec2 intact = point.intact_stiffness().cwiseProduct(laws->opening[p]);
    constexpr double round_off = 1e-14;
    out += (laws->traction[p] - intact).norm() > round_off * intact.norm() && is_of_kind(point);
  }
  return out;
}

}  // namespace

std::vector<std::size_t> newly_cracked(System& system, const LinearSystem& linear, const State& at) {
  const auto laws = system.laws_at(at);
  std::vector<std::size_t> out;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    if (linear.has_columns(p)) continue;
    if (!linear.is_as_in_base(p, laws->opening[p], {laws->traction[p], laws->tangent[p]})) out.push_back(p);
  }
  return out;
}

namespace {

/// Under a control that is a sum, taking points in until none is left out. What was found without the last ones
/// is where to begin where they are few, and else where the guess does not lead to the end.
std::optional<Reduced> solve_sum(Stepper& stepper, const ControlSum& sum, const StepGoal& goal) {
  System& system = stepper.system();
  Reduced out;
  constexpr int most_rounds = 8, few = 50;  // one in so many
  bool is_near = false;
  for (int round = 0; round < most_rounds; ++round) {
    CrackedEquations equations(system, system.linear(), sum);
    const auto solve_from = [&](const State& state) {
      const auto scope = system.timings().measure("reduced iterations");
      auto rule = CrackedEquations::Rule::of(stepper.parameters().newton);
      rule.may_settle = true;
      return stepper.solve({equations, equations.begin(state, rule), goal.step});
    };
    Solved found = solve_from(is_near ? out.state : goal.guess);
    if (!found.converged && round > 0) found = solve_from(is_near ? goal.guess : out.state);
    out.iterations += found.iterations;
    out.converged = found.converged;
    if (!found.converged) return out;
    out.state = equations.state({found.x, found.load_factor});
    out.x = std::move(found.x);
    const std::vector<std::size_t> added = newly_cracked(system, system.linear(), out.state);
    if (added.empty()) {
      out.residual = equations.residual_norm(out.state);
      return out;
    }
    if (!system.linear().make_columns(added)) return {};
    is_near = few * added.size() <= equations.num_points();
  }
  out.converged = false;
  return out;
}

}  // namespace

std::optional<Reduced> solve_tangents(
    System& system, const StepGoal& goal,
    const std::function<std::optional<Reduced>(const ControlSum& sum, const State& guess)>& solve) {
  constexpr int most = 20;
  constexpr double good = 1e-10;
  Reduced out{.state = goal.guess, .x = {}};
  for (int i = 0; i < most; ++i) {
    const auto laws = system.laws_at(out.state);
    const ControlPoint at = ControlPoint::at(out.state, *laws);
    if (i > 0 && std::abs(goal.control.residual(at, goal.step)) <= good) return out;
    const auto tangent = goal.control.tangent_gauge(at, goal.step);
    if (!tangent) break;
    const ControlSum sum{.gauge = &tangent->gauge, .spends = false, .target = tangent->value, .scale = 1};
    auto found = solve(sum, out.state);
    if (!found) return {};
    found->iterations += out.iterations;
    out = *std::move(found);
    if (!out.converged) return out;
  }
  out.converged = false;
  return out;
}

std::optional<Reduced> solve_reduced(Stepper& stepper, const StepGoal& goal) {
  System& system = stepper.system();
  const Loading& loading = system.loading();
  const bool has_initial_stress = !loading.dead_offset.empty() || !loading.reference_offset.empty();
  if (!system.linear().updates() || system.iterates_multipliers() || has_initial_stress) return {};
  if (const auto sum = goal.control.as_sum(goal.step)) return solve_sum(stepper, *sum, goal);
  return solve_tangents(system, goal, [&](const ControlSum& sum, const State& guess) {
    return solve_sum(stepper, sum, {goal.start, goal.control, goal.step, guess});
  });
}

bool strays(const System& system, const State& found, const State& start, const State& guess) {
  constexpr double far = 10;
  double expected = 0, missed = 0;
  for (std::size_t p = 0; p < system.history().size(); ++p) {
    const Vec2 q = system.jump(p, guess.d);
    expected = std::max(expected, (q - system.jump(p, start.d)).norm());
    missed = std::max(missed, (q - system.jump(p, found.d)).norm());
  }
  return expected > 0 && missed > far * expected;
}

std::size_t num_changed(System& system, const State& at) {
  return count_changed(system, at, [](const InterfacePoint&) { return true; });
}

std::size_t num_cracked(System& system, const State& at) {
  return count_changed(system, at, [](const InterfacePoint& point) { return !point.is_separate(); });
}

}  // namespace dda
