#include "continuation/solve/stepper.hpp"

#include "continuation/solve/step_tries.hpp"

namespace dda {
namespace {

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

/// Its name in NOX's lists.
std::string line_search_of(const NewtonParameters& newton) {
  if (newton.line_search == LineSearch::full_step) return "Full Step";
  return newton.line_search == LineSearch::backtrack ? "Backtrack" : "Polynomial";
}

}  // namespace

Stepper::Stepper(System& system, StepperParameters parameters)
    : system_(system), parameters_(std::move(parameters)) {}

LocaStepper& Stepper::loca(Unknowns unknowns) {
  auto& kept = loca_[place(unknowns)];
  if (!kept)
    kept = make_loca_stepper({.line_search = line_search_of(parameters_.newton),
                              .reduction = parameters_.newton.reduction.value_or(0.5),
                              .output = parameters_.newton.output,
                              .log = log_});
  return *kept;
}

Solved Stepper::solve(const Solve& wanted) {
  const Unknowns unknowns = wanted.equations.unknowns();
  Solved out = loca(unknowns).solve(wanted);
  iterations_[place(unknowns)] += out.iterations;
  return out;
}

void Stepper::accept(const Solution& solution, const State& state) {
  const std::vector<double>& x = solution.unknowns == Unknowns::whole ? state.d.all() : solution.x;
  loca(solution.unknowns).accept({x, state.load_factor});
}

int Stepper::num_steps(Unknowns unknowns) const {
  const auto& kept = loca_[place(unknowns)];
  return kept ? kept->num_steps() : 0;
}

Attempt Stepper::find(const StepGoal& goal, Thoroughness thoroughness) {
  if (is_broken_off()) throw BrokenOff{};
  const State& start = goal.start;
  const FrozenDamage frozen(system_, goal.control.freezes_damage());
  system_.set_multipliers(start.multipliers);
  goal.control.start_at(ControlPoint::at(start, *system_.laws_at(start)), std::abs(goal.step));
  return StepTries(*this, goal, thoroughness).find();
}

}  // namespace dda
