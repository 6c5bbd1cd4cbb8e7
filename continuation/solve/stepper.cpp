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
/// unknowns.
constexpr std::size_t few_points = 200;

/// A state as the end of the step, if the full equations and the control have nothing to add.
std::optional<Attempt> finished(System& system, const StepGoal& goal, const State& at, double tolerance) {
  if (system.iterates_multipliers()) return {};
  const auto laws = system.laws_at(at.d, at.load_factor);
  const double miss = goal.control.residual({at.d, at.load_factor, *laws}, goal.step);
  if (!(std::abs(miss) <= control_tolerance)) return {};
  std::vector<double> r(at.d.size());
  system.residual(at.d, at.load_factor, *laws, r);
  const double residual = system.relative(system.residual_norm(r), at.d);
  if (!(residual <= tolerance)) return {};
  return Attempt{.converged = true, .state = at, .residual = residual, .reason = {}};
}

/// A step on all unknowns, as LOCA finds it from a guess.
Attempt loca_step(System& system, const StepGoal& goal, const State& guess,
                  const StepperParameters& parameters) {
  const auto scope = system.timings().measure("LOCA");
  return trilinos().controlled_step(system, {goal.start, goal.control, goal.step, guess}, parameters);
}

/// Damage frozen for one step, however it ends.
class FrozenDamage {
 public:
  FrozenDamage(System& system, bool is_frozen) : system_(system) { system.set_frozen(is_frozen); }
  FrozenDamage(const FrozenDamage&) = delete;
  FrozenDamage& operator=(const FrozenDamage&) = delete;
  ~FrozenDamage() { system_.set_frozen(false); }

 private:
  System& system_;
};

/// Tries the ways to the end of one step: the cracked points alone, contact and friction solved exactly, all
/// unknowns. What the first finds is only where the others begin.
class StepTries {
 public:
  StepTries(System& system, const StepGoal& goal, const StepperParameters& parameters,
            Thoroughness thoroughness)
      : system_(system), goal_(goal), parameters_(parameters), thoroughness_(thoroughness) {
    touches_ = system.joins_by_contact();
    if (touches_) num_cracked_ = num_cracked(system, goal.guess);
  }

  Attempt find() {
    const auto reduced =
        only_touches() ? std::nullopt : solve_reduced(system_, goal_, parameters_.newton.max_iterations);
    const State& foreseen = reduced ? reduced->state : goal_.guess;
    if (auto whole = finished(system_, goal_, foreseen, parameters_.newton.tolerance))
      out_ = *std::move(whole);
    const bool contacts_first = touches_ && num_cracked_ <= few_points;
    if (contacts_first) by_contacts();
    by_loca(foreseen);
    // At a rupture the tangent is singular on the far side of the kink: only from this one can it be reached.
    if (reduced) by_loca(goal_.guess);
    if (!contacts_first && (touches_ || are_few())) by_contacts();
    if (!out_.converged && touches_ && !of_contacts_.empty())
      out_.reason = fmt::format("{} (Newton's method: {})", of_contacts_, out_.reason);
    if (reduced) out_.reduced_iterations += reduced->iterations;
    return std::move(out_);
  }

 private:
  bool are_few() const { return num_changed(system_, goal_.guess) <= most_contacts(system_, thoroughness_); }
  bool only_touches() const { return touches_ && num_cracked_ == 0 && are_few(); }

  void by_contacts() {
    if (out_.converged) return;
    system_.set_multipliers(goal_.start.multipliers);
    Attempt found = contact_step(system_, goal_, parameters_, thoroughness_);
    of_contacts_ = found.reason;
    if (found.converged || out_.reason.empty()) out_ = std::move(found);
  }

  void by_loca(const State& guess) {
    if (out_.converged) return;
    system_.set_multipliers(goal_.start.multipliers);
    out_ = loca_step(system_, goal_, guess, parameters_);
  }

  System& system_;
  const StepGoal& goal_;
  const StepperParameters& parameters_;
  Thoroughness thoroughness_;
  bool touches_ = false;
  std::size_t num_cracked_ = 0;
  Attempt out_;
  std::string of_contacts_;
};

}  // namespace

Attempt controlled_step(System& system, const StepGoal& goal, const StepperParameters& parameters,
                        Thoroughness thoroughness) {
  const State& start = goal.start;
  const FrozenDamage frozen(system, goal.control.freezes_damage());
  system.set_multipliers(start.multipliers);
  goal.control.start_at({start.d, start.load_factor, *system.laws_at(start.d, start.load_factor)},
                        std::abs(goal.step));
  return StepTries(system, goal, parameters, thoroughness).find();
}

Attempt arc_length_step(System& system, const State& start, const ArcLength& arc,
                        const StepperParameters& parameters) {
  const auto scope = system.timings().measure("LOCA");
  return trilinos().arc_length_step(system, start, arc, parameters);
}

}  // namespace dda
