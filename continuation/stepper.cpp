#include "continuation/stepper.hpp"

#include <cmath>
#include <optional>

#include "continuation/reduced.hpp"
#include "continuation/trilinos_module.hpp"

namespace dda {
namespace {

/// A state as the end of the step, if the full equations and the control have nothing to add.
std::optional<Attempt> finished(System& system, const Control& control, double step, const State& at,
                                const NewtonParameters& newton) {
  if (system.iterates_multipliers()) return {};
  const auto laws = system.laws_at(at.d, at.load_factor);
  if (!(std::abs(control.residual({at.d, at.load_factor, *laws}, step)) <= control_tolerance)) return {};
  std::vector<double> r(at.d.size());
  system.residual(at.d, at.load_factor, *laws, r);
  const double residual = system.relative(system.residual_norm(r), at.d);
  if (!(residual <= newton.tolerance)) return {};
  return Attempt{.converged = true, .state = at, .residual = residual, .reason = {}};
}

Attempt loca_step(System& system, const State& start, Control& control, double step, const State& guess,
                  const StepperParameters& parameters) {
  const auto scope = system.timings().measure("LOCA");
  return trilinos().controlled_step(system, start, control, step, guess, parameters);
}

}  // namespace

Attempt controlled_step(System& system, const State& start, Control& control, double step, const State& guess,
                        const StepperParameters& parameters) {
  system.set_frozen(control.freezes_damage());
  system.set_multipliers(start.multipliers);
  control.start_at({start.d, start.load_factor, *system.laws_at(start.d, start.load_factor)}, std::abs(step));
  const auto reduced = solve_reduced(system, control, step, guess, parameters.newton.max_iterations);
  const State& foreseen = reduced ? reduced->state : guess;
  Attempt out;
  if (const auto whole = finished(system, control, step, foreseen, parameters.newton))
    out = *whole;
  else
    out = loca_step(system, start, control, step, foreseen, parameters);
  // At a rupture the tangent is singular on the far side of the kink: only from this one can it be reached.
  if (!out.converged && reduced) out = loca_step(system, start, control, step, guess, parameters);
  if (reduced) out.reduced_iterations = reduced->iterations;
  system.set_frozen(false);
  return out;
}

Attempt arc_length_step(System& system, const State& start, const ArcLength& arc,
                        const StepperParameters& parameters) {
  const auto scope = system.timings().measure("LOCA");
  return trilinos().arc_length_step(system, start, arc, parameters);
}

}  // namespace dda
