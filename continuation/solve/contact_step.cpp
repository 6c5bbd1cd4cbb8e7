#include "continuation/solve/contact_step.hpp"

#include <fmt/format.h>

#include <cmath>

#include "continuation/solve/contact_solver.hpp"
#include "continuation/solve/multiplier_gap.hpp"

namespace dda {
namespace {

/// Why a state does not end a step; "" when it does.
std::string missed(System& system, const StepGoal& goal, const State& at, double tolerance) {
  const auto laws = system.laws_at(at);
  const double miss = goal.control.residual(ControlPoint::at(at, *laws), goal.step);
  const double residual = system.excess_residual(at);
  if (std::abs(miss) <= control_tolerance && residual <= tolerance) return {};
  if (residual <= tolerance) return fmt::format("the control was met to {:.1e} only", std::abs(miss));
  return fmt::format("contact and friction were met to {:.1e} only", residual);
}

}  // namespace

std::size_t most_contacts(const System& system, Thoroughness thoroughness) {
  return system.joins_by_contact() || thoroughness == Thoroughness::full ? 1500 : 200;
}

namespace {

/// A search takes some 20 n corners of n² each: of many points it is left to the steps that are cut for want of it.
ContactSolver::Limits limits_of(const System& system, Thoroughness thoroughness) {
  constexpr std::size_t few = 300;
  const std::size_t most = most_contacts(system, thoroughness);
  return {.points = most, .searched = thoroughness == Thoroughness::quick ? few : most};
}

}  // namespace

Attempt contact_step(Stepper& stepper, const StepGoal& goal, Thoroughness thoroughness) {
  System& system = stepper.system();
  const StepperParameters& parameters = stepper.parameters();
  Attempt out{.state = goal.guess, .reason = "contact and friction allow no equilibrium here"};
  if (!system.has_contacts()) return out;
  const double tolerance = parameters.newton.tolerance;
  if (parameters.multipliers.predicted) system.set_multipliers(goal.guess.multipliers);
  ContactSolver solver(stepper, goal.guess, limits_of(system, thoroughness));
  const State* from = &goal.start;
  const auto solve = [&](bool tries_newton) {
    solver.try_newton(tries_newton);
    auto found = solver.solve({*from, goal.control, goal.step, out.state});
    if (found) out.reason = missed(system, goal, found->state, tolerance);
    return found;
  };
  MultiplierGap gap(system, parameters.multipliers);
  do {
    auto found = solve(true);
    if (!solver.has_walked() && (!found || !out.reason.empty())) found = solve(false);
    // It goes on from the multipliers before; where that ends, all the way is walked anew.
    const bool goes_on = from != &goal.start;
    if (goes_on && (!found || !out.reason.empty())) {
      from = &goal.start;
      found = solve(true);
    }
    if (!found || !out.reason.empty()) {
      out.converged = false;
      return out;
    }
    out.state = std::move(found->state);
    out.solution = {Unknowns::cracked, std::move(found->x)};
    from = &out.state;
    out.newton_iterations += found->iterations;
    out.reduced_iterations += found->iterations;
    out.residual = system.excess_residual(out.state);
    out.state.multipliers = system.multipliers();
    out.converged = true;
  } while (gap.is_carried_over(out));
  return out;
}

}  // namespace dda
