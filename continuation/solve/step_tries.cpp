#include "continuation/solve/step_tries.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "continuation/solve/contact_step.hpp"
#include "continuation/solve/reduced.hpp"
#include "continuation/solve/whole_step.hpp"

namespace dda {
namespace {

/// ‖R‖ over the force level: of all blocks where the step is audited, where their displacements are known
/// anyway, and where the points alone do not settle it.
double relative_residual(System& system, const StepGoal& goal, const Reduced& found, double tolerance) {
  const State& at = found.state;
  const double of_points = found.residual / system.least_force_level();
  if (!goal.is_audited && !at.d.are_all_known() && of_points <= tolerance) return of_points;
  std::vector<double> r(at.d.size());
  system.residual(at.d, at.load_factor, *system.laws_at(at), r);
  return system.relative(system.residual_norm(r), at.d);
}

/// A state found on the cracked points as the end of the step, if the full equations and the control have
/// nothing to add.
std::optional<Attempt> finished(System& system, const StepGoal& goal, const Reduced& found,
                                double tolerance) {
  if (system.iterates_multipliers()) return {};
  const State& at = found.state;
  const double miss = goal.control.residual(ControlPoint::at(at, *system.laws_at(at)), goal.step);
  if (!(std::abs(miss) <= control_tolerance)) return {};
  const double residual = relative_residual(system, goal, found, tolerance);
  if (!(residual <= tolerance)) return {};
  return Attempt{.converged = true,
                 .state = at,
                 .solution = {Unknowns::cracked, found.x},
                 .residual = residual,
                 .reason = {}};
}

}  // namespace

StepTries::StepTries(Stepper& stepper, const StepGoal& goal, Thoroughness thoroughness)
    : stepper_(stepper), system_(stepper.system()), goal_(goal), thoroughness_(thoroughness) {
  touches_ = system_.joins_by_contact();
  if (touches_) num_cracked_ = num_cracked(system_, goal.guess);
}

Attempt StepTries::find() {
  const NewtonParameters& newton = stepper_.parameters().newton;
  auto reduced = only_touches() ? std::nullopt : solve_reduced(stepper_, goal_);
  if (reduced && reduced->converged &&
      !(touches_ && strays(system_, reduced->state, goal_.start, goal_.guess)))
    if (auto whole = finished(system_, goal_, *reduced, newton.tolerance)) out_ = *std::move(whole);
  const int of_points = reduced ? reduced->iterations : 0;
  if (reduced && !reduced->converged) {
    reduced.reset();
    if (thoroughness_ == Thoroughness::quick && a_shorter_step_helps()) {
      out_ = {.state = goal_.guess,
              .newton_iterations = of_points,
              .reduced_iterations = of_points,
              .reason = "the points that crack found no equilibrium"};
      return std::move(out_);
    }
  }
  const bool contacts_first = touches_ && num_cracked_ <= few_cracked;
  if (contacts_first) by_contacts();
  by_all(reduced ? reduced->state : goal_.guess);
  // At a rupture the tangent is singular on the far side of the kink: only from this one can it be reached.
  if (reduced) by_all(goal_.guess);
  if (!contacts_first && (touches_ || are_few())) by_contacts();
  if (!out_.converged && touches_ && !of_contacts_.empty())
    out_.reason = fmt::format("{} (Newton's method: {})", of_contacts_, out_.reason);
  out_.newton_iterations += of_points;
  out_.reduced_iterations += of_points;
  return std::move(out_);
}

/// Whether nothing touches where the step begins, so that no contact has a say, and a shorter step is sure to help.
/// Redundant multipliers leave so many digits of the columns that the points alone may fail however short it is.
bool StepTries::a_shorter_step_helps() const {
  if (system_.equilibrium().num_unknown_multipliers() > 0) return false;
  const auto laws = system_.laws_at(goal_.start);
  for (std::size_t p = 0; p < laws->opening.size(); ++p)
    if (system_.history()[p].dissipated > 0 && laws->traction[p].x() < 0) return false;
  return !touches_;
}

bool StepTries::are_few() const {
  return num_changed(system_, goal_.guess) <= most_contacts(system_, thoroughness_);
}

void StepTries::by_contacts() {
  if (out_.converged) return;
  system_.set_multipliers(goal_.start.multipliers);
  Attempt found = contact_step(stepper_, goal_, thoroughness_);
  of_contacts_ = found.reason;
  if (found.converged || out_.reason.empty()) out_ = std::move(found);
}

void StepTries::by_all(const State& guess) {
  if (out_.converged) return;
  system_.set_multipliers(goal_.start.multipliers);
  out_ = whole_step(stepper_, {goal_.start, goal_.control, goal_.step, guess}, Method::newton);
}

}  // namespace dda
