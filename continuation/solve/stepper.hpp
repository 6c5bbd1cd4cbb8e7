#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "continuation/solve/equations/whole_equations.hpp"
#include "continuation/solve/loca.hpp"
#include "continuation/solve/step_goal.hpp"

namespace dda {

/// A solution of some equations, as LOCA's stepper may accept it.
struct Solution {
  Unknowns unknowns = Unknowns::whole;
  std::vector<double> x;  ///< of the cracked points; of the whole it is the state's d
};

/// What one attempt at a step gave.
struct Attempt {
  bool converged = false;
  State state;
  Solution solution = {};  ///< by which it was found
  int newton_iterations = 0;
  int reduced_iterations = 0;  ///< those among them on the cracked points alone
  double residual = 0;         ///< relative to the force level
  int multiplier_iterations = 0;
  double gap = 0;      ///< left by iterated multipliers, see System::relative_gap
  std::string reason;  ///< why it failed
};

/// When the multipliers of augmented Lagrangian joints are good, and where a step starts with them.
struct MultiplierParameters {
  double tolerance = 1e-8;  ///< relative gap, see System::relative_gap
  int max_iterations = 1000;
  bool predicted = true;  ///< start from the path's tangent; otherwise from the last step
};

/// What every attempt needs beside the system.
struct StepperParameters {
  NewtonParameters newton;
  MultiplierParameters multipliers;
  bool stability = true;  ///< count the negative eigenvalues of every equilibrium that is tried
};

/// Leaves a step that somebody does not want to wait for: the path stands where it stood.
struct BrokenOff {};

/// How much is tried before a step is given up.
enum class Thoroughness {
  quick,  ///< a shorter one is tried next: the cracked points alone, where only cracks open
  usual,  ///< no large dense problem
  full
};

/// Finds equilibria of a system with LOCA and NOX, and has LOCA take those that are the next points of the
/// path: one LOCA::Stepper for the steps that are settled on the cracked points alone, one for the others,
/// each made when it is first needed.
class Stepper {
 public:
  Stepper(System& system, StepperParameters parameters);

  System& system() { return system_; }
  const System& system() const { return system_; }
  const StepperParameters& parameters() const { return parameters_; }

  /// One solve by NOX, a try of LOCA's next step.
  Solved solve(const Solve& wanted);
  /// One step from an equilibrium to where the control holds: on the cracked points alone where that is all
  /// there is to solve, else on all unknowns.
  Attempt find(const StepGoal& goal, Thoroughness thoroughness = Thoroughness::usual);
  /// Has LOCA take a step to a solution.
  void accept(const Solution& solution, const State& state);
  /// Forgets LOCA's steppers, whose unknowns are those of before a growth.
  void begin_anew() { loca_ = {}; }
  /// Accepted steps, as LOCA counts them.
  int num_steps(Unknowns unknowns) const;
  /// Iterations of NOX since they were last taken.
  int take_iterations(Unknowns unknowns) { return std::exchange(iterations_[place(unknowns)], 0); }
  /// Asked before each attempt, which then throws BrokenOff, and while contact is searched for.
  void break_off_when(std::function<bool()> asked) { asked_ = std::move(asked); }
  bool is_broken_off() const { return asked_ && asked_(); }
  /// Where NOX and LOCA print what `path.newton.output` asks for, from the first solve on.
  void log_to(const std::filesystem::path& file) { log_ = file; }

 private:
  static std::size_t place(Unknowns unknowns) { return static_cast<std::size_t>(unknowns); }
  LocaStepper& loca(Unknowns unknowns);

  System& system_;
  StepperParameters parameters_;
  std::function<bool()> asked_;
  std::filesystem::path log_;
  std::array<std::unique_ptr<LocaStepper>, 2> loca_;
  std::array<int, 2> iterations_{};
};

}  // namespace dda
