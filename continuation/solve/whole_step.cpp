#include "continuation/solve/whole_step.hpp"

#include "continuation/solve/multiplier_gap.hpp"

namespace dda {

Attempt whole_step(Stepper& stepper, const StepGoal& goal, Method method) {
  System& system = stepper.system();
  const auto scope = system.timings().measure("LOCA");
  const StepperParameters& parameters = stepper.parameters();
  if (parameters.multipliers.predicted) system.set_multipliers(goal.guess.multipliers);
  Attempt out{.state = goal.guess, .reason = {}};
  MultiplierGap gap(system, parameters.multipliers);
  do {
    const auto aim =
        method == Method::line_search ? WholeEquations::Aim::improved : WholeEquations::Aim::quick;
    WholeEquations equations(system, goal.control, goal.step, parameters.newton, aim);
    Solved found = stepper.solve({equations, {out.state.d, out.state.load_factor}, goal.step, method});
    out.state = {std::move(found.x), found.load_factor, system.multipliers()};
    out.newton_iterations += found.iterations;
    out.residual = equations.relative_residual();
    out.converged = found.converged;
    out.reason = std::move(found.reason);
  } while (out.converged && gap.is_carried_over(out));
  return out;
}

}  // namespace dda
