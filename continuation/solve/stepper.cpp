#include "continuation/solve/stepper.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "continuation/solve/contact_step.hpp"
#include "continuation/solve/reduced.hpp"
#include "continuation/solve/settling.hpp"
#include "continuation/solve/trilinos_module.hpp"

namespace dda {
namespace {

/// Up to so many points that have cracked contacts are solved before Newton's method is tried on all
/// unknowns: their dense equations grow with the third power.
constexpr std::size_t few_points = 200;
/// Points that may take part in the end, where bodies touch that were never bonded, and elsewhere, where
/// Newton's method has failed on what cracks, slides and closes.
std::size_t most_points(const System& system, Thoroughness thoroughness) {
  if (system.joins_by_contact()) return 1500;
  return thoroughness == Thoroughness::full ? 600 : few_points;
}

/// A state as the end of the step, if the full equations and the control have nothing to add.
std::optional<Attempt> finished(System& system, const ControlEquation& control, double step, const State& at,
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

Attempt loca_step(System& system, const State& start, ControlEquation& control, double step,
                  const State& guess, const StepperParameters& parameters) {
  const auto scope = system.timings().measure("LOCA");
  return trilinos().controlled_step(system, start, control, step, guess, parameters);
}

/// Why a state does not end a step; "" when it does.
std::string missed(System& system, const ControlEquation& control, double step, const State& at,
                   double tolerance) {
  const auto laws = system.laws_at(at.d, at.load_factor);
  const double miss = control.residual({at.d, at.load_factor, *laws}, step);
  const double residual = system.excess_residual(at);
  if (std::abs(miss) <= control_tolerance && residual <= tolerance) return {};
  if (residual <= tolerance) return fmt::format("the control was met to {:.1e} only", std::abs(miss));
  return fmt::format("contact and friction were met to {:.1e} only", residual);
}

}  // namespace

Attempt contact_step(System& system, const State& start, const ControlEquation& control, double step,
                     const State& guess, const StepperParameters& parameters, Thoroughness thoroughness) {
  Attempt out{.state = guess, .reason = "contact and friction allow no equilibrium here"};
  if (!system.has_contacts()) return out;
  if (parameters.multipliers.predicted) system.set_multipliers(guess.multipliers);
  prepare_contacts(system, guess);
  ContactSettings settings{.max_iterations = parameters.newton.max_iterations,
                           .from = &start,
                           .most_points = most_points(system, thoroughness),
                           .tolerance = parameters.newton.tolerance};
  Settling settling(parameters.multipliers);
  std::optional<CrackedPoints> points;
  for (;; ++out.multiplier_iterations) {
    auto found = solve_contacts(system, control, step, out.state, settings, points);
    if (found) out.reason = missed(system, control, step, found->state, parameters.newton.tolerance);
    const bool walked = !settings.tries_newton || (points && points->only_touch());
    if (!walked && (!found || !out.reason.empty())) {
      settings.tries_newton = false;
      found = solve_contacts(system, control, step, out.state, settings, points);
      if (found) out.reason = missed(system, control, step, found->state, parameters.newton.tolerance);
      settings.tries_newton = true;
    }
    if (!found || !out.reason.empty()) return out;
    out.state = found->state;
    settings.from = &out.state;
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

Attempt controlled_step(System& system, const State& start, ControlEquation& control, double step,
                        const State& guess, const StepperParameters& parameters, Thoroughness thoroughness) {
  system.set_frozen(control.freezes_damage());
  system.set_multipliers(start.multipliers);
  control.start_at({start.d, start.load_factor, *system.laws_at(start.d, start.load_factor)}, std::abs(step));
  const bool touches = system.joins_by_contact();
  const std::size_t cracked = touches ? num_cracked(system, guess) : 0;
  const std::size_t most = most_points(system, thoroughness);
  const bool only_touches = touches && cracked == 0 && num_changed(system, guess) <= most;
  const auto reduced = only_touches
                           ? std::nullopt
                           : solve_reduced(system, control, step, guess, parameters.newton.max_iterations);
  const State& foreseen = reduced ? reduced->state : guess;
  Attempt out;
  if (const auto whole = finished(system, control, step, foreseen, parameters.newton)) out = *whole;
  const bool contacts_first = touches && cracked <= few_points;
  std::string of_contacts;
  if (!out.converged && contacts_first) {
    out = contact_step(system, start, control, step, guess, parameters, thoroughness);
    of_contacts = out.reason;
  }
  if (!out.converged) {
    system.set_multipliers(start.multipliers);
    out = loca_step(system, start, control, step, foreseen, parameters);
  }
  // At a rupture the tangent is singular on the far side of the kink: only from this one can it be reached.
  if (!out.converged && reduced) out = loca_step(system, start, control, step, guess, parameters);
  const auto is_walked = [&] { return touches || num_changed(system, guess) <= most; };
  if (!out.converged && !contacts_first && is_walked()) {
    system.set_multipliers(start.multipliers);
    const Attempt found = contact_step(system, start, control, step, guess, parameters, thoroughness);
    of_contacts = found.reason;
    if (found.converged) out = found;
  }
  if (!out.converged && touches && !of_contacts.empty())
    out.reason = fmt::format("{} (Newton's method: {})", of_contacts, out.reason);
  if (reduced) out.reduced_iterations += reduced->iterations;
  system.set_frozen(false);
  return out;
}

Attempt arc_length_step(System& system, const State& start, const ArcLength& arc,
                        const StepperParameters& parameters) {
  const auto scope = system.timings().measure("LOCA");
  return trilinos().arc_length_step(system, start, arc, parameters);
}

}  // namespace dda
