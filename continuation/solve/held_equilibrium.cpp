#include "continuation/solve/held_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "continuation/solve/contact_step.hpp"
#include "continuation/solve/equations/cracked_equations.hpp"
#include "continuation/solve/reduced.hpp"
#include "continuation/solve/whole_step.hpp"

namespace dda {

HeldEquilibrium::HeldEquilibrium(Stepper& stepper, const Functional& held, double value)
    : stepper_(stepper), held_(held), value_(value), control_(make_gauge_equation(held)) {
  const Equilibrium& equilibrium = stepper.system().equilibrium();
  only_touches_ = true;
  for (std::size_t p = 0; p < equilibrium.num_active() && only_touches_; ++p)
    only_touches_ = changes_by_contact_alone(equilibrium.point(p));
}

std::optional<State> HeldEquilibrium::solve(const State& at) {
  System& system = stepper_.system();
  const double now = at.value(held_);
  system.set_multipliers(at.multipliers);
  control_->start_at(ControlPoint::at(at, *system.laws_at(at)),
                     now == 0 && value_ == 0 ? 1 : std::max(std::abs(now), std::abs(value_)));
  const StepGoal goal{at, *control_, value_ - now, at};
  const auto by_contacts = [&] {
    system.set_multipliers(at.multipliers);
    return taken(contact_step(stepper_, goal, Thoroughness::full));
  };
  const bool walks_first = only_touches_ && system.has_contacts() && num_cracked(system, at) <= few_cracked;
  if (auto found = walks_first ? by_contacts() : std::nullopt) return found;
  system.set_multipliers(at.multipliers);
  auto found = taken(whole_step(stepper_, {at, *control_, goal.step, on_gauge(goal)}, Method::line_search));
  return found || walks_first || !system.has_contacts() ? found : by_contacts();
}

/// The guess, or where the gauge is met after one iteration in full: a line search weighs the residual alone.
State HeldEquilibrium::on_gauge(const StepGoal& goal) {
  if (goal.step == 0) return goal.guess;
  System& system = stepper_.system();
  WholeEquations equations(system, goal.control, goal.step,
                           {.tolerance = stepper_.parameters().newton.tolerance, .max_iterations = 1});
  Solved found = stepper_.solve({equations, {goal.guess.d, goal.guess.load_factor}, goal.step});
  iterations_ += found.iterations;
  return {std::move(found.x), found.load_factor, goal.guess.multipliers};
}

std::optional<State> HeldEquilibrium::taken(const Attempt& attempt) {
  iterations_ += attempt.newton_iterations;
  return attempt.converged ? std::optional(attempt.state) : std::nullopt;
}

}  // namespace dda
