#include "continuation/solve/contact_step.hpp"

#include <fmt/format.h>

#include <cmath>

#include "continuation/solve/contact_solver.hpp"
#include "continuation/solve/settling.hpp"

namespace dda {
namespace {

/// Why a state does not end a step; "" when it does.
std::string missed(System& system, const StepGoal& goal, const State& at, double tolerance) {
  const auto laws = system.laws_at(at.d, at.load_factor);
  const double miss = goal.control.residual({at.d, at.load_factor, *laws}, goal.step);
  const double residual = system.excess_residual(at);
  if (std::abs(miss) <= control_tolerance && residual <= tolerance) return {};
  if (residual <= tolerance) return fmt::format("the control was met to {:.1e} only", std::abs(miss));
  return fmt::format("contact and friction were met to {:.1e} only", residual);
}

}  // namespace

std::size_t most_contacts(const System& system, Thoroughness thoroughness) {
  if (system.joins_by_contact()) return 1500;
  return thoroughness == Thoroughness::full ? 600 : 200;
}

Attempt contact_step(System& system, const StepGoal& goal, const StepperParameters& parameters,
                     Thoroughness thoroughness) {
  Attempt out{.state = goal.guess, .reason = "contact and friction allow no equilibrium here"};
  if (!system.has_contacts()) return out;
  const double tolerance = parameters.newton.tolerance;
  if (parameters.multipliers.predicted) system.set_multipliers(goal.guess.multipliers);
  ContactSolver solver(system, goal.guess,
                       {.max_iterations = parameters.newton.max_iterations,
                        .most_points = most_contacts(system, thoroughness),
                        .tolerance = tolerance});
  const State* from = &goal.start;
  const auto solve = [&](bool tries_newton) {
    solver.try_newton(tries_newton);
    auto found = solver.solve({*from, goal.control, goal.step, out.state});
    if (found) out.reason = missed(system, goal, found->state, tolerance);
    return found;
  };
  Settling settling(parameters.multipliers);
  for (;; ++out.multiplier_iterations) {
    auto found = solve(true);
    if (!solver.has_walked() && (!found || !out.reason.empty())) found = solve(false);
    if (!found || !out.reason.empty()) return out;
    out.state = found->state;
    from = &out.state;
    out.reduced_iterations += found->iterations;
    out.residual = system.excess_residual(out.state);
    out.state.multipliers = system.multipliers();
    const auto laws = system.laws_at(out.state.d, out.state.load_factor);
    if (system.iterates_multipliers()) out.gap = system.relative_gap(*laws);
    out.converged = out.gap <= parameters.multipliers.tolerance;
    if (out.converged) return out;
    if (out.multiplier_iterations >= parameters.multipliers.max_iterations ||
        settling.is_out_of_reach(out.gap, system.active_set(*laws)))
      break;
    system.set_multipliers(system.next_multipliers(*laws));
  }
  out.reason = fmt::format("the multipliers did not settle in {} iterations (relative gap {:.1e})",
                           out.multiplier_iterations, out.gap);
  return out;
}

}  // namespace dda
